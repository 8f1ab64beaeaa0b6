//! Derivatives against finite differences and against derivatives written by hand.

#[path = "../../benches/stage/by_hand.rs"]
mod by_hand;
#[path = "../../benches/stage/step.rs"]
mod step;

use crate::support::{check_derivatives, evaluate};
use autodiff::{Expression, Tape};

fn rotation<'tape>(q: &[Expression<'tape>]) -> Vec<Expression<'tape>> {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    vec![
        w * w + x * x - y * y - z * z,
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        w * w - x * x + y * y - z * z,
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        w * w - x * x - y * y + z * z,
    ]
}

fn normalised<'tape>(q: &[Expression<'tape>]) -> Vec<Expression<'tape>> {
    let norm = (q[0].square() + q[1].square() + q[2].square() + q[3].square()).sqrt();
    (0..4).map(|component| q[component] / norm).collect()
}

fn quaternion_product<'tape>(x: &[Expression<'tape>]) -> Vec<Expression<'tape>> {
    let [a, b, c, d, e, f, g, h] = std::array::from_fn(|index| x[index]);
    vec![
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

const POINT: [f64; 8] = [0.9, -0.2, 0.4, 0.3, 1.2, 0.7, -0.5, 0.8];

#[test]
fn quaternions_agree_with_differences() {
    check_derivatives(&Tape::record(8, quaternion_product), 8, &POINT).unwrap();
    check_derivatives(&Tape::record(4, rotation), 4, &POINT[..4]).unwrap();
    check_derivatives(&Tape::record(4, normalised), 4, &POINT[..4]).unwrap();
    check_derivatives(&Tape::record(4, |q| rotation(&normalised(q))), 4, &POINT[..4]).unwrap();
}

#[test]
fn every_operation_agrees_with_differences() {
    let tape = Tape::record(4, |x| {
        let mut changing = x[0];
        changing += x[1];
        changing *= 2.0;
        changing -= x[2];
        changing /= x[3];
        vec![
            x[0] / x[1] + 3.0 / x[2] - x[3] / 7.0,
            x[0].square().sqrt() * x[3].sqrt(),
            (x[0] * x[1]).sin() + (x[2] - x[3]).cos(),
            (x[0] * 0.3 - x[1]).exp() * x[3].ln(),
            x[1].recip() - -x[2] * 4.0 + (1.0 - x[0]),
            x[0].powi(3) + x[1].powi(-2) + x[2].powi(0) + x[3].powi(1),
            changing,
        ]
    });
    check_derivatives(&tape, 4, &[0.9, -1.2, 0.4, 1.3]).unwrap();
}

#[test]
fn parameters_are_not_differentiated() {
    let tape = Tape::record(4, |x| vec![x[0] * x[2] * x[3] + x[1].square() * x[3]]);
    check_derivatives(&tape, 2, &POINT[..4]).unwrap();
    let jacobian = tape.jacobian(2);
    assert_eq!(jacobian.columns, [0, 1]);
    let hessian = tape.lagrangian_hessian(2);
    assert_eq!((hessian.rows, hessian.columns), (vec![1], vec![1]));
}

/// `gap = distance + dt normal' v` and its product with a force: the adjoint by the contact information is the seed
/// for its second derivatives.
#[test]
fn external_inputs_have_adjoints_and_second_derivatives() {
    let tape = Tape::record(4, |x| {
        let [velocity, force, distance, normal] = [x[0], x[1], x[2], x[3]];
        vec![(distance + normal * velocity * 0.5) * force]
    });
    let hessian = tape.lagrangian_hessian(4);
    let inputs = [3.0, 5.0, 0.25, 2.0, 10.0];
    assert_eq!(evaluate(hessian.adjoint(), &inputs), [50.0, 32.5, 50.0, 75.0]);
    assert_eq!((hessian.rows.as_slice(), hessian.columns.as_slice()), (&[1, 2, 3, 3][..], &[0, 1, 0, 1][..]));
    assert_eq!(evaluate(hessian.tape(), &inputs), [10.0, 10.0, 25.0, 15.0]);
}

#[test]
fn normalisation_agrees_with_the_projection() {
    let jacobian = Tape::record(4, normalised).jacobian(4);
    let q = [0.9, -0.2, 0.4, 0.3];
    let norm = q.iter().map(|value| value * value).sum::<f64>().sqrt();
    let values = evaluate(jacobian.tape(), &q);
    for ((&row, &column), value) in jacobian.rows.iter().zip(&jacobian.columns).zip(values) {
        let identity = if row == column { 1.0 } else { 0.0 };
        let expected = (identity - q[row] * q[column] / (norm * norm)) / norm;
        assert!((value - expected).abs() < 1e-15, "({row}, {column}): {value}, by hand {expected}");
    }
}

#[test]
fn the_step_agrees_with_derivatives_by_hand() {
    let tape = Tape::record(step::INPUTS, |x| step::step(x).to_vec());
    let (jacobian, hessian) = (tape.jacobian(step::INPUTS), tape.lagrangian_hessian(step::INPUTS));
    for number in 0..5 {
        let point = step::sample(number);
        assert_eq!(evaluate(&tape, &point), step::step(&point[..step::INPUTS]));
        let mut expected = [0.0; by_hand::JACOBIAN_NONZEROS];
        by_hand::jacobian(&point, &mut expected);
        compare(&evaluate(jacobian.tape(), &point), &expected);
        let mut expected = [0.0; by_hand::HESSIAN_NONZEROS];
        by_hand::hessian(&point, &mut expected);
        compare(&evaluate(hessian.tape(), &point), &expected);
    }
    check_derivatives(&tape, step::INPUTS, &step::sample(3)[..step::INPUTS]).unwrap();
}

fn compare(values: &[f64], expected: &[f64]) {
    assert_eq!(values.len(), expected.len());
    for (entry, (value, expected)) in values.iter().zip(expected).enumerate() {
        assert!((value - expected).abs() < 1e-14, "nonzero {entry}: {value}, by hand {expected}");
    }
}

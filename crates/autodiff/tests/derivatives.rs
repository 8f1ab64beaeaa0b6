//! Values and derivatives against direct evaluation and finite differences.

use autodiff::{Batch, Expression, Instructions, Tape, Workspace};
use proptest::prelude::*;

fn evaluate(tape: &Tape, inputs: &[f64]) -> Vec<f64> {
    let mut batch = Batch::new(inputs.len(), 1);
    for (row, value) in inputs.iter().enumerate() {
        batch.row_mut(row)[0] = *value;
    }
    let mut outputs = Batch::new(tape.output_count(), 1);
    tape.evaluate(&batch, &mut outputs, &mut Workspace::default());
    (0..tape.output_count()).map(|row| outputs.row(row)[0]).collect()
}

/// Rotation of a fixed vector by a normalised quaternion: products, sums, square root and quotients.
fn rotated<'tape>(q: &[Expression<'tape>]) -> Vec<Expression<'tape>> {
    let norm = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    let [w, x, y, z] = [q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm];
    vec![
        w * w + x * x - y * y - z * z + (x * y - w * z) * 2.0,
        (x * y + w * z) * 2.0 + (w * w - x * x + y * y - z * z),
        2.0 * (x * z - w * y) - -(y * z + w * x) * 2.0,
    ]
}

#[test]
fn jacobian_agrees_with_differences() {
    let tape = Tape::record(4, rotated);
    let jacobian = tape.jacobian(4);
    let point = [0.9, -0.2, 0.4, 0.3];
    let values = evaluate(jacobian.tape(), &point);
    let step = 1e-6;
    assert_eq!(values.len(), 12);
    for ((&row, &column), value) in jacobian.rows.iter().zip(&jacobian.columns).zip(values) {
        let (mut ahead, mut behind) = (point, point);
        ahead[column] += step;
        behind[column] -= step;
        let difference = (evaluate(&tape, &ahead)[row] - evaluate(&tape, &behind)[row]) / (2.0 * step);
        assert!((value - difference).abs() < 1e-8, "({row}, {column}): {value} and {difference}");
        assert_ne!(value, difference);
    }
}

#[test]
fn hessian_agrees_with_differences_of_the_adjoint() {
    let tape = Tape::record(4, rotated);
    let hessian = tape.lagrangian_hessian(4);
    let point = [0.9, -0.2, 0.4, 0.3, 1.5, -0.7, 0.2];
    let values = evaluate(hessian.tape(), &point);
    let step = 1e-6;
    assert_eq!(values.len(), 10);
    for ((&row, &column), value) in hessian.rows.iter().zip(&hessian.columns).zip(values) {
        let (mut ahead, mut behind) = (point, point);
        ahead[column] += step;
        behind[column] -= step;
        let adjoint = |inputs: &[f64]| evaluate(hessian.adjoint(), inputs)[row];
        let difference = (adjoint(&ahead) - adjoint(&behind)) / (2.0 * step);
        assert!((value - difference).abs() < 1e-8, "({row}, {column}): {value} and {difference}");
    }
}

#[test]
fn sparsity_is_exact() {
    let tape = Tape::record(4, |x| vec![x[0] * x[1] + x[2], x[3] * 3.0, x[0] - x[0], x[1] * 0.0]);
    let jacobian = tape.jacobian(3);
    assert_eq!((jacobian.rows, jacobian.columns), (vec![0, 0, 0], vec![0, 1, 2]));
    let hessian = tape.lagrangian_hessian(4);
    assert_eq!((hessian.rows, hessian.columns), (vec![1], vec![0]));
}

#[test]
fn equal_subexpressions_are_recorded_once() {
    let tape = Tape::record(2, |x| vec![x[0] * x[1] + 1.0, x[1] * x[0] + 2.0]);
    assert_eq!(tape.operation_count(), 3);
}

#[test]
fn inputs_constants_and_repeated_outputs() {
    let tape = Tape::record(2, |x| vec![x[1], x[0].constant(4.0), x[1], x[0] + x[1]]);
    assert_eq!(evaluate(&tape, &[2.0, 3.0]), [3.0, 4.0, 3.0, 5.0]);
    let empty = Tape::record(1, |_| Vec::new());
    assert!(evaluate(&empty, &[1.0]).is_empty());
}

#[test]
fn every_number_of_points_and_instruction_set_gives_the_same_bits() {
    let tape = Tape::record(4, rotated);
    let jacobian = tape.jacobian(4);
    for points in [0, 1, 7, 8, 9, 16, 17, 65] {
        let mut inputs = Batch::new(4, points);
        for row in 0..4 {
            for (point, value) in inputs.row_mut(row).iter_mut().enumerate() {
                *value = 1.0 + ((row + 1) * (point + 3)) as f64 * 0.37 % 1.0;
            }
        }
        let (mut fast, mut plain) = (Batch::new(12, points), Batch::new(12, points));
        let mut workspace = Workspace::default();
        jacobian.tape().evaluate_with(Instructions::best(), &inputs, &mut fast, &mut workspace);
        jacobian.tape().evaluate_with(Instructions::scalar(), &inputs, &mut plain, &mut workspace);
        for row in 0..12 {
            assert_eq!(fast.row(row), plain.row(row));
            for point in 0..points {
                let one: Vec<f64> = (0..4).map(|input| inputs.row(input)[point]).collect();
                assert_eq!(fast.row(row)[point], evaluate(jacobian.tape(), &one)[row]);
            }
        }
    }
}

/// A random arithmetic program: every step combines two earlier results.
fn run<T: Copy>(steps: &[(u8, usize, usize)], inputs: &[T], apply: impl Fn(u8, T, T) -> T) -> T {
    let mut results = inputs.to_vec();
    for &(operation, one, other) in steps {
        let (a, b) = (results[one % results.len()], results[other % results.len()]);
        results.push(apply(operation, a, b));
    }
    results[results.len() - 1]
}

proptest! {
    #[test]
    fn random_programs_agree_with_plain_arithmetic(
        steps in prop::collection::vec((0..4u8, 0..100usize, 0..100usize), 1..20),
        inputs in prop::array::uniform3(0.5..2.0f64),
    ) {
        let tape = Tape::record(3, |x| vec![run(&steps, x, |operation, a, b| match operation {
            0 => a + b,
            1 => a - b,
            2 => a * b,
            _ => a / (b * b + 1.0),
        })]);
        let expected = run(&steps, &inputs, |operation, a, b| match operation {
            0 => a + b,
            1 => a - b,
            2 => a * b,
            _ => a / (b * b + 1.0),
        });
        let value = evaluate(&tape, &inputs)[0];
        prop_assume!(expected.is_finite() && expected.abs() < 1e6);
        prop_assert!((value - expected).abs() <= 1e-9 * expected.abs().max(1.0));
    }
}

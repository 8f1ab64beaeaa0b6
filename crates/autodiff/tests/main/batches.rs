//! Evaluation at many points.

use crate::support::{batch, evaluate};
use autodiff::{Batch, Instructions, Tape, Workspace};

fn every_kernel() -> Tape {
    Tape::record(3, |x| {
        let [a, b, c] = [x[0], x[1], x[2]];
        vec![
            a * b + c,
            a * b - c,
            c - a * b * 0.1,
            (a + b) / c,
            -(a - c).sqrt().sin(),
            (b.cos() - a.exp()) * c.ln(),
            (a * b + c * a).square() / (b - c),
            a,
        ]
    })
}

fn points(count: usize) -> Vec<Vec<f64>> {
    (0..count).map(|point| (0..3).map(|row| 1.0 + ((row + 1) * (point + 3)) as f64 * 0.37 % 1.0).collect()).collect()
}

#[test]
fn every_number_of_points_and_instruction_set_gives_the_same_bits() {
    let tape = every_kernel();
    let jacobian = tape.jacobian(3);
    let mut workspace = Workspace::default();
    for count in [0, 1, 7, 8, 9, 63, 64, 65, 129] {
        let points = points(count);
        let inputs = batch(&points);
        for tape in [&tape, jacobian.tape()] {
            for instructions in Instructions::available() {
                let mut outputs = Batch::new(tape.output_count(), count);
                if count > 0 {
                    tape.evaluate_with(instructions, &inputs, &mut outputs, &mut workspace);
                }
                for (point, inputs) in points.iter().enumerate() {
                    for (row, expected) in evaluate(tape, inputs).into_iter().enumerate() {
                        let value = outputs.row(row)[point];
                        assert_eq!(value.to_bits(), expected.to_bits(), "{instructions:?}: {row}, {point}");
                    }
                }
            }
        }
    }
}

#[test]
fn no_points() {
    let tape = every_kernel();
    let mut outputs = Batch::new(8, 0);
    tape.evaluate(&Batch::new(3, 0), &mut outputs, &mut Workspace::default());
    assert!(outputs.row(7).is_empty());
}

#[test]
fn values_are_those_of_plain_arithmetic() {
    let points = points(70);
    let tape = every_kernel();
    for point in &points {
        let [a, b, c] = [point[0], point[1], point[2]];
        let expected = [
            a * b + c,
            a * b - c,
            c - a * b * 0.1,
            (a + b) / c,
            -(a - c).sqrt().sin(),
            (b.cos() - a.exp()) * c.ln(),
            (a * b + c * a) * (a * b + c * a) / (b - c),
            a,
        ];
        let values = evaluate(&tape, point);
        for (value, expected) in values.iter().zip(expected) {
            assert!(*value == expected || value.is_nan() && expected.is_nan(), "{value}, by hand {expected}");
        }
    }
}

#[test]
fn more_rows_than_needed_are_left_alone() {
    let tape = Tape::record(1, |x| vec![x[0] + 1.0]);
    let inputs = batch(&[vec![1.0, 9.0], vec![2.0, 9.0]]);
    let mut outputs = Batch::new(2, 2);
    outputs.row_mut(1).fill(7.0);
    tape.evaluate(&inputs, &mut outputs, &mut Workspace::default());
    assert_eq!((outputs.row(0), outputs.row(1)), (&[2.0, 3.0][..], &[7.0, 7.0][..]));
}

#[test]
fn batches_are_equal_when_their_points_are() {
    let tape = Tape::record(1, |x| vec![x[0] / 2.0]);
    let (mut outputs, mut expected) = (Batch::new(1, 3), Batch::new(1, 3));
    tape.evaluate(&batch(&[vec![2.0], vec![4.0], vec![6.0]]), &mut outputs, &mut Workspace::default());
    expected.row_mut(0).copy_from_slice(&[1.0, 2.0, 3.0]);
    assert_eq!(outputs, expected);
}

#[test]
#[should_panic(expected = "different numbers of points")]
fn numbers_of_points_must_agree() {
    let tape = Tape::record(1, |x| vec![x[0]]);
    tape.evaluate(&Batch::new(1, 2), &mut Batch::new(1, 3), &mut Workspace::default());
}

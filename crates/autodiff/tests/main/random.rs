//! Random programs against plain arithmetic, with derivatives against differences.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::support::{batch, check_derivatives, evaluate};
use autodiff::{Batch, Expression, Instructions, Tape, Workspace};
use proptest::prelude::*;

/// Arithmetic of random programs.
trait Number:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    fn sqrt(self) -> Self;
    fn sin(self) -> Self;
}

impl Number for f64 {
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn sin(self) -> Self {
        self.sin()
    }
}

impl Number for Expression<'_> {
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn sin(self) -> Self {
        self.sin()
    }
}

type Step = (u8, usize, usize, i8);

/// All results of a program in which every step combines two earlier results. Denominators and arguments of roots are
/// bounded away from 0.
fn run<T: Number>(steps: &[Step], inputs: &[T]) -> Vec<T> {
    let mut results = inputs.to_vec();
    for &(operation, one, other, factor) in steps {
        let (a, b) = (results[one % results.len()], results[other % results.len()]);
        results.push(match operation {
            0 => a + b,
            1 => a - b,
            2 => a * b,
            3 => a / (b * b + 1.0),
            4 => (a * a + 0.5).sqrt(),
            5 => a.sin(),
            6 => -a,
            _ => a * (f64::from(factor) * 0.5),
        });
    }
    results
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    prop::collection::vec((0..8u8, 0..100usize, 0..100usize, -4..5i8), 1..25)
}

fn record(steps: &[Step]) -> Tape {
    Tape::record(3, |x| run(steps, x).split_off(3))
}

proptest! {
    #[test]
    fn values_are_those_of_plain_arithmetic(steps in steps(), inputs in prop::array::uniform3(0.5..2.0f64)) {
        let expected = run(&steps, &inputs).split_off(3);
        prop_assume!(expected.iter().all(|value| value.abs() < 1e100));
        prop_assume!(expected.iter().all(|&value| value == 0.0 || value.abs() > 1e-100));
        prop_assert_eq!(evaluate(&record(&steps), &inputs), expected);
    }

    #[test]
    fn derivatives_agree_with_differences(steps in steps(), inputs in prop::array::uniform3(0.5..2.0f64)) {
        prop_assume!(run(&steps, &inputs).iter().all(|value| value.abs() < 10.0));
        check_derivatives(&record(&steps), 3, &inputs).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn instruction_sets_give_the_same_bits(steps in steps(), seed in 0.5..1.0f64, count in 1..140usize) {
        let hessian = record(&steps).lagrangian_hessian(3);
        let tape = hessian.tape();
        let points: Vec<Vec<f64>> = (0..count)
            .map(|point| (0..tape.input_count()).map(|row| 0.5 + (seed * (point * 31 + row) as f64).fract()).collect())
            .collect();
        let evaluated: Vec<Vec<u64>> = Instructions::available()
            .into_iter()
            .map(|instructions| {
                let mut outputs = Batch::new(tape.output_count(), count);
                tape.evaluate_with(instructions, &batch(&points), &mut outputs, &mut Workspace::default());
                (0..tape.output_count()).flat_map(|row| outputs.row(row).iter().map(|value| value.to_bits()).collect::<Vec<_>>()).collect()
            })
            .collect();
        prop_assert!(evaluated.iter().all(|bits| *bits == evaluated[0]));
    }
}

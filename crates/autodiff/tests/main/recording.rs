//! Recording: shared subexpressions, exact sparsity, unusual outputs.

use crate::support::{check_derivatives, evaluate};
use autodiff::{Expression, Tape};

#[test]
fn sparsity_is_exact() {
    let tape = Tape::record(4, |x| vec![x[0] * x[1] + x[2], x[3] * 3.0, x[0] - x[0], x[1] * 0.0]);
    let jacobian = tape.jacobian(3);
    assert_eq!((jacobian.rows, jacobian.columns), (vec![0, 0, 0], vec![0, 1, 2]));
    let hessian = tape.lagrangian_hessian(4);
    assert_eq!((hessian.rows, hessian.columns), (vec![1], vec![0]));
}

#[test]
fn derivatives_that_cancel_are_absent() {
    let tape = Tape::record(3, |x| {
        vec![(x[0] + x[1]) - x[0], (x[0] * x[1] + x[2]) - x[1] * x[0], (x[0] + x[1]).square() - 2.0 * (x[0] * x[1])]
    });
    let jacobian = tape.jacobian(3);
    assert_eq!((jacobian.rows, jacobian.columns), (vec![0, 1, 2, 2], vec![1, 2, 0, 1]));
    // 2 m - 2 m off the diagonal.
    let hessian = tape.lagrangian_hessian(3);
    assert_eq!((hessian.rows, hessian.columns), (vec![0, 1], vec![0, 1]));
}

#[test]
fn derivatives_of_linear_functions_cost_nothing() {
    let tape = Tape::record(3, |x| vec![x[0] * 2.0 - x[1] / 4.0 + 1.0, -x[2], x[0] + x[0]]);
    let jacobian = tape.jacobian(3);
    assert_eq!(jacobian.tape().operation_count(), 0);
    assert_eq!(evaluate(jacobian.tape(), &[0.0; 3]), [2.0, -0.25, -1.0, 2.0]);
    assert_eq!(tape.lagrangian_hessian(3).rows.len(), 0);
}

#[test]
fn equal_subexpressions_are_recorded_once() {
    let count = |function: for<'tape> fn(&[Expression<'tape>]) -> Vec<Expression<'tape>>| {
        Tape::record(2, function).operation_count()
    };
    assert_eq!(count(|x| vec![x[0] * x[1] + 1.0, x[1] * x[0] + 2.0]), 3);
    assert_eq!(count(|x| vec![x[0] - -x[1], x[1] + x[0]]), 1);
    assert_eq!(count(|x| vec![-(x[0] - x[1]), x[1] - x[0]]), 1);
    assert_eq!(count(|x| vec![2.0 * (x[0] * 3.0), x[0] * 6.0]), 1);
    assert_eq!(count(|x| vec![(x[0] * 1.0 + 0.0) / 1.0 - 0.0, x[0].powi(1)]), 0);
}

#[test]
fn dead_code_is_not_evaluated() {
    let tape = Tape::record(2, |x| {
        let _ = x[0].sqrt() * x[1];
        vec![x[0] + x[1]]
    });
    assert_eq!(tape.operation_count(), 1);
}

#[test]
fn inputs_constants_and_repeated_outputs() {
    let tape = Tape::record(2, |x| {
        let product = x[0] * x[1];
        vec![x[1], x[0].constant(4.0), x[1], x[0] + x[1], product, product + 1.0, product]
    });
    assert_eq!(evaluate(&tape, &[2.0, 3.0]), [3.0, 4.0, 3.0, 5.0, 6.0, 7.0, 6.0]);
    let jacobian = tape.jacobian(2);
    assert_eq!(jacobian.rows, [0, 2, 3, 3, 4, 4, 5, 5, 6, 6]);
    assert_eq!(evaluate(jacobian.tape(), &[2.0, 3.0]), [1.0, 1.0, 1.0, 1.0, 3.0, 2.0, 3.0, 2.0, 3.0, 2.0]);
    check_derivatives(&tape, 2, &[2.0, 3.0]).unwrap();
}

#[test]
fn a_tape_may_have_no_outputs_or_no_inputs() {
    let empty = Tape::record(1, |_| Vec::new());
    assert!(evaluate(&empty, &[1.0]).is_empty());
    assert!(empty.jacobian(1).rows.is_empty());
    assert_eq!(evaluate(empty.lagrangian_hessian(1).adjoint(), &[1.0]), [0.0]);
    let nothing = Tape::record(0, |_| Vec::new());
    assert_eq!((nothing.input_count(), nothing.output_count()), (0, 0));
    assert!(nothing.lagrangian_hessian(0).rows.is_empty());
}

#[test]
fn division_by_zero_is_not_a_number_or_infinite() {
    let tape = Tape::record(2, |x| vec![x[0] / x[1], (x[0] - 2.0).sqrt()]);
    let values = evaluate(&tape, &[1.0, 0.0]);
    assert!(values[0].is_infinite() && values[1].is_nan());
    assert!(evaluate(&tape, &[0.0, 0.0])[0].is_nan());
}

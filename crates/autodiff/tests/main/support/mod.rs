//! Evaluation at single points, and the derivative checker of all tests.

use autodiff::{Batch, Tape, Workspace};

/// Inputs of many points, each a slice.
pub fn batch(points: &[Vec<f64>]) -> Batch {
    let mut batch = Batch::new(points.first().map_or(0, Vec::len), points.len());
    for (column, point) in points.iter().enumerate() {
        for (row, value) in point.iter().enumerate() {
            batch.row_mut(row)[column] = *value;
        }
    }
    batch
}

/// Outputs at one point.
pub fn evaluate(tape: &Tape, inputs: &[f64]) -> Vec<f64> {
    let mut outputs = Batch::new(tape.output_count(), 1);
    tape.evaluate(&batch(&[inputs.to_vec()]), &mut outputs, &mut Workspace::default());
    (0..tape.output_count()).map(|row| outputs.row(row)[0]).collect()
}

/// Sparse values as a dense matrix of rows.
fn dense(size: (usize, usize), rows: &[usize], columns: &[usize], values: &[f64]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; size.1]; size.0];
    for ((&row, &column), &value) in rows.iter().zip(columns).zip(values) {
        matrix[row][column] += value;
    }
    matrix
}

/// Compares derivatives by one input with central differences of two step lengths, which also estimate the error of the
/// differences.
fn check_column(
    what: &str,
    column: usize,
    exact: &[f64],
    point: &[f64],
    function: impl Fn(&[f64]) -> Vec<f64>,
) -> Result<(), String> {
    let difference = |step: f64| -> Vec<f64> {
        let (mut ahead, mut behind) = (point.to_vec(), point.to_vec());
        ahead[column] += step;
        behind[column] -= step;
        function(&ahead).iter().zip(function(&behind)).map(|(a, b)| (a - b) / (2.0 * step)).collect()
    };
    let (coarse, fine) = (difference(1e-4), difference(5e-5));
    let magnitudes = function(point);
    for (row, &derivative) in exact.iter().enumerate() {
        let tolerance = 1e-9 * (1.0 + magnitudes[row].abs()) + 1e-7 * derivative.abs();
        let error = (derivative - fine[row]).abs();
        if error > tolerance + 2.0 * (coarse[row] - fine[row]).abs() {
            return Err(format!("{what} ({row}, {column}): {derivative}, by differences {}", fine[row]));
        }
    }
    Ok(())
}

/// Compares the Jacobian with differences of values, the Hessian with differences of the adjoint, both with their zero
/// entries, and the adjoint with the Jacobian.
pub fn check_derivatives(tape: &Tape, variables: usize, point: &[f64]) -> Result<(), String> {
    let outputs = tape.output_count();
    let jacobian = tape.jacobian(variables);
    let values = evaluate(jacobian.tape(), point);
    let matrix = dense((outputs, variables), &jacobian.rows, &jacobian.columns, &values);
    for column in 0..variables {
        let exact: Vec<f64> = matrix.iter().map(|row| row[column]).collect();
        check_column("Jacobian", column, &exact, point, |x| evaluate(tape, x))?;
    }
    let hessian = tape.lagrangian_hessian(variables);
    let multipliers: Vec<f64> = (0..outputs).map(|output| 0.7 - 0.4 * output as f64).collect();
    let extended = [point, &multipliers].concat();
    let adjoint = evaluate(hessian.adjoint(), &extended);
    for (column, &entry) in adjoint.iter().enumerate() {
        let products = (0..outputs).map(|row| multipliers[row] * matrix[row][column]);
        let (sum, scale) = products.fold((0.0, 1.0), |(sum, scale), term| (sum + term, scale + term.abs()));
        if (entry - sum).abs() > 1e-10 * scale {
            return Err(format!("adjoint {column}: {entry}, by the Jacobian {sum}"));
        }
    }
    assert!(hessian.rows.iter().zip(&hessian.columns).all(|(row, column)| row >= column));
    let values = evaluate(hessian.tape(), &extended);
    let lower = dense((variables, variables), &hessian.rows, &hessian.columns, &values);
    for column in 0..variables {
        let exact: Vec<f64> = (0..variables).map(|row| lower[row.max(column)][row.min(column)]).collect();
        check_column("Hessian", column, &exact, &extended, |x| evaluate(hessian.adjoint(), x))?;
    }
    Ok(())
}

//! The factor against the definition of a QR factorisation, and the rank against singular values.

use nalgebra::DMatrix;
use spqr_sys::{FactorisationError, Triangle, factorise};

const TOLERANCE: f64 = 1e-9;

/// A random sparse matrix, of whose columns the last `dependent` are sums of two of the others.
fn matrix(random: &mut fastrand::Rng, rows: usize, columns: usize, dependent: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(rows, columns);
    let free = columns - dependent;
    for column in 0..free {
        matrix[(column % rows, column)] = 1.0;
        for _ in 0..3 {
            matrix[(random.usize(..rows), column)] = random.f64() - 0.5;
        }
    }
    for column in free..columns {
        let sum = matrix.column(random.usize(..free)) + matrix.column(random.usize(..free)) * -0.7;
        matrix.set_column(column, &sum);
    }
    matrix
}

fn sparse(matrix: &DMatrix<f64>) -> Vec<Vec<(usize, f64)>> {
    let entries = |column: usize| (0..matrix.nrows()).map(move |row| (row, matrix[(row, column)]));
    (0..matrix.ncols()).map(|column| entries(column).filter(|entry| entry.1 != 0.0).collect()).collect()
}

fn dense(triangle: &Triangle, rows: usize) -> DMatrix<f64> {
    let mut factor = DMatrix::zeros(rows, triangle.columns.len());
    for (column, entries) in triangle.columns.iter().enumerate() {
        entries.iter().for_each(|&(row, value)| factor[(row, column)] = value);
    }
    factor
}

#[test]
fn the_factor_has_the_products_of_the_columns_and_the_rank_of_the_matrix() {
    let mut random = fastrand::Rng::with_seed(1);
    for (rows, columns, dependent) in [(1, 1, 0), (12, 8, 0), (12, 8, 3), (40, 30, 11), (30, 40, 5), (200, 150, 20)] {
        let matrix = matrix(&mut random, rows, columns, dependent);
        let triangle = factorise(rows, &sparse(&matrix), TOLERANCE).unwrap();
        let permuted = matrix.select_columns(&triangle.permutation);
        let factor = dense(&triangle, rows);
        // Q is orthogonal.
        let error = (permuted.transpose() * permuted - factor.transpose() * &factor).amax();
        assert!(error < 1e-12, "{rows} x {columns}: {error}");
        let rank = matrix.singular_values().iter().filter(|&&value| value > TOLERANCE).count();
        assert_eq!(triangle.rank, rank, "{rows} x {columns}");
        assert!(rank <= columns - dependent);
    }
}

#[test]
fn the_factor_is_a_staircase() {
    let mut random = fastrand::Rng::with_seed(2);
    for _ in 0..30 {
        let matrix = matrix(&mut random, 25, 20, 6);
        let triangle = factorise(25, &sparse(&matrix), TOLERANCE).unwrap();
        let mut depth = 0;
        for column in &triangle.columns {
            let last = column.last().map_or(0, |&(row, _)| row + 1);
            assert!(last <= depth + 1);
            if last == depth + 1 {
                assert!(column[column.len() - 1].1.abs() > TOLERANCE);
                depth += 1;
            }
        }
        assert_eq!(depth, triangle.rank);
    }
}

#[test]
fn matrices_without_entries_have_rank_zero() {
    assert_eq!(factorise(3, &[vec![], vec![]], TOLERANCE).unwrap().rank, 0);
    assert_eq!(factorise(3, &[], TOLERANCE).unwrap().rank, 0);
}

#[test]
fn wrong_entries_are_errors() {
    for column in [vec![(3, 1.0)], vec![(0, f64::NAN)], vec![(1, 1.0), (1, 1.0)], vec![(1, 1.0), (0, 1.0)]] {
        assert_eq!(factorise(3, &[column], TOLERANCE), Err(FactorisationError::Entry));
    }
}

//! Rank-revealing QR factorisations: by SPQR with the feature `spqr`, else by faer.

#[cfg(not(feature = "spqr"))]
use self::dense as chosen;
#[cfg(feature = "spqr")]
use self::sparse as chosen;

/// Length of the part of a column of unit length that is orthogonal to the others, below which it depends on them.
const TOLERANCE: f64 = 1e-6;

/// A column of a sparse matrix: rows, ascending, with their values.
pub type Column = Vec<(usize, f64)>;

/// The triangular factor of `A P = Q R`.
pub struct Triangle {
    /// `P`: the column of `A` that each column of `R` is.
    pub permutation: Vec<usize>,
    /// Columns of `R`. A column that is independent of those before it ends one row below them, any other ends no
    /// lower.
    pub columns: Vec<Column>,
}

/// The factor of a matrix with columns of unit length. `None` where memory ends or a value is not finite.
pub fn factorise(rows: usize, columns: &[Column]) -> Option<Triangle> {
    chosen(rows, columns)
}

/// By SPQR.
#[cfg(feature = "spqr")]
fn sparse(rows: usize, columns: &[Column]) -> Option<Triangle> {
    let spqr_sys::Triangle { permutation, columns, .. } = spqr_sys::factorise(rows, columns, TOLERANCE).ok()?;
    Some(Triangle { permutation, columns })
}

/// By faer's QR factorisation with column pivoting of the rows that have entries.
#[cfg(any(test, not(feature = "spqr")))]
fn dense(rows: usize, columns: &[Column]) -> Option<Triangle> {
    let mut places = vec![usize::MAX; rows];
    let mut count = 0;
    for &(row, value) in columns.iter().flatten() {
        if !value.is_finite() {
            return None;
        }
        if places[row] == usize::MAX {
            places[row] = count;
            count += 1;
        }
    }
    let mut matrix = faer::Mat::<f64>::zeros(count, columns.len());
    for (column, entries) in columns.iter().enumerate() {
        entries.iter().for_each(|&(row, value)| matrix[(places[row], column)] = value);
    }
    let factors = matrix.col_piv_qr();
    let factor = factors.thin_R();
    let pivots = (0..factor.nrows()).take_while(|&row| factor[(row, row)].abs() > TOLERANCE);
    let rank = pivots.count();
    let column = |index: usize| (0..rank.min(index + 1)).map(|row| (row, factor[(row, index)])).collect();
    Some(Triangle { permutation: factors.P().arrays().0.to_vec(), columns: (0..columns.len()).map(column).collect() })
}

impl Triangle {
    /// One vector `y` with `A y = 0` for each column that depends on those before it, at most `most`.
    pub fn null_vectors(&self, most: usize) -> Vec<Vec<f64>> {
        let mut independent: Vec<usize> = Vec::new();
        let mut vectors = Vec::new();
        for (index, column) in self.columns.iter().enumerate() {
            let depth = column.last().map_or(0, |&(row, _)| row + 1);
            if depth > independent.len() {
                independent.push(index);
            } else if vectors.len() < most {
                vectors.push(self.null_vector(index, &independent));
            }
        }
        vectors
    }

    /// The vector that makes a column of the independent ones before it.
    fn null_vector(&self, dependent: usize, independent: &[usize]) -> Vec<f64> {
        let mut rest = vec![0.0; independent.len()];
        self.columns[dependent].iter().for_each(|&(row, value)| rest[row] = value);
        let mut vector = vec![0.0; self.columns.len()];
        vector[self.permutation[dependent]] = 1.0;
        for (row, &index) in independent.iter().enumerate().rev() {
            let (&(_, pivot), above) = self.columns[index].split_last().expect("an independent column has a pivot");
            let factor = rest[row] / pivot;
            above.iter().for_each(|&(row, value)| rest[row] -= factor * value);
            vector[self.permutation[index]] = -factor;
        }
        vector
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns of unit length, of which the last `dependent` are sums of two others.
    fn columns(rows: usize, count: usize, dependent: usize) -> Vec<Column> {
        let value = |row: usize, column: usize| f64::sin(((row + 1) * (row + 1) * (column + 3)) as f64);
        let mut columns: Vec<Column> = (0..count - dependent)
            .map(|column| {
                (0..rows).filter(|row| (row + column) % 3 != 0).map(|row| (row, value(row, column))).collect()
            })
            .collect();
        for index in 0..dependent {
            let mut sum = vec![0.0; rows];
            for (column, weight) in [(index, 1.0), (index + 1, -2.0)] {
                columns[column].iter().for_each(|&(row, value)| sum[row] += weight * value);
            }
            columns.push(sum.into_iter().enumerate().filter(|entry| entry.1 != 0.0).collect());
        }
        for column in &mut columns {
            let norm = column.iter().map(|(_, value)| value * value).sum::<f64>().sqrt();
            column.iter_mut().for_each(|(_, value)| *value /= norm);
        }
        columns
    }

    fn product(columns: &[Column], rows: usize, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; rows];
        for (column, weight) in columns.iter().zip(vector) {
            column.iter().for_each(|&(row, value)| product[row] += weight * value);
        }
        product
    }

    #[test]
    fn null_vectors_span_all_dependencies_whoever_factorises() {
        type Factorise = fn(usize, &[Column]) -> Option<Triangle>;
        let all: &[Factorise] = &[
            dense,
            #[cfg(feature = "spqr")]
            sparse,
        ];
        for (rows, count, dependent) in [(12, 8, 0), (12, 8, 3), (30, 20, 5), (9, 9, 1)] {
            let columns = columns(rows, count, dependent);
            for factorise in all {
                let vectors = factorise(rows, &columns).unwrap().null_vectors(usize::MAX);
                assert_eq!(vectors.len(), dependent);
                for vector in &vectors {
                    let largest = vector.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
                    let error =
                        product(&columns, rows, vector).into_iter().fold(0.0, |worst: f64, e| worst.max(e.abs()));
                    assert!(largest >= 1.0 && error < 1e-9 * largest, "{error}");
                }
            }
        }
    }

    #[test]
    fn values_that_are_not_finite_have_no_factor() {
        assert!(factorise(2, &[vec![(0, f64::NAN)]]).is_none());
    }
}

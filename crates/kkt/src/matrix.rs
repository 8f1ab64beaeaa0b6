//! The assembled matrix, for residuals and for the general solver.

use feral::CscMatrix;

/// Lower triangle by columns, filled from triplets.
#[derive(Debug)]
pub struct Matrix {
    pub columns: CscMatrix,
    /// Rows of the stored values, 32 bits each: the time of a product is the time to read memory.
    rows: Vec<u32>,
    /// The stored value that each triplet is added to.
    slots: Vec<u32>,
}

impl Matrix {
    /// Sorts the entries by column, then by row.
    pub fn new(dimension: usize, rows: &[usize], columns: &[usize]) -> Self {
        // Two stable bucket sorts, the second by column, leave the entries of a column in the order of their rows.
        let lower: Vec<(usize, usize)> = rows.iter().zip(columns).map(|(&r, &c)| (r.max(c), r.min(c))).collect();
        let by_row = bucket_sort(dimension, 0..lower.len(), |entry| lower[entry].0);
        let by_column = bucket_sort(dimension, by_row.into_iter(), |entry| lower[entry].1);
        let mut slots = vec![0; lower.len()];
        let mut row_idx = Vec::new();
        let mut col_ptr = vec![0; dimension + 1];
        let mut last = None;
        for entry in by_column {
            let (row, column) = lower[entry];
            if last != Some((row, column)) {
                last = Some((row, column));
                row_idx.push(row);
                col_ptr[column + 1] += 1;
            }
            slots[entry] = (row_idx.len() - 1) as u32;
        }
        for column in 0..dimension {
            col_ptr[column + 1] += col_ptr[column];
        }
        let values = vec![0.0; row_idx.len()];
        let rows = row_idx.iter().map(|&row| row as u32).collect();
        Self { columns: CscMatrix { n: dimension, col_ptr, row_idx, values }, rows, slots }
    }

    /// Sums the triplets.
    pub fn fill(&mut self, values: &[f64]) {
        self.columns.values.fill(0.0);
        for (&slot, value) in self.slots.iter().zip(values) {
            self.columns.values[slot as usize] += value;
        }
    }

    /// Column of every stored value.
    pub fn column_indices(&self) -> Vec<usize> {
        let ends = &self.columns.col_ptr;
        (0..self.columns.n).flat_map(|column| (ends[column]..ends[column + 1]).map(move |_| column)).collect()
    }

    /// Largest absolute value; infinite when a value is not finite.
    pub fn largest(&self) -> f64 {
        let size = |value: &f64| if value.is_nan() { f64::INFINITY } else { value.abs() };
        self.columns.values.iter().map(size).fold(0.0, f64::max)
    }

    /// Writes `b - A x` and returns the largest component relative to `|A| |x| + |b|` (the backward error of Oettli and
    /// Prager). `sums` is scratch of one value per row.
    pub fn residual(&self, x: &[f64], b: &[f64], residual: &mut [f64], sums: &mut [RowSum]) -> f64 {
        for (sum, &b) in sums.iter_mut().zip(b) {
            *sum = RowSum { residual: b, terms: b.abs() };
        }
        let matrix = &self.columns;
        for column in 0..matrix.n {
            let range = matrix.col_ptr[column]..matrix.col_ptr[column + 1];
            let here = x[column];
            let mut own = RowSum { residual: 0.0, terms: 0.0 };
            for (&row, &value) in self.rows[range.clone()].iter().zip(&matrix.values[range]) {
                let row = row as usize;
                own.subtract(value * x[row]);
                if row != column {
                    sums[row].subtract(value * here);
                }
            }
            sums[column].residual += own.residual;
            sums[column].terms += own.terms;
        }
        // A row whose terms are all negligible beside those of other rows has no meaningful relative error.
        let floor = 1e3 * f64::EPSILON * sums.iter().map(|sum| sum.terms).fold(f64::MIN_POSITIVE, f64::max);
        let mut largest = 0.0f64;
        for (residual, sum) in residual.iter_mut().zip(sums) {
            *residual = sum.residual;
            let ratio = sum.residual.abs() / (sum.terms + floor);
            if !ratio.is_finite() {
                return f64::INFINITY;
            }
            largest = largest.max(ratio);
        }
        largest
    }
}

/// A component of `b - A x` and the sum of the absolute values of its terms.
#[derive(Debug, Clone, Copy, Default)]
pub struct RowSum {
    residual: f64,
    terms: f64,
}

impl RowSum {
    fn subtract(&mut self, term: f64) {
        self.residual -= term;
        self.terms += term.abs();
    }
}

/// Stable bucket sort by a key less than `keys`.
fn bucket_sort(keys: usize, items: impl Iterator<Item = usize> + Clone, key: impl Fn(usize) -> usize) -> Vec<usize> {
    let mut starts = vec![0; keys + 1];
    let mut count = 0;
    for item in items.clone() {
        starts[key(item) + 1] += 1;
        count += 1;
    }
    for index in 0..keys {
        starts[index + 1] += starts[index];
    }
    let mut sorted = vec![0; count];
    for item in items {
        let place = &mut starts[key(item)];
        sorted[*place] = item;
        *place += 1;
    }
    sorted
}

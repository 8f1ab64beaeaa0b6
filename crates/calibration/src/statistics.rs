//! Uncertainty of fitted values.

use faer::Mat;

use crate::deviation::COMPONENTS;

/// Information of the samples of some runs about values, block by block in time: `J' J` and `J' r` of residuals `r` and
/// their derivatives `J`, a row and a column for each value, per unit of its scale.
pub struct Information {
    /// One for each of [`LENGTHS`].
    divisions: Vec<Vec<Block>>,
    whole: Block,
    /// Squared standard deviation of the residuals.
    variance: f64,
}

struct Block {
    squares: Mat<f64>,
    gradient: Mat<f64>,
}

/// Samples of a block: a quarter of a second, half a second and a second, the correlation times of model errors.
pub const LENGTHS: [usize; 3] = [25, 50, 100];
/// Fewest blocks of a run.
const FEWEST: usize = 4;
/// Smaller eigenvalues of `J' J`, in squared standard deviations per scale, carry no information.
const SMALLEST: f64 = 1e-12;

impl Information {
    /// From residuals and their derivatives. `runs` has the number of samples of each run; their rows follow each other.
    pub fn new(jacobian: &Mat<f64>, residuals: &[f64], runs: &[usize]) -> Self {
        let shortest: Vec<Block> = blocks(runs, LENGTHS[0]).map(|rows| Block::new(jacobian, residuals, rows)).collect();
        let squares = residuals.iter().map(|residual| residual * residual).sum::<f64>();
        let left = residuals.len() as f64 - jacobian.ncols() as f64;
        Self {
            whole: Block::sum(&shortest, jacobian.ncols()),
            divisions: LENGTHS
                .iter()
                .map(|&length| blocks(runs, length).map(|rows| Block::new(jacobian, residuals, rows)).collect())
                .collect(),
            variance: squares / left.max(1.0),
        }
    }

    /// Covariance of the values in some columns while others are `held`, in units of their scales.
    ///
    /// It is a jackknife estimate: the spread of the values that a Gauss-Newton step finds without one block of
    /// samples. It therefore includes model errors as far as they differ between parts of the motion, which noise alone
    /// does not. Blocks that are shorter than the correlation of errors underestimate them: the length with the largest
    /// estimate counts. Added are the noise of the fit without a block, so that a value from one block alone does not
    /// count as identified, and the uncertainty of held values, each of its scale.
    pub fn covariance(&self, columns: &[usize], held: &[usize]) -> Mat<f64> {
        let jackknives = self.divisions.iter().map(|blocks| self.jackknife(blocks, columns));
        let whole = self.whole.part(columns).squares;
        let size = |covariance: &Mat<f64>| (&whole * covariance).diagonal().column_vector().sum();
        let largest = jackknives.max_by(|one, other| size(one).total_cmp(&size(other)));
        let doubt = solved(&whole, &self.whole.between(columns, held));
        largest.unwrap_or_else(|| Mat::zeros(columns.len(), columns.len())) + &doubt * doubt.transpose()
    }

    fn jackknife(&self, blocks: &[Block], columns: &[usize]) -> Mat<f64> {
        let (size, count) = (columns.len(), blocks.len() as f64);
        let whole = self.whole.part(columns);
        let mut noise = Mat::zeros(size, size);
        let mut changes = Mat::zeros(size, blocks.len());
        for (index, block) in blocks.iter().enumerate() {
            let left_out = block.part(columns);
            let rest = &whole.squares - &left_out.squares;
            noise += solved(&rest, &Mat::identity(size, size)) * faer::Scale(self.variance / count);
            changes.col_mut(index).copy_from(solved(&rest, &left_out.gradient).col(0));
        }
        let mean = Mat::from_fn(size, 1, |row, _| changes.row(row).sum() / count);
        let apart = Mat::from_fn(size, blocks.len(), |row, column| changes[(row, column)] - mean[(row, 0)]);
        noise + &apart * apart.transpose() * faer::Scale((count - 1.0) / count)
    }
}

impl Block {
    fn new(jacobian: &Mat<f64>, residuals: &[f64], rows: std::ops::Range<usize>) -> Self {
        let part = jacobian.subrows(rows.start, rows.len());
        let residuals = Mat::from_fn(rows.len(), 1, |row, _| residuals[rows.start + row]);
        Self { squares: part.transpose() * part, gradient: part.transpose() * residuals }
    }

    fn sum(blocks: &[Self], size: usize) -> Self {
        let nothing = Self { squares: Mat::zeros(size, size), gradient: Mat::zeros(size, 1) };
        blocks.iter().fold(nothing, |sum, block| Self {
            squares: sum.squares + &block.squares,
            gradient: sum.gradient + &block.gradient,
        })
    }

    fn part(&self, columns: &[usize]) -> Self {
        let gradient = Mat::from_fn(columns.len(), 1, |row, _| self.gradient[(columns[row], 0)]);
        Self { squares: self.between(columns, columns), gradient }
    }

    fn between(&self, rows: &[usize], columns: &[usize]) -> Mat<f64> {
        Mat::from_fn(rows.len(), columns.len(), |row, column| self.squares[(rows[row], columns[column])])
    }
}

/// Rows of blocks of `length` samples. No block spans two runs.
pub fn blocks(runs: &[usize], length: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut first = 0;
    runs.iter().flat_map(move |&samples| {
        let (begin, end) = (first, first + COMPONENTS * samples);
        first = end;
        let rows = COMPONENTS * length.min(samples / FEWEST).max(1);
        (begin..end).step_by(rows).map(move |start| start..(start + rows).min(end))
    })
}

/// Solution of equations with a symmetric matrix that is positive definite up to rounding.
fn solved(matrix: &Mat<f64>, right: &Mat<f64>) -> Mat<f64> {
    let size = matrix.nrows();
    if size == 0 {
        return Mat::zeros(0, right.ncols());
    }
    let Ok(factors) = matrix.self_adjoint_eigen(faer::Side::Lower) else {
        return Mat::from_fn(size, right.ncols(), |_, _| f64::INFINITY);
    };
    let (values, vectors) = (factors.S().column_vector(), factors.U());
    let turned = vectors.transpose() * right;
    vectors * Mat::from_fn(size, right.ncols(), |row, column| turned[(row, column)] / values[row].max(SMALLEST))
}

/// Standard error of the value in a column of a covariance.
pub fn standard_error(covariance: &Mat<f64>, column: usize) -> f64 {
    covariance[(column, column)].sqrt()
}

/// Correlation of two values.
pub fn correlation(covariance: &Mat<f64>, one: usize, other: usize) -> f64 {
    let product = standard_error(covariance, one) * standard_error(covariance, other);
    covariance[(one, other)] / product.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLES: usize = 2000;

    /// Residuals of a straight line and a constant that are fitted to correlated noise, and their derivatives.
    fn line(memory: f64, seed: u64) -> (Vec<f64>, Mat<f64>, [f64; 2]) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut state = [0.0; COMPONENTS];
        let noise: Vec<f64> = (0..SAMPLES)
            .flat_map(|_| {
                state.iter_mut().for_each(|value| *value = memory * *value + random.f64() - 0.5);
                state
            })
            .collect();
        let slope = |row: usize| (row / COMPONENTS) as f64 / SAMPLES as f64 - 0.5;
        let jacobian = Mat::from_fn(noise.len(), 2, |row, column| if column == 0 { 1.0 } else { slope(row) });
        let noise_column = Mat::from_fn(noise.len(), 1, |row, _| noise[row]);
        let fitted = solved(&(jacobian.transpose() * &jacobian), &(jacobian.transpose() * noise_column));
        let residual = |row: usize| noise[row] - fitted[(0, 0)] - slope(row) * fitted[(1, 0)];
        ((0..noise.len()).map(residual).collect(), jacobian, [fitted[(0, 0)], fitted[(1, 0)]])
    }

    #[test]
    fn errors_hold_for_noise_with_and_without_a_memory() {
        for memory in [0.0, 0.9] {
            let mut off = Vec::new();
            for seed in 0..50 {
                let (residuals, jacobian, wrong) = line(memory, seed);
                let covariance = Information::new(&jacobian, &residuals, &[SAMPLES]).covariance(&[0, 1], &[]);
                off.extend((0..2).map(|value| wrong[value].abs() / standard_error(&covariance, value)));
            }
            let beyond = |errors: f64| off.iter().filter(|&&off| off > errors).count();
            // Of 100; with normal errors, 5 and 32. The noise of the fit without a block counts twice.
            assert!(beyond(2.0) <= 10 && beyond(1.0) >= 5, "{}, {} with memory {memory}", beyond(2.0), beyond(1.0));
        }
    }

    #[test]
    fn what_no_sample_or_one_block_alone_tells_has_no_small_error() {
        let (residuals, line, _) = line(0.0, 1);
        for rows in [0, 20 * COMPONENTS] {
            let column = |row: usize| if row < rows { (row % 2) as f64 } else { 0.0 };
            let jacobian = Mat::from_fn(line.nrows(), 2, |row, index| if index == 0 { 1.0 } else { column(row) });
            let covariance = Information::new(&jacobian, &residuals, &[SAMPLES]).covariance(&[0, 1], &[]);
            assert!(standard_error(&covariance, 0) < 0.1 && standard_error(&covariance, 1) > 1e3);
        }
    }

    #[test]
    fn values_are_in_doubt_with_a_held_one_that_acts_alike() {
        let (residuals, _, _) = line(0.0, 1);
        let jacobian = Mat::from_fn(residuals.len(), 2, |row, column| {
            1.0 + if column == 1 { 0.01 * (row % 7) as f64 } else { 0.0 }
        });
        let information = Information::new(&jacobian, &residuals, &[SAMPLES]);
        let (together, alone) = (information.covariance(&[0, 1], &[]), information.covariance(&[0], &[1]));
        assert!(correlation(&together, 0, 1) < -0.99);
        assert!((standard_error(&alone, 0) - 1.03).abs() < 0.01, "{}", standard_error(&alone, 0));
    }
}

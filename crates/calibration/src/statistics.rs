//! How well fitted values are known.

use faer::Mat;

use crate::deviation::COMPONENTS;

/// Covariance of fitted values, in units of their scales.
///
/// Errors of a model do not change from one sample to the next: residuals that are alike for a while count as one. Over the
/// number of samples `n`, their squared standard deviation is `r' r / (n - p t)` with `p` values and `t` samples that count as
/// one, and the covariance `t r' r / (n - p t) (J' J)^-1`. That is an upper bound: it takes derivatives to be alike for as long.
pub fn covariance(triangle: &Mat<f64>, columns: &[usize], variance: f64) -> Mat<f64> {
    /// Smaller singular values (standard deviations per scale) say nothing.
    const SMALLEST: f64 = 1e-6;
    let count = columns.len();
    if count == 0 {
        return Mat::zeros(0, 0);
    }
    let chosen = Mat::from_fn(triangle.nrows(), count, |row, column| triangle[(row, columns[column])]);
    let Ok(factors) = chosen.thin_svd() else { return Mat::from_fn(count, count, |_, _| f64::INFINITY) };
    let (values, vectors) = (factors.S().column_vector(), factors.V());
    let weight = |index: usize| variance / values[index].max(SMALLEST).powi(2);
    Mat::from_fn(count, count, |row, column| {
        (0..count).map(|index| vectors[(row, index)] * weight(index) * vectors[(column, index)]).sum()
    })
}

/// Factor of the covariance: the variance of residuals times the number of samples that count as one.
pub fn variance(residuals: &[f64], series: &[usize], values: usize) -> f64 {
    let alike = samples_alike(residuals, series);
    let left = residuals.len() as f64 - values as f64 * alike;
    alike * residuals.iter().map(|residual| residual * residual).sum::<f64>() / left.max(1.0)
}

/// How many samples in a row count as one: the sum of the autocorrelation of residuals over all lags until it vanishes.
/// Residuals are those of runs with so many samples, one after the other.
fn samples_alike(residuals: &[f64], samples: &[usize]) -> f64 {
    /// Autocorrelation that is none any more.
    const VANISHED: f64 = 0.05;
    let longest = samples.iter().max().copied().unwrap_or(0);
    let product = |lag: usize| -> f64 {
        let mut first = 0;
        let mut sum = 0.0;
        for &count in samples {
            let run = &residuals[first..first + COMPONENTS * count];
            sum += run.iter().zip(run.iter().skip(COMPONENTS * lag)).map(|(one, other)| one * other).sum::<f64>();
            first += COMPONENTS * count;
        }
        sum
    };
    let all = product(0).max(f64::MIN_POSITIVE);
    let correlations = (1..longest / 2).map(|lag| product(lag) / all).take_while(|correlation| *correlation > VANISHED);
    1.0 + 2.0 * correlations.sum::<f64>()
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

    #[test]
    fn residuals_that_last_count_as_fewer() {
        let mut random = fastrand::Rng::with_seed(3);
        let mut series = |memory: f64| -> Vec<f64> {
            let mut state = [0.0; COMPONENTS];
            (0..4000)
                .flat_map(|_| {
                    state.iter_mut().for_each(|value| *value = memory * *value + random.f64() - 0.5);
                    state
                })
                .collect()
        };
        let alike = |residuals: &[f64]| samples_alike(residuals, &[1000, 3000]);
        assert!((alike(&series(0.0)) - 1.0).abs() < 0.15);
        // The sum of a geometric series: (1 + m) / (1 - m).
        let lasting = alike(&series(0.8));
        assert!((7.5..10.5).contains(&lasting), "{lasting}");
    }

    #[test]
    fn what_no_residual_depends_on_has_no_small_error() {
        let triangle = Mat::from_fn(3, 3, |row, column| if row == column && row < 2 { [2.0, 4.0][row] } else { 0.0 });
        let known = covariance(&triangle, &[0, 1], 1.0);
        assert!((standard_error(&known, 0) - 0.5).abs() < 1e-12 && (standard_error(&known, 1) - 0.25).abs() < 1e-12);
        assert!(standard_error(&covariance(&triangle, &[0, 1, 2], 1.0), 2) > 1e5);
    }

    #[test]
    fn what_acts_alike_is_correlated() {
        let triangle = Mat::from_fn(2, 2, |row, column| [[1.0, 1.0], [0.0, 0.01]][row][column]);
        let covariance = covariance(&triangle, &[0, 1], 1.0);
        assert!(correlation(&covariance, 0, 1) < -0.99);
    }
}

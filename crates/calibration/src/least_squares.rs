//! Nonlinear least squares within bounds, by the Levenberg-Marquardt method.

use std::ops::RangeInclusive;

use faer::Mat;
use faer::prelude::SolveLstsq;

/// A model to be fitted.
pub trait Model {
    /// Residuals, each in standard deviations of its noise. `None` where they cannot be computed.
    fn residuals(&self, values: &[f64]) -> Option<Vec<f64>>;

    /// Derivatives of the residuals, a column for each of the `free` values, per unit of its scale.
    fn jacobian(&self, values: &[f64], residuals: &[f64], free: &[usize]) -> Mat<f64>;

    /// Unit in which a value is searched.
    fn scale(&self, index: usize) -> f64;

    /// Allowed values.
    fn range(&self, index: usize) -> RangeInclusive<f64>;
}

/// A minimum of the sum of squares.
#[derive(Debug, Clone)]
pub struct Fit {
    /// All values, also those that were not free.
    pub values: Vec<f64>,
    /// Residuals there.
    pub residuals: Vec<f64>,
    /// Whether the search converged.
    pub converged: bool,
}

/// Most steps.
const MOST_STEPS: usize = 30;
/// A step that reduces the sum of squares by less than this fraction is the last one.
const LEAST_GAIN: f64 = 1e-4;
/// So is one that changes no value by more than this part of its scale.
const SHORTEST_STEP: f64 = 1e-4;
/// Initial damping, over the largest entry of `R' R`; factors after success and failure; damping at which the search
/// gives up.
const DAMPING: f64 = 1e-3;
const LESS: f64 = 0.1;
const MORE: f64 = 5.0;
const LARGEST_DAMPING: f64 = 1e4;

/// Fits the free values, starting from the given ones. `None` where the model cannot be computed there.
pub fn fit(model: &impl Model, start: &[f64], free: &[usize]) -> Option<Fit> {
    let mut values = start.to_vec();
    let mut residuals = model.residuals(&values)?;
    let mut damping = DAMPING;
    for _ in 0..MOST_STEPS {
        let (triangle, projected) = triangle(&model.jacobian(&values, &residuals, free), &residuals);
        let moving = moving(model, &values, free, &triangle, &projected);
        let before = sum_of_squares(&residuals);
        let mut gain = None;
        while gain.is_none() && damping < LARGEST_DAMPING && !moving.is_empty() {
            let step = step(&triangle, &projected, &moving, damping);
            let trial = moved(model, &values, free, &moving, &step);
            let longest = longest(model, &values, &trial);
            match model.residuals(&trial).filter(|trial| sum_of_squares(trial) < before) {
                Some(better) => {
                    gain = Some((1.0 - sum_of_squares(&better) / before, longest));
                    (values, residuals, damping) = (trial, better, LESS * damping);
                }
                None if longest < SHORTEST_STEP => break,
                None => damping *= MORE,
            }
        }
        let Some((part, longest)) = gain else {
            return Some(Fit { values, residuals, converged: true });
        };
        if part < LEAST_GAIN || longest < SHORTEST_STEP {
            return Some(Fit { values, residuals, converged: true });
        }
    }
    Some(Fit { values, residuals, converged: false })
}

/// Sum of squares.
pub fn sum_of_squares(numbers: &[f64]) -> f64 {
    numbers.iter().map(|number| number * number).sum()
}

/// `R` and `Q' r` of a Jacobian `J = Q R` and residuals `r`: the factor of `[J r]`.
fn triangle(jacobian: &Mat<f64>, residuals: &[f64]) -> (Mat<f64>, Mat<f64>) {
    let (rows, columns) = (jacobian.nrows(), jacobian.ncols());
    // Rows of zeros make it at least as high as wide.
    let both = Mat::from_fn(rows.max(columns + 1), columns + 1, |row, column| match row {
        row if row >= rows => 0.0,
        row if column < columns => jacobian[(row, column)],
        row => residuals[row],
    });
    let factors = both.qr();
    let factor = factors.thin_R();
    let upper = |row: usize, column: usize| if row <= column { factor[(row, column)] } else { 0.0 };
    (Mat::from_fn(columns, columns, upper), Mat::from_fn(columns, 1, |row, _| factor[(row, columns)]))
}

/// Columns of the values that are not held back by a bound.
fn moving(model: &impl Model, values: &[f64], free: &[usize], triangle: &Mat<f64>, projected: &Mat<f64>) -> Vec<usize> {
    let gradient = triangle.transpose() * projected;
    let is_moving = |&column: &usize| {
        let (index, slope) = (free[column], gradient[(column, 0)]);
        let range = model.range(index);
        slope != 0.0
            && !(values[index] <= *range.start() && slope > 0.0)
            && !(values[index] >= *range.end() && slope < 0.0)
    };
    (0..free.len()).filter(is_moving).collect()
}

/// The step of the moving values, in units of their scales: the least sum of squares of residuals and damped steps.
fn step(triangle: &Mat<f64>, projected: &Mat<f64>, moving: &[usize], damping: f64) -> Mat<f64> {
    let rows = triangle.nrows();
    let largest = moving.iter().map(|&column| triangle.col(column).squared_norm_l2()).fold(0.0, f64::max);
    let brake = (damping * largest).sqrt();
    let matrix = Mat::from_fn(rows + moving.len(), moving.len(), |row, column| match row.checked_sub(rows) {
        None => triangle[(row, moving[column])],
        Some(diagonal) if diagonal == column => brake,
        Some(_) => 0.0,
    });
    let wanted = Mat::from_fn(rows + moving.len(), 1, |row, _| if row < rows { -projected[(row, 0)] } else { 0.0 });
    matrix.qr().solve_lstsq(wanted)
}

fn moved(model: &impl Model, values: &[f64], free: &[usize], moving: &[usize], step: &Mat<f64>) -> Vec<f64> {
    let mut moved = values.to_vec();
    for (row, &column) in moving.iter().enumerate() {
        let (index, range) = (free[column], model.range(free[column]));
        moved[index] = (values[index] + model.scale(index) * step[(row, 0)]).clamp(*range.start(), *range.end());
    }
    moved
}

/// Largest change of a value in units of its scale.
fn longest(model: &impl Model, from: &[f64], to: &[f64]) -> f64 {
    let changes = from.iter().zip(to).enumerate().map(|(index, (from, to))| (to - from).abs() / model.scale(index));
    changes.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `a exp(-b t) + c` at some times, and a value without effect.
    struct Decay(Vec<f64>);

    impl Decay {
        fn at(values: &[f64], time: f64) -> f64 {
            values[0] * (-values[1] * time).exp() + values[2]
        }
    }

    impl Model for Decay {
        fn residuals(&self, values: &[f64]) -> Option<Vec<f64>> {
            let residual = |(index, measured): (usize, &f64)| Self::at(values, 0.1 * index as f64) - measured;
            (values[1] < 50.0).then(|| self.0.iter().enumerate().map(residual).collect())
        }

        fn jacobian(&self, values: &[f64], residuals: &[f64], free: &[usize]) -> Mat<f64> {
            let columns: Vec<Vec<f64>> = free
                .iter()
                .map(|&index| {
                    let mut changed = values.to_vec();
                    changed[index] += 1e-6;
                    self.residuals(&changed).unwrap()
                })
                .collect();
            Mat::from_fn(residuals.len(), free.len(), |row, column| (columns[column][row] - residuals[row]) / 1e-6)
        }

        fn scale(&self, _: usize) -> f64 {
            1.0
        }

        fn range(&self, index: usize) -> RangeInclusive<f64> {
            if index == 2 { 0.0..=10.0 } else { -100.0..=100.0 }
        }
    }

    fn measured(values: &[f64]) -> Decay {
        Decay((0..40).map(|index| Decay::at(values, 0.1 * index as f64)).collect())
    }

    #[test]
    fn values_are_found_from_afar_and_others_stay() {
        let fit = fit(&measured(&[3.0, 2.0, 0.5]), &[1.0, 0.1, 0.0, 7.0], &[0, 1, 2, 3]).unwrap();
        for (value, expected) in fit.values.iter().zip([3.0, 2.0, 0.5, 7.0]) {
            assert!((value - expected).abs() < 1e-4, "{:?}", fit.values);
        }
        assert!(fit.converged);
    }

    #[test]
    fn bounds_hold_and_the_rest_is_fitted_at_them() {
        let fit = fit(&measured(&[3.0, 2.0, -0.5]), &[1.0, 1.0, 1.0], &[0, 1, 2]).unwrap();
        assert_eq!(fit.values[2], 0.0);
        assert!(sum_of_squares(&fit.residuals) < 40.0 * 0.25 && fit.converged, "{:?}", fit.values);
    }

    #[test]
    fn a_model_that_cannot_be_computed_at_first_has_no_fit() {
        assert!(fit(&measured(&[1.0; 3]), &[1.0, 60.0, 0.0], &[0]).is_none());
    }
}

//! The least sum of squares over the delay, with the other parameters fitted to each.
//!
//! Joints whose rotors are light for damping and delay ring: a small change of the delay moves every swing. Over all
//! parameters, the sum of squares then has many local minima, and its derivatives tell little of the next one. Over the delay
//! alone it has one valley.

use crate::least_squares::{Fit, Model, fit, sum_of_squares};
use crate::statistics::{LENGTHS, blocks};

/// Time between the first delays (s), less than half the width of a valley.
const APART: f64 = 7e-4;
/// The first pass ends after this many delays in a row that are worse than the best.
const WORSE: usize = 3;
/// Times that the distance to the neighbours of the best is halved.
const HALVINGS: i32 = 4;
/// Height of the truth in a valley that counts as the least, as a share of the least sum of squares: as much do fits differ
/// that begin elsewhere.
const ROUGHNESS: f64 = 0.02;

/// Fits at several delays, in the order of these.
pub struct Valley {
    points: Vec<Point>,
}

struct Point {
    delay: f64,
    squares: f64,
    fit: Fit,
}

impl Valley {
    /// Fits the values `others` at several delays, which are the value at `place` (s): at delays from zero to behind the best,
    /// each from the fit before, and then ever closer to the best.
    pub fn find(model: &impl Model, start: &[f64], place: usize, others: &[usize]) -> Self {
        let mut valley = Self { points: Vec::new() };
        let range = model.range(place);
        let (mut values, mut worse) = (start.to_vec(), 0);
        let delays = (0..).map(|index| range.start() + APART * f64::from(index));
        for delay in delays.take_while(|delay| range.contains(delay)) {
            let former = valley.least();
            values = valley.add(model, values, place, delay, others);
            worse = if valley.least() < former { 0 } else { worse + 1 };
            if worse == WORSE {
                break;
            }
        }
        for halving in 1..=HALVINGS {
            let Some(values) = valley.best().map(|fit| fit.values.clone()) else { break };
            for step in [-APART, APART] {
                let delay = values[place] + step * 0.5_f64.powi(halving);
                if range.contains(&delay) {
                    valley.add(model, values.clone(), place, delay, others);
                }
            }
        }
        valley
    }

    /// The fit with the least sum of squares. `None` where the model cannot be computed at any delay.
    pub fn best(&self) -> Option<&Fit> {
        Some(&self.points[self.lowest(|point| point.squares)?].fit)
    }

    /// Standard error of the best delay (s) for runs with these numbers of samples: the larger one of the spread of delays
    /// that are the best without one block of samples, and of the width of the valley, which is at least the distance between
    /// its last points. `None` without a valley.
    pub fn error(&self, runs: &[usize]) -> Option<f64> {
        let width = self.width()?.max(APART * 0.5_f64.powi(HALVINGS));
        Some(LENGTHS.iter().map(|&length| self.spread(runs, length)).fold(width, f64::max))
    }

    /// Adds a fit at a delay that begins at some values. Returns the fitted values, or those where the fit fails.
    fn add(
        &mut self,
        model: &impl Model,
        mut values: Vec<f64>,
        place: usize,
        delay: f64,
        others: &[usize],
    ) -> Vec<f64> {
        values[place] = delay;
        let Some(fit) = fit(model, &values, others) else { return values };
        let (values, squares) = (fit.values.clone(), sum_of_squares(&fit.residuals));
        let index = self.points.partition_point(|point| point.delay < delay);
        self.points.insert(index, Point { delay, squares, fit });
        values
    }

    fn least(&self) -> f64 {
        self.points.iter().map(|point| point.squares).fold(f64::INFINITY, f64::min)
    }

    fn lowest(&self, height: impl Fn(&Point) -> f64) -> Option<usize> {
        (0..self.points.len()).min_by(|&one, &other| height(&self.points[one]).total_cmp(&height(&self.points[other])))
    }

    /// How far from the best delay (s) the sum of squares is larger by [`ROUGHNESS`], to the side where that is farther.
    fn width(&self) -> Option<f64> {
        let best = &self.points[self.lowest(|point| point.squares)?];
        let limit = ROUGHNESS * best.squares;
        let side = |points: &mut dyn Iterator<Item = &Point>| {
            let (mut width, mut is_closed) = (0.0, false);
            for point in points {
                let (distance, rise) = ((point.delay - best.delay).abs(), point.squares - best.squares);
                is_closed = rise > limit;
                if is_closed {
                    // On a parabola through both.
                    width = f64::max(width, distance * (limit / rise).sqrt());
                    break;
                }
                width = distance;
            }
            (width, is_closed)
        };
        let (below, _) = side(&mut self.points.iter().rev().filter(|point| point.delay < best.delay));
        let (above, is_closed) = side(&mut self.points.iter().filter(|point| point.delay > best.delay));
        is_closed.then_some(below.max(above))
    }

    /// Jackknife error of the best delay (s) over blocks of this number of samples.
    fn spread(&self, runs: &[usize], length: usize) -> f64 {
        let delays: Vec<f64> = blocks(runs, length)
            .map(|rows| self.bottom(|point| point.squares - sum_of_squares(&point.fit.residuals[rows.clone()])))
            .collect();
        let count = delays.len() as f64;
        let mean = delays.iter().sum::<f64>() / count;
        let squares: f64 = delays.iter().map(|delay| (delay - mean).powi(2)).sum();
        ((count - 1.0) / count * squares).sqrt()
    }

    /// The delay (s) at which a height is least, on a parabola through the lowest point and its neighbours.
    fn bottom(&self, height: impl Fn(&Point) -> f64) -> f64 {
        let Some(lowest) = self.lowest(&height) else { return f64::NAN };
        let middle = &self.points[lowest];
        let neighbours = (lowest.checked_sub(1).map(|index| &self.points[index]), self.points.get(lowest + 1));
        let (Some(before), Some(after)) = neighbours else { return middle.delay };
        let (left, right) = (middle.delay - before.delay, after.delay - middle.delay);
        let slopes = ((height(middle) - height(before)) / left, (height(after) - height(middle)) / right);
        let curvature = (slopes.1 - slopes.0) / (0.5 * (left + right));
        let slope = (slopes.0 * right + slopes.1 * left) / (left + right);
        if curvature > 0.0 { (middle.delay - slope / curvature).clamp(before.delay, after.delay) } else { middle.delay }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::RangeInclusive;

    use faer::Mat;

    use super::*;
    use crate::deviation::COMPONENTS;

    /// Answers to a step that begin after a delay and ring, times a gain, over half a second.
    struct Ringing(Vec<f64>);

    const SAMPLES: usize = 500;

    impl Ringing {
        fn new(gain: f64, delay: f64) -> Self {
            let mut random = fastrand::Rng::with_seed(1);
            Self((0..SAMPLES).map(|sample| Self::at(&[gain, delay], sample) + 0.02 * (random.f64() - 0.5)).collect())
        }

        fn at(values: &[f64], sample: usize) -> f64 {
            let time = 1e-4 * (sample % 100) as f64 - values[1];
            values[0] * ((time / 2e-3).tanh() + 0.2 * (time * std::f64::consts::TAU / 8e-4).sin())
        }
    }

    impl Model for Ringing {
        fn residuals(&self, values: &[f64]) -> Option<Vec<f64>> {
            Some(self.0.iter().enumerate().map(|(sample, measured)| Self::at(values, sample) - measured).collect())
        }

        fn jacobian(&self, values: &[f64], residuals: &[f64], free: &[usize]) -> Mat<f64> {
            let column = |&index: &usize| {
                let mut changed = values.to_vec();
                changed[index] += 1e-6;
                self.residuals(&changed).unwrap()
            };
            let columns: Vec<Vec<f64>> = free.iter().map(column).collect();
            let scale = |column: usize| self.scale(free[column]) / 1e-6;
            Mat::from_fn(residuals.len(), free.len(), |row, column| {
                (columns[column][row] - residuals[row]) * scale(column)
            })
        }

        fn scale(&self, index: usize) -> f64 {
            [1.0, 5e-3][index]
        }

        fn range(&self, index: usize) -> RangeInclusive<f64> {
            [-10.0..=10.0, 0.0..=0.1][index].clone()
        }
    }

    #[test]
    fn the_valley_is_found_where_a_search_over_everything_ends_beside_it() {
        let (ringing, start) = (Ringing::new(1.5, 3.1e-3), [1.0, 0.0]);
        let beside = fit(&ringing, &start, &[0, 1]).unwrap();
        assert!((beside.values[1] - 3.1e-3).abs() > 5e-4, "{:?}", beside.values);
        let valley = Valley::find(&ringing, &start, 1, &[0]);
        let (found, error) = (valley.best().unwrap(), valley.error(&[SAMPLES / COMPONENTS]).unwrap());
        let off = (found.values[1] - 3.1e-3).abs();
        assert!(off <= 2.0 * error && error < 2e-4, "{:?} +- {error}", found.values);
        assert!((found.values[0] - 1.5).abs() < 0.05, "{:?}", found.values);
    }

    #[test]
    fn a_delay_without_effect_has_no_small_error() {
        let mut ringing = Ringing::new(0.0, 0.0);
        ringing.0[0] = 1.0;
        let valley = Valley::find(&ringing, &[0.0, 0.0], 1, &[0]);
        assert!(valley.error(&[SAMPLES / COMPONENTS]).is_none_or(|error| error > 1e-3));
    }
}

//! A small problem with a known minimum.

use nlp::{Bounds, EvaluationError, Pattern, Problem, Start};

/// `min x0 x3 (x0 + x1 + x2) + x2` subject to `x0 x1 x2 x3 >= 25`, `|x|^2 = 40`, `1 <= x <= 5`
/// (Hock and Schittkowski, problem 71).
#[derive(Default)]
pub struct Product {
    pub x: [f64; 4],
    pub points: usize,
    pub panics: bool,
    /// Evaluation fails where the first variable exceeds this.
    pub wall: Option<f64>,
    pub wrong_hessian: bool,
}

impl Product {
    fn pairs() -> impl Iterator<Item = (usize, usize)> {
        (0..4).flat_map(|row| (0..=row).map(move |column| (row, column)))
    }

    /// Product of all variables but one or two.
    fn others(&self, one: usize, other: usize) -> f64 {
        (0..4).filter(|&index| index != one && index != other).map(|index| self.x[index]).product()
    }
}

impl Problem for Product {
    fn variable_bounds(&self) -> Bounds {
        Bounds { lower: vec![1.0; 4], upper: vec![5.0; 4] }
    }
    fn constraint_bounds(&self) -> Bounds {
        Bounds { lower: vec![25.0, 40.0], upper: vec![f64::INFINITY, 40.0] }
    }
    fn jacobian_pattern(&self) -> Pattern {
        Pattern { rows: vec![0, 0, 0, 0, 1, 1, 1, 1], columns: vec![0, 1, 2, 3, 0, 1, 2, 3] }
    }
    fn hessian_pattern(&self) -> Pattern {
        let (rows, columns) = Self::pairs().unzip();
        Pattern { rows, columns }
    }
    fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError> {
        self.points += 1;
        self.x.copy_from_slice(x);
        Ok(())
    }
    fn objective(&mut self) -> Result<f64, EvaluationError> {
        assert!(!self.panics || self.points < 3, "the third point is one too many");
        if self.wall.is_some_and(|wall| self.x[0] > wall) {
            return Err(EvaluationError::new("behind the wall"));
        }
        let [a, b, c, d] = self.x;
        Ok(a * d * (a + b + c) + c)
    }
    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
        let [a, b, c, d] = self.x;
        gradient.copy_from_slice(&[d * (2.0 * a + b + c), a * d, a * d + 1.0, a * (a + b + c)]);
        Ok(())
    }
    fn constraints(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        values[0] = self.x.iter().product();
        values[1] = self.x.iter().map(|value| value * value).sum();
        Ok(())
    }
    fn jacobian(&mut self, values: &mut [f64]) -> Result<(), EvaluationError> {
        for index in 0..4 {
            values[index] = self.others(index, index);
            values[4 + index] = 2.0 * self.x[index];
        }
        Ok(())
    }
    fn hessian(&mut self, factor: f64, multipliers: &[f64], values: &mut [f64]) -> Result<(), EvaluationError> {
        let [a, b, c, d] = self.x;
        let objective = [2.0 * d, d, 0.0, d, 0.0, 0.0, 2.0 * a + b + c, a, a, 0.0].map(|entry| entry * factor);
        for (entry, (row, column)) in Self::pairs().enumerate() {
            let bilinear = if row == column { 2.0 * multipliers[1] } else { multipliers[0] * self.others(row, column) };
            values[entry] = objective[entry] + bilinear;
        }
        if self.wrong_hessian {
            values[4] += 0.1;
        }
        Ok(())
    }
}

pub fn cold() -> Start {
    Start::Cold(vec![1.0, 5.0, 5.0, 1.0])
}

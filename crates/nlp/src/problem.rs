//! The interface of a nonlinear program.

use std::error::Error;
use std::sync::Arc;

/// Coordinates of a sparse matrix, from 0. A coordinate may appear more than once; its values are summed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Pattern {
    /// Row of every entry.
    pub rows: Vec<usize>,
    /// Column of every entry.
    pub columns: Vec<usize>,
}

/// Lower and upper bounds. An infinite bound means that there is none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bounds {
    /// Lower bounds.
    pub lower: Vec<f64>,
    /// Upper bounds; equal to the lower bound where the value is fixed.
    pub upper: Vec<f64>,
}

impl Bounds {
    /// The same bounds for `count` values.
    pub fn uniform(count: usize, lower: f64, upper: f64) -> Self {
        Self { lower: vec![lower; count], upper: vec![upper; count] }
    }

    /// One value between `-limit` and `limit` for every limit.
    pub fn symmetric(limits: impl IntoIterator<Item = f64>) -> Self {
        let upper: Vec<f64> = limits.into_iter().collect();
        Self { lower: upper.iter().map(|limit| -limit).collect(), upper }
    }
}

/// A function that has no value at the current point, with the reason. Ipopt then tries a shorter step.
#[derive(Debug, Clone, thiserror::Error)]
#[error(transparent)]
pub struct EvaluationError(Arc<dyn Error + Send + Sync>);

impl EvaluationError {
    /// With an error or a text as the reason.
    pub fn new(reason: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        Self(Arc::from(reason.into()))
    }

    /// The reason, which callers can downcast.
    pub fn reason(&self) -> &(dyn Error + Send + Sync + 'static) {
        &*self.0
    }
}

/// `min f(x)` subject to bounds on `x` and on `g(x)`, with sparse first and second derivatives.
///
/// [`Problem::set_point`] is called whenever `x` changes; all later evaluations are at that point.
pub trait Problem {
    /// Bounds on `x`, one entry per variable.
    fn variable_bounds(&self) -> Bounds;
    /// Bounds on `g`, one entry per constraint.
    fn constraint_bounds(&self) -> Bounds;
    /// Entries of the Jacobian of `g`.
    fn jacobian_pattern(&self) -> Pattern;
    /// Entries of the lower triangle of the Hessian of the Lagrangian.
    fn hessian_pattern(&self) -> Pattern;
    /// Moves to a new point.
    ///
    /// # Errors
    /// When the problem is not defined there.
    fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError>;
    /// `f(x)`.
    ///
    /// # Errors
    /// When it has no value there.
    fn objective(&mut self) -> Result<f64, EvaluationError>;
    /// `grad f(x)`. Must write every entry.
    ///
    /// # Errors
    /// When it has no value there.
    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError>;
    /// `g(x)`. Must write every entry.
    ///
    /// # Errors
    /// When it has no value there.
    fn constraints(&mut self, values: &mut [f64]) -> Result<(), EvaluationError>;
    /// Jacobian of `g`, in the order of its pattern.
    ///
    /// # Errors
    /// When it has no value there.
    fn jacobian(&mut self, values: &mut [f64]) -> Result<(), EvaluationError>;
    /// Hessian of `objective_factor f + multipliers' g`, in the order of its pattern.
    ///
    /// # Errors
    /// When it has no value there.
    fn hessian(
        &mut self,
        objective_factor: f64,
        multipliers: &[f64],
        values: &mut [f64],
    ) -> Result<(), EvaluationError>;
}

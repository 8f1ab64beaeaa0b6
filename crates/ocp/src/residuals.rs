//! The constraints at a point: what each is, how far it is from its bounds, and its gradient.

use nlp::{EvaluationError, Iterate, Problem};

use crate::layout::Member;
use crate::terms::{CONTACT_FORCE, PRODUCT};
use crate::transcription::Transcription;

/// Distance from a bound that is zero, below which the bound is active (in the unit of the row).
const ACTIVE: f64 = 1e-6;
/// The same for other bounds, as a fraction of the bound.
const RELATIVELY_ACTIVE: f64 = 1e-2;

/// A constraint row, or a bounded variable, at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// Its meaning.
    pub member: Member,
    /// Where it is in the nonlinear program.
    pub index: ConstraintIndex,
    /// Its value, in the unit of the row or variable.
    pub value: f64,
    /// Its lower bound, negative infinity where there is none.
    pub lower: f64,
    /// Its upper bound, infinity where there is none; equal to the lower one for an equality.
    pub upper: f64,
    /// Its multiplier, in Ipopt's sign: positive where the upper bound holds the cost up.
    pub multiplier: f64,
}

/// Where a constraint is in the nonlinear program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConstraintIndex {
    /// A constraint row, by its index.
    Row(usize),
    /// Bounds on a variable, by its index.
    Variable(usize),
}

/// How a constraint restricts small changes of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Activity {
    /// It must not change.
    Equality,
    /// It is at or below its lower bound and must not fall.
    Lower,
    /// It is at or above its upper bound and must not rise.
    Upper,
}

impl Residual {
    /// By how much the value is outside of its bounds, 0 inside.
    pub fn violation(&self) -> f64 {
        (self.lower - self.value).max(self.value - self.upper).max(0.0)
    }

    /// Which bound is active: reached within 1e-6, or a hundredth of the bound, or violated.
    pub fn activity(&self) -> Option<Activity> {
        let slack = |bound: f64| if bound == 0.0 { ACTIVE } else { RELATIVELY_ACTIVE * bound.abs() };
        if self.lower == self.upper {
            return Some(Activity::Equality);
        }
        if self.lower.is_finite() && self.value <= self.lower + slack(self.lower) {
            return Some(Activity::Lower);
        }
        (self.upper.is_finite() && self.value >= self.upper - slack(self.upper)).then_some(Activity::Upper)
    }

    /// The change that brings the value to the bound that is active, in the unit of the value; 0 where none is.
    pub fn missing(&self) -> f64 {
        match self.activity() {
            Some(Activity::Equality | Activity::Lower) => self.lower - self.value,
            Some(Activity::Upper) => self.upper - self.value,
            None => 0.0,
        }
    }

    /// With values times a factor.
    fn times(self, unit: f64) -> Self {
        let Self { value, lower, upper, multiplier, .. } = self;
        Self { value: value * unit, lower: lower * unit, upper: upper * unit, multiplier: multiplier / unit, ..self }
    }
}

impl Transcription {
    /// Every constraint row, then every variable with a bound, at a primal-dual point, with the smoothing that was set
    /// last. Forces are in N, as in the scene.
    ///
    /// # Errors
    /// When a distance cannot be computed there.
    ///
    /// # Panics
    /// When the point is not one of this transcription.
    pub fn residuals(&mut self, point: &Iterate) -> Result<Vec<Residual>, EvaluationError> {
        let mut values = vec![0.0; self.layout().constraint_count()];
        self.set_point(&point.x)?;
        self.constraints(&mut values)?;
        let bounds = self.constraint_bounds();
        let rows = self.layout().row_members().into_iter().enumerate().map(|(row, member)| Residual {
            member,
            index: ConstraintIndex::Row(row),
            value: values[row],
            lower: bounds.lower[row],
            upper: bounds.upper[row],
            multiplier: point.constraint_multipliers[row],
        });
        let bounds = self.variable_bounds();
        let variables = self.layout().variable_members().into_iter().enumerate().map(|(index, member)| Residual {
            member,
            index: ConstraintIndex::Variable(index),
            value: point.x[index],
            lower: bounds.lower[index],
            upper: bounds.upper[index],
            multiplier: point.upper_multipliers[index] - point.lower_multipliers[index],
        });
        let bounded = variables.filter(|variable| variable.lower.is_finite() || variable.upper.is_finite());
        Ok(rows.chain(bounded).map(|residual| residual.times(self.unit(&residual.member))).collect())
    }

    /// The cost and the constraints times their multipliers, `f(x) + lambda' g(x)`, at a primal-dual point, with the smoothing
    /// that was set last. At an optimum, its derivative by what the task was made from is that of the cost (envelope theorem).
    ///
    /// # Errors
    /// When a distance cannot be computed there.
    pub fn lagrangian(&mut self, point: &Iterate) -> Result<f64, EvaluationError> {
        let mut values = vec![0.0; self.layout().constraint_count()];
        self.set_point(&point.x)?;
        self.constraints(&mut values)?;
        let constraints: f64 =
            values.iter().zip(&point.constraint_multipliers).map(|(value, multiplier)| value * multiplier).sum();
        Ok(self.objective()? + constraints)
    }

    /// Gradients of some constraints at a point `x`: for each the indices of variables, ascending, with the derivatives
    /// by them, all forces in N. Structural zeros are left out.
    ///
    /// # Errors
    /// When a distance cannot be computed there.
    ///
    /// # Panics
    /// When the point or an index is not one of this transcription.
    pub fn gradients(
        &mut self,
        x: &[f64],
        indices: &[ConstraintIndex],
    ) -> Result<Vec<Vec<(usize, f64)>>, EvaluationError> {
        let pattern = self.jacobian_pattern();
        let mut values = vec![0.0; pattern.rows.len()];
        self.set_point(x)?;
        self.jacobian(&mut values)?;
        let units = |members: Vec<Member>| -> Vec<f64> { members.iter().map(|member| self.unit(member)).collect() };
        let row_units = units(self.layout().row_members());
        let column_units = units(self.layout().variable_members());
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.layout().constraint_count()];
        for ((&row, &column), &value) in pattern.rows.iter().zip(&pattern.columns).zip(&values) {
            rows[row].push((column, value * row_units[row] / column_units[column]));
        }
        let gradient = |index: &ConstraintIndex| match *index {
            ConstraintIndex::Row(row) => summed(rows[row].clone()),
            ConstraintIndex::Variable(variable) => vec![(variable, 1.0)],
        };
        Ok(indices.iter().map(gradient).collect())
    }

    /// The unit of a row or variable, in the units of the scene.
    fn unit(&self, member: &Member) -> f64 {
        match member.block {
            CONTACT_FORCE | PRODUCT => self.task().impedance.force_unit(),
            _ => 1.0,
        }
    }
}

/// Entries in ascending order, those of the same variable as one.
fn summed(mut entries: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
    entries.sort_by_key(|&(column, _)| column);
    entries.dedup_by(|next, kept| {
        let is_same = next.0 == kept.0;
        if is_same {
            kept.1 += next.1;
        }
        is_same
    });
    entries.retain(|&(_, value)| value != 0.0);
    entries
}

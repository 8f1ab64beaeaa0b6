//! The derivative checker, which compares analytic derivatives with central differences.

use std::fmt;

use crate::problem::{EvaluationError, Pattern, Problem};

/// One derivative and its estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// Which derivative.
    pub kind: Kind,
    /// Row (0 for the gradient).
    pub row: usize,
    /// Column.
    pub column: usize,
    /// The problem's value.
    pub analytic: f64,
    /// Its estimate by central differences.
    pub finite_difference: f64,
}

/// Which derivative an entry belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Gradient of the objective.
    Gradient,
    /// Jacobian of the constraints.
    Jacobian,
    /// Hessian of the Lagrangian.
    Hessian,
}

impl Entry {
    /// Difference relative to the larger of 1 and the absolute analytic value.
    pub fn error(&self) -> f64 {
        (self.analytic - self.finite_difference).abs() / self.analytic.abs().max(1.0)
    }
}

impl fmt::Display for Entry {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let Self { kind, row, column, analytic, finite_difference } = self;
        write!(formatter, "{kind:?} ({row}, {column}): analytic {analytic:e}, by differences {finite_difference:e}")
    }
}

/// All derivatives of a problem at one point, zeros outside the patterns included.
#[derive(Debug, Clone, PartialEq)]
pub struct DerivativeReport {
    /// Entries, worst first.
    pub entries: Vec<Entry>,
}

impl DerivativeReport {
    /// Asserts that every entry's error is within a tolerance.
    ///
    /// # Panics
    /// When an error exceeds the tolerance, or when all entries agree to the last bit, which true differences never do.
    pub fn assert_within(&self, tolerance: f64) {
        let worst = self.entries.first().expect("a problem has derivatives");
        assert!(worst.error() <= tolerance, "{worst}");
        assert!(
            self.entries.iter().any(|entry| entry.analytic != entry.finite_difference),
            "analytic derivatives and differences are identical: nothing was compared"
        );
    }
}

/// Compares gradient, Jacobian and Hessian of the Lagrangian (objective factor 1) at `x` with central differences of a
/// given step length. The Hessian is compared with differences of the gradient of the Lagrangian.
///
/// # Errors
/// When the problem cannot be evaluated near `x`.
pub fn check_derivatives(
    problem: &mut dyn Problem,
    x: &[f64],
    multipliers: &[f64],
    step: f64,
) -> Result<DerivativeReport, EvaluationError> {
    let center = Derivatives::at(problem, x, multipliers)?;
    let mut entries = Vec::new();
    let mut moved = x.to_vec();
    for column in 0..x.len() {
        moved[column] = x[column] + step;
        let ahead = Derivatives::at(problem, &moved, multipliers)?;
        moved[column] = x[column] - step;
        let behind = Derivatives::at(problem, &moved, multipliers)?;
        moved[column] = x[column];
        let slope = |ahead: f64, behind: f64| (ahead - behind) / (2.0 * step);
        let mut push = |kind, row, analytic, finite_difference| {
            entries.push(Entry { kind, row, column, analytic, finite_difference });
        };
        push(Kind::Gradient, 0, center.gradient[column], slope(ahead.objective, behind.objective));
        for row in 0..multipliers.len() {
            let finite_difference = slope(ahead.constraints[row], behind.constraints[row]);
            push(Kind::Jacobian, row, center.jacobian[row][column], finite_difference);
        }
        for row in 0..x.len() {
            let finite_difference = slope(ahead.lagrangian_gradient[row], behind.lagrangian_gradient[row]);
            push(Kind::Hessian, row, center.hessian[row][column], finite_difference);
        }
    }
    entries.sort_by(|one, other| other.error().total_cmp(&one.error()));
    Ok(DerivativeReport { entries })
}

/// Everything at one point, as dense matrices.
struct Derivatives {
    objective: f64,
    gradient: Vec<f64>,
    constraints: Vec<f64>,
    jacobian: Vec<Vec<f64>>,
    hessian: Vec<Vec<f64>>,
    lagrangian_gradient: Vec<f64>,
}

impl Derivatives {
    fn at(problem: &mut dyn Problem, x: &[f64], multipliers: &[f64]) -> Result<Self, EvaluationError> {
        problem.set_point(x)?;
        let objective = problem.objective()?;
        let (mut gradient, mut constraints) = (vec![0.0; x.len()], vec![0.0; multipliers.len()]);
        problem.gradient(&mut gradient)?;
        problem.constraints(&mut constraints)?;
        let pattern = problem.jacobian_pattern();
        let mut values = vec![0.0; pattern.rows.len()];
        problem.jacobian(&mut values)?;
        let jacobian = dense(&pattern, &values, multipliers.len(), x.len());
        let pattern = problem.hessian_pattern();
        let mut values = vec![0.0; pattern.rows.len()];
        problem.hessian(1.0, multipliers, &mut values)?;
        let mut hessian = dense(&pattern, &values, x.len(), x.len());
        for row in 0..x.len() {
            for column in 0..row {
                hessian[column][row] = hessian[row][column];
            }
        }
        let mut lagrangian_gradient = gradient.clone();
        for (row, multiplier) in jacobian.iter().zip(multipliers) {
            lagrangian_gradient.iter_mut().zip(row).for_each(|(sum, entry)| *sum += multiplier * entry);
        }
        Ok(Self { objective, gradient, constraints, jacobian, hessian, lagrangian_gradient })
    }
}

fn dense(pattern: &Pattern, values: &[f64], rows: usize, columns: usize) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; columns]; rows];
    for ((&row, &column), value) in pattern.rows.iter().zip(&pattern.columns).zip(values) {
        matrix[row][column] += value;
    }
    matrix
}

//! Starting points and results of a solve.

use crate::problem::EvaluationError;
use crate::status::SolveStatus;

/// A primal-dual point.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Iterate {
    /// Variables.
    pub x: Vec<f64>,
    /// Multipliers of the constraints.
    pub constraint_multipliers: Vec<f64>,
    /// Multipliers of the lower bounds on the variables.
    pub lower_multipliers: Vec<f64>,
    /// Multipliers of the upper bounds on the variables.
    pub upper_multipliers: Vec<f64>,
}

/// The starting point of a solve.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// Values of the variables; Ipopt estimates the multipliers.
    Cold(Vec<f64>),
    /// A primal-dual point.
    Warm(Iterate),
}

/// One iteration, in the quantities of Ipopt's log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Number of the iteration, from 0.
    pub iteration: usize,
    /// Objective (in the restoration phase, of that phase's problem).
    pub objective: f64,
    /// Largest violation of the constraints.
    pub primal_infeasibility: f64,
    /// Largest violation of dual feasibility.
    pub dual_infeasibility: f64,
    /// Barrier parameter.
    pub mu: f64,
    /// Norm of the step.
    pub step_norm: f64,
    /// Regularisation of the Hessian.
    pub regularization: f64,
    /// Length of the dual step.
    pub alpha_dual: f64,
    /// Length of the primal step.
    pub alpha_primal: f64,
    /// Trial points of the line search.
    pub line_search_trials: usize,
    /// Whether the restoration phase is running.
    pub restoration: bool,
}

/// The decision of an observer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// Continue the solve.
    Continue,
    /// End the solve at the current iterate.
    Stop,
}

/// Wall seconds of a solve.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Timing {
    /// Total.
    pub total: f64,
    /// In the problem's functions.
    pub evaluation: f64,
    /// In factorisations of the KKT system and solves with the factors.
    pub linear_solver: f64,
}

/// Result of a solve.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The outcome.
    pub status: SolveStatus,
    /// The last iterate.
    pub iterate: Iterate,
    /// Objective at the last iterate.
    pub objective: f64,
    /// Constraints at the last iterate.
    pub constraints: Vec<f64>,
    /// Largest violation of a constraint or bound at the last iterate.
    pub constraint_violation: f64,
    /// Number of iterations.
    pub iterations: usize,
    /// All iterations.
    pub log: Vec<Progress>,
    /// Wall times.
    pub timing: Timing,
    /// The linear solver that ran.
    pub linear_solver: String,
    /// The last failure to evaluate the problem, if there was one.
    pub evaluation_error: Option<EvaluationError>,
}

//! What goes into a solve and what comes out.

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

/// Where a solve begins.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// At given variables; multipliers are estimated.
    Cold(Vec<f64>),
    /// At a primal-dual point.
    Warm(Iterate),
}

/// One iteration of the solver, in the quantities of Ipopt's log.
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

/// What an observer wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// To go on.
    Continue,
    /// To end the solve at the current iterate.
    Stop,
}

/// Wall seconds of a solve.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Timing {
    /// All of it.
    pub total: f64,
    /// Inside the problem's functions.
    pub evaluation: f64,
    /// Factorisations of the KKT system and solves with the factors.
    pub linear_solver: f64,
}

/// The end of a solve.
#[derive(Debug, Clone)]
pub struct Solution {
    /// How it ended.
    pub status: SolveStatus,
    /// The last iterate.
    pub iterate: Iterate,
    /// Objective there.
    pub objective: f64,
    /// Constraints there.
    pub constraints: Vec<f64>,
    /// Largest violation of a constraint or bound there.
    pub constraint_violation: f64,
    /// Number of iterations.
    pub iterations: usize,
    /// Every iteration.
    pub log: Vec<Progress>,
    /// Where the time went.
    pub timing: Timing,
    /// The linear solver that ran.
    pub linear_solver: String,
    /// Why the problem could not be evaluated, the last time that happened.
    pub evaluation_error: Option<EvaluationError>,
}

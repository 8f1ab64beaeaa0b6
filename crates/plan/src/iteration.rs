//! Homotopy steps as plans, `result.json` and checkpoints have them.

use std::sync::Arc;

use nlp::Iterate;
use ocp::{HomotopyStep, IterationEnd, IterationTiming};
use serde::{Deserialize, Serialize};
use task::{AssemblyTask, Horizon, Trajectory};

use crate::or_null;

/// A homotopy step of a plan.
#[derive(Debug, Clone)]
pub struct PlanIteration {
    /// Statistics of the solver.
    pub record: IterationRecord,
    /// The motion it found, for the task of the plan's [`crate::Variant`].
    pub trajectory: Trajectory,
    /// The final primal-dual point. An earlier run leaves only that of its last homotopy step.
    pub point: Option<Arc<Iterate>>,
}

impl PlanIteration {
    /// The data that decide whether another homotopy step follows.
    pub fn end(&self) -> IterationEnd<'_> {
        IterationEnd { converged: self.record.converged, tau: self.record.tau, motion: &self.trajectory }
    }
}

impl From<&HomotopyStep> for PlanIteration {
    fn from(iteration: &HomotopyStep) -> Self {
        let point = Some(Arc::new(iteration.iterate.clone()));
        Self { record: IterationRecord::from(iteration), trajectory: iteration.trajectory.clone(), point }
    }
}

/// One homotopy step, without its trajectory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct IterationRecord {
    /// Steps of its grid.
    pub steps: usize,
    /// Length of a step.
    pub time_step_s: f64,
    /// Smoothing of the distances.
    pub tau: f64,
    /// Relaxation of complementarity.
    pub sigma: f64,
    /// Ipopt's initial barrier parameter.
    pub mu_init: f64,
    /// How the solver ended, in words.
    pub status: String,
    /// Whether its end is a solution.
    pub converged: bool,
    /// The last failure to evaluate the problem.
    pub message: Option<String>,
    /// Iterations of the solver.
    pub iterations: usize,
    /// Cost.
    #[serde(with = "or_null")]
    pub objective: f64,
    /// Largest violation of a constraint or bound.
    #[serde(with = "or_null")]
    pub constraint_violation: f64,
    /// Deepest penetration of the exact shapes in any scenario.
    #[serde(with = "or_null")]
    pub max_penetration_m: f64,
    /// Wall time.
    pub wall_s: f64,
    /// Its wall time by part.
    pub wall_split_s: Split,
    /// The linear solver that ran.
    pub linear_solver: String,
    /// Statistics of the stage solver, if it ran.
    pub stage_solver: Option<StageSolverRecord>,
}

/// Statistics of the stage solver in a homotopy step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StageSolverRecord {
    /// Factorisations.
    pub factorisations: usize,
    /// Factorisations that were given up early because the inertia was wrong.
    pub early_exits: usize,
    /// Factorisations in which the poses of a stage could not be eliminated first.
    pub general_path: usize,
    /// Solves with the factors.
    pub solves: usize,
    /// Steps of iterative refinement.
    pub refinements: usize,
    /// Matrices that went to the general solver.
    pub fallbacks: Fallbacks,
    /// Largest relative residual of a solve.
    #[serde(with = "or_null")]
    pub largest_residual: f64,
    /// Largest growth of an element in a factorisation.
    #[serde(with = "or_null")]
    pub element_growth: f64,
    /// Wall time of factorisations.
    pub factorisation_s: f64,
    /// Wall time of solves.
    pub solve_s: f64,
}

/// Why matrices went to the general solver.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fallbacks {
    /// Its structure is not that of stages.
    pub structure: usize,
    /// A pivot whose sign rounding could change.
    pub uncertain_pivot: usize,
    /// A value that is not finite.
    pub not_finite: usize,
    /// A residual that refinement did not reduce.
    pub residual: usize,
    /// Ipopt asked for more accuracy.
    pub quality: usize,
}

/// Wall time by part (s).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Split {
    /// Distances and their derivatives.
    pub distances: f64,
    /// Model functions and assembly of the sparse matrices.
    pub model: f64,
    /// Factorisations and solves.
    pub linear_solver: f64,
    /// Ipopt's own work.
    pub rest: f64,
}

impl IterationRecord {
    /// Whether it has fewer steps than the task.
    pub fn is_coarse(&self, task: &AssemblyTask) -> bool {
        self.steps < task.horizon.steps
    }

    /// The task on the iteration's own grid.
    pub fn task(&self, task: &AssemblyTask) -> AssemblyTask {
        AssemblyTask { horizon: Horizon { steps: self.steps, time_step: self.time_step_s }, ..task.clone() }
    }

    /// Linear systems that the stage solver left to a general solver.
    pub fn fallbacks(&self) -> usize {
        self.stage_solver.as_ref().map_or(0, |solver| solver.fallbacks.total())
    }
}

impl Fallbacks {
    fn total(&self) -> usize {
        self.structure + self.uncertain_pivot + self.not_finite + self.residual + self.quality
    }
}

impl From<&HomotopyStep> for IterationRecord {
    fn from(result: &HomotopyStep) -> Self {
        let IterationTiming { total, distances, model, linear_solver, rest } = result.timing;
        Self {
            steps: result.trajectory.reference.len() - 1,
            time_step_s: result.trajectory.time_step,
            tau: result.smoothing.tau,
            sigma: result.smoothing.sigma,
            mu_init: result.smoothing.mu_init,
            status: result.status.to_string(),
            converged: result.status.is_success(),
            message: result.message.clone(),
            iterations: result.iterations,
            objective: result.objective,
            constraint_violation: result.constraint_violation,
            max_penetration_m: result.trajectory.max_penetration(),
            wall_s: total,
            wall_split_s: Split { distances, model, linear_solver, rest },
            linear_solver: result.linear_solver.clone(),
            stage_solver: result.stage_solver.as_ref().map(StageSolverRecord::from),
        }
    }
}

impl From<&kkt::Report> for StageSolverRecord {
    fn from(report: &kkt::Report) -> Self {
        let kkt::Fallbacks { structure, uncertain_pivot, not_finite, residual, quality } = report.fallbacks;
        Self {
            factorisations: report.factorisations,
            early_exits: report.early_exits,
            general_path: report.general_path,
            solves: report.solves,
            refinements: report.refinements,
            fallbacks: Fallbacks { structure, uncertain_pivot, not_finite, residual, quality },
            largest_residual: report.largest_residual,
            element_growth: report.element_growth,
            factorisation_s: report.factorisation_seconds,
            solve_s: report.solve_seconds,
        }
    }
}

//! Homotopy iterations in `result.json` and in checkpoints.

use ocp::{HomotopyIteration, IterationTiming};
use serde::{Deserialize, Serialize};

/// One homotopy iteration, without its trajectory.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Stage {
    tau: f64,
    sigma: f64,
    mu_init: f64,
    status: String,
    message: Option<String>,
    pub iterations: usize,
    objective: f64,
    constraint_violation: f64,
    /// Deepest overlap of the exact shapes in any scenario.
    pub max_penetration_m: f64,
    pub wall_s: f64,
    wall_split_s: Split,
    stage_solver: Option<StageSolver>,
}

/// What the stage solver did in a homotopy iteration.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct StageSolver {
    factorisations: usize,
    early_exits: usize,
    /// Factorisations in which the poses of a stage could not be eliminated first.
    general_path: usize,
    solves: usize,
    refinements: usize,
    fallbacks: Fallbacks,
    largest_residual: f64,
    element_growth: f64,
    factorisation_s: f64,
    solve_s: f64,
}

/// Why matrices went to the general solver.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Fallbacks {
    structure: usize,
    uncertain_pivot: usize,
    not_finite: usize,
    residual: usize,
    quality: usize,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Split {
    distances: f64,
    model: f64,
    linear_solver: f64,
    rest: f64,
}

impl Stage {
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

impl From<&HomotopyIteration> for Stage {
    fn from(result: &HomotopyIteration) -> Self {
        let IterationTiming { total, distances, model, linear_solver, rest } = result.timing;
        Self {
            tau: result.smoothing.tau,
            sigma: result.smoothing.sigma,
            mu_init: result.smoothing.mu_init,
            status: result.status.to_string(),
            message: result.message.clone(),
            iterations: result.iterations,
            objective: result.objective,
            constraint_violation: result.constraint_violation,
            max_penetration_m: result.trajectory.max_penetration(),
            wall_s: total,
            wall_split_s: Split { distances, model, linear_solver, rest },
            stage_solver: result.stage_solver.as_ref().map(StageSolver::from),
        }
    }
}

impl From<&kkt::Report> for StageSolver {
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

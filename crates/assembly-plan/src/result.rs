//! `result.json`.

use ocp::{StageResult, StageTiming, Trajectory};
use scene::{Scene, StartPose};
use serde::Serialize;
use simulation::Success;

use crate::robust::Report;

/// Everything that is known of a plan besides its trajectories.
#[derive(Debug, Serialize)]
pub struct PlanResult {
    status: String,
    converged: bool,
    goal_reached: bool,
    scene: String,
    start: String,
    delta_m: f64,
    linear_solver: String,
    /// Linear systems that the stage solver left to a general solver.
    linear_solver_fallbacks: usize,
    threads: usize,
    versions: Versions,
    iterations: usize,
    objective: f64,
    wall_s: f64,
    quaternion_drift: f64,
    stages: Vec<Stage>,
    scenarios: Vec<Scenario>,
    /// Of `solve --robust`; the scenarios are then rollouts with hard contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    robust: Option<Report>,
}

#[derive(Debug, Serialize)]
struct Versions {
    assembly_plan: &'static str,
    ipopt: &'static str,
}

#[derive(Debug, Serialize)]
struct Stage {
    tau: f64,
    sigma: f64,
    mu_init: f64,
    status: String,
    message: Option<String>,
    iterations: usize,
    objective: f64,
    constraint_violation: f64,
    wall_s: f64,
    wall_split_s: Split,
    stage_solver: Option<StageSolver>,
}

/// What the stage solver did in a homotopy iteration.
#[derive(Debug, Serialize)]
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
#[derive(Debug, Serialize)]
struct Fallbacks {
    structure: usize,
    uncertain_pivot: usize,
    not_finite: usize,
    residual: usize,
    quality: usize,
}

#[derive(Debug, Serialize)]
struct Split {
    distances: f64,
    model: f64,
    linear_solver: f64,
    rest: f64,
}

#[derive(Debug, Serialize)]
struct Scenario {
    offset_m: [f64; 3],
    position_error_m: f64,
    orientation_error_rad: f64,
    max_penetration_m: f64,
    max_force_n: f64,
}

impl PlanResult {
    /// From all homotopy iterations that ran, of which there is at least one, and the trajectory that is the plan.
    pub fn new(
        scene: &Scene,
        start: &StartPose,
        delta: f64,
        planned: usize,
        stages: &[StageResult],
        trajectory: &Trajectory,
        robust: Option<Report>,
    ) -> Self {
        let last = &stages[stages.len() - 1];
        let (position, orientation) = trajectory.worst_errors();
        let converged = stages.len() == planned && last.status.is_success();
        let goal_reached = Success::default().reached(position, orientation);
        let status = match (&robust, converged, goal_reached) {
            (Some(report), ..) if report.is_reached() => "done".to_owned(),
            (Some(_), ..) => "the wanted rate of success is not reached".to_owned(),
            (None, true, true) => "done".to_owned(),
            (None, true, false) => "converged, but the goal is not reached".to_owned(),
            (None, false, _) => format!("stage {}: {}", stages.len(), last.status),
        };
        Self {
            status,
            converged,
            goal_reached,
            scene: scene.title.clone(),
            start: start.name.clone(),
            delta_m: delta,
            linear_solver: last.linear_solver.clone(),
            linear_solver_fallbacks: stages.iter().map(StageResult::fallbacks).sum(),
            threads: 1,
            versions: Versions { assembly_plan: env!("CARGO_PKG_VERSION"), ipopt: nlp::IPOPT_VERSION },
            iterations: stages.iter().map(|stage| stage.iterations).sum(),
            objective: last.objective,
            wall_s: stages.iter().map(|stage| stage.timing.total).sum(),
            quaternion_drift: trajectory.quaternion_drift,
            stages: stages.iter().map(stage).collect(),
            scenarios: trajectory.scenarios.iter().map(scenario).collect(),
            robust,
        }
    }

    /// Whether the plan converged and every scenario ends at the goal, or a robust one reaches the wanted rate.
    pub fn is_done(&self) -> bool {
        self.robust.as_ref().map_or(self.converged && self.goal_reached, Report::is_reached)
    }

    /// What happened, in a few lines.
    pub fn summary(&self) -> String {
        let mut lines = vec![format!(
            "{}: {}; objective {:.4}, {} iterations, {:.1} s, linear solver {}{}",
            self.scene,
            self.status,
            self.objective,
            self.iterations,
            self.wall_s,
            self.linear_solver,
            match self.linear_solver_fallbacks {
                0 => String::new(),
                count => format!(" ({count} systems left to the general solver)"),
            }
        )];
        for (index, scenario) in self.scenarios.iter().enumerate() {
            let [x, y, z] = scenario.offset_m.map(|component| 1e3 * component);
            lines.push(format!(
                "  scenario {} (offset {x:.1} {y:.1} {z:.1} mm): ends {:.2} mm and {:.4} rad from the goal, overlaps at \
                 most {:.2} mm, pushes at most {:.1} N",
                index + 1,
                1e3 * scenario.position_error_m,
                scenario.orientation_error_rad,
                1e3 * scenario.max_penetration_m,
                scenario.max_force_n
            ));
        }
        lines.extend(self.robust.as_ref().map(Report::summary));
        lines.join("\n")
    }
}

fn stage(result: &StageResult) -> Stage {
    let StageTiming { total, distances, model, linear_solver, rest } = result.timing;
    Stage {
        tau: result.smoothing.tau,
        sigma: result.smoothing.sigma,
        mu_init: result.smoothing.mu_init,
        status: result.status.to_string(),
        message: result.message.clone(),
        iterations: result.iterations,
        objective: result.objective,
        constraint_violation: result.constraint_violation,
        wall_s: total,
        wall_split_s: Split { distances, model, linear_solver, rest },
        stage_solver: result.stage_solver.as_ref().map(stage_solver),
    }
}

fn stage_solver(report: &kkt::Report) -> StageSolver {
    let kkt::Fallbacks { structure, uncertain_pivot, not_finite, residual, quality } = report.fallbacks;
    StageSolver {
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

fn scenario(motion: &ocp::ScenarioTrajectory) -> Scenario {
    Scenario {
        offset_m: motion.offset,
        position_error_m: motion.quality.position_error,
        orientation_error_rad: motion.quality.orientation_error,
        max_penetration_m: motion.quality.max_penetration,
        max_force_n: motion.quality.max_force,
    }
}

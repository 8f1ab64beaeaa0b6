//! `result.json`.

use serde::Serialize;
use simulation::Success;
use task::{AssemblyTask, Limits, Peak, ScenarioTrajectory};

use crate::limits;
use crate::planned::Planned;
use crate::problem::Problem;
use crate::robust::Report;
use crate::stage::Stage;

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
    /// What the user was warned of.
    warnings: Vec<String>,
    /// Largest components allowed, null where there is no limit.
    #[serde(with = "LimitsRecord")]
    limits: Limits,
    /// Largest components of the reference and of all scenarios.
    #[serde(with = "LimitsRecord")]
    reached: Limits,
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
struct Scenario {
    offset_m: [f64; 3],
    position_error_m: f64,
    orientation_error_rad: f64,
    /// Deepest overlap of the exact shapes.
    max_penetration_m: f64,
    max_penetration_at: Option<Place>,
    /// Largest product of a contact force and the exact distance at the end of its step.
    max_complementarity_nm: f64,
    max_complementarity_at: Option<Place>,
    max_force_n: f64,
    /// Largest components.
    #[serde(with = "LimitsRecord")]
    reached: Limits,
}

/// Where along a plan something is largest.
#[derive(Debug, Serialize)]
struct Place {
    time_s: f64,
    step: usize,
    pair: String,
}

/// How [`Limits`] are written; infinity as null.
#[derive(Debug, Serialize)]
#[serde(remote = "Limits")]
struct LimitsRecord {
    #[serde(rename = "translational_velocity_m_s")]
    translational_velocity: f64,
    #[serde(rename = "rotational_velocity_rad_s")]
    rotational_velocity: f64,
    #[serde(rename = "translational_acceleration_m_s2")]
    translational_acceleration: f64,
    #[serde(rename = "rotational_acceleration_rad_s2")]
    rotational_acceleration: f64,
    #[serde(rename = "contact_force_n")]
    contact_force: f64,
    #[serde(rename = "force_n")]
    force: f64,
    #[serde(rename = "torque_nm")]
    torque: f64,
}

impl PlanResult {
    /// Of a plan, what counts as success, and what the user was warned of.
    pub fn new(problem: &Problem, plan: Planned, success: &Success, warnings: Vec<String>) -> Self {
        let Planned { stages, last, trajectory, task, report: robust } = plan;
        let (position, orientation) = trajectory.worst_errors();
        let converged = stages.len() == problem.homotopy.iterations && last.status.is_success();
        let goal_reached = success.reached(position, orientation);
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
            scene: problem.scene.title.clone(),
            start: problem.start.name.clone(),
            delta_m: problem.delta,
            linear_solver: last.linear_solver.clone(),
            linear_solver_fallbacks: stages.iter().map(Stage::fallbacks).sum(),
            threads: 1,
            versions: Versions { assembly_plan: env!("CARGO_PKG_VERSION"), ipopt: nlp::IPOPT_VERSION },
            iterations: stages.iter().map(|stage| stage.iterations).sum(),
            objective: last.objective,
            wall_s: stages.iter().map(|stage| stage.wall_s).sum(),
            quaternion_drift: trajectory.quaternion_drift,
            warnings,
            limits: problem.task.limits,
            reached: trajectory.keeps(),
            stages,
            scenarios: trajectory.scenarios.iter().map(|motion| scenario(motion, &task)).collect(),
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
        lines.extend(limits::summary(&self.limits, &self.reached));
        lines.extend(self.robust.as_ref().map(Report::summary));
        lines.join("\n")
    }
}

fn scenario(motion: &ScenarioTrajectory, task: &AssemblyTask) -> Scenario {
    let quality = &motion.quality;
    let value = |peak: Option<Peak>| peak.map_or(0.0, |peak| peak.value);
    let place = |peak: Option<Peak>| {
        peak.map(|Peak { step, pair, .. }| Place {
            time_s: step as f64 * task.horizon.time_step,
            step,
            pair: task.pairs[pair].to_string(),
        })
    };
    Scenario {
        offset_m: motion.offset,
        position_error_m: quality.position_error,
        orientation_error_rad: quality.orientation_error,
        max_penetration_m: value(quality.penetration),
        max_penetration_at: place(quality.penetration),
        max_complementarity_nm: value(quality.complementarity),
        max_complementarity_at: place(quality.complementarity),
        max_force_n: quality.max_force,
        reached: motion.keeps,
    }
}

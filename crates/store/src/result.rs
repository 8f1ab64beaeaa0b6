//! `result.json`: everything that is known of a plan besides its motions.

use std::collections::BTreeMap;

use diagnosis::explain::{self, FailureExplanation};
use diagnosis::warnings;
use plan::records::{AdmittanceRecord, AttemptRecord, GraspRecord, MotionRecord};
use plan::{
    Format, IterationRecord, Outcome, Plan, PlanStatus, Problem, RobustnessReport, TestReport, VERSION, hash, or_null,
};
use serde::{Deserialize, Serialize};
use task::{AssemblyTask, Limits, Peak, ScenarioTrajectory};

use crate::coverage::CoverageRecord;

/// Name of the file, which is written last: its presence marks a whole plan.
pub const RESULT: &str = "result.json";

/// Everything that is known of a plan besides its motions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanResult {
    /// Format of the file.
    #[serde(default)]
    pub format: Format,
    /// Status of the plan, in words.
    pub status: String,
    /// The same, without details.
    pub outcome: Outcome,
    /// Whether it is a robust plan that has passed its rollouts.
    pub done: bool,
    /// Whether it is the plan of a solver that converged and reaches the goal from every planned offset in its smoothed model;
    /// such a plan was not refined.
    pub planned: bool,
    /// Whether the solver converged.
    pub converged: bool,
    /// Whether every planned offset reaches the goal; of a robust plan, at every friction.
    pub goal_reached: bool,
    /// Title of the scene.
    pub scene: String,
    /// Name of the start pose.
    pub start: String,
    /// Offset magnitude `delta-hat`.
    pub delta_m: f64,
    /// Which offsets the plan covers.
    #[serde(default)]
    pub coverage: CoverageRecord,
    /// Largest rotation error of the part in the gripper that was required.
    #[serde(default)]
    pub turn_rad: f64,
    /// Inputs of the plan.
    pub made_from: MadeFrom,
    /// The linear solver that ran.
    pub linear_solver: String,
    /// Linear systems that the stage solver left to a general solver.
    pub linear_solver_fallbacks: usize,
    /// Threads of a solve.
    pub threads: usize,
    /// Versions.
    pub versions: Versions,
    /// Iterations of the solver in all homotopy steps.
    pub iterations: usize,
    /// Number, from 1, of the homotopy step that is the plan, unless it was refined.
    pub chosen_stage: usize,
    /// Its cost.
    #[serde(with = "or_null")]
    pub objective: f64,
    /// Wall time of all homotopy steps.
    pub wall_s: f64,
    /// Largest deviation of a quaternion's norm from 1 before normalisation.
    #[serde(with = "or_null")]
    pub quaternion_drift: f64,
    /// Time between two rows of the reference.
    pub time_step_s: f64,
    /// Stiffness for the execution of the plan; `resolved.toml` has the damping too.
    pub gains: Gains,
    /// The admittance law of a robot that is commanded by position or force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub admittance: Option<AdmittanceRecord>,
    /// Warnings.
    pub warnings: Vec<String>,
    /// Duration, forces and departures of its motion; missing in plans of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionRecord>,
    /// Largest components allowed, null where there is no limit.
    pub limits: LimitsRecord,
    /// Largest components of the reference and of all scenarios.
    pub reached: LimitsRecord,
    /// How deep the exact shapes may penetrate in a plan that is done.
    #[serde(default, alias = "max_overlap_m")]
    pub allowed_penetration_m: f64,
    /// Attempts until a plan reached the goal, if there were several.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub attempts: Vec<AttemptRecord>,
    /// Homotopy steps.
    pub stages: Vec<IterationRecord>,
    /// Every planned grasp error.
    pub scenarios: Vec<ScenarioRecord>,
    /// Why the plan is not done; of `solve --robust`, that is in its own section.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explanation: Option<FailureExplanation>,
    /// How the plan of a solver does in rollouts with hard contact, where it was played.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tested: Option<TestReport>,
    /// Report of `solve --robust`; the scenarios are then rollouts with hard contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robust: Option<RobustnessReport>,
    /// Hash (SHA-256, hexadecimal) of every other file of the plan, by its path in the folder.
    pub files: BTreeMap<String, String>,
}

/// Key of the hash of a result, which only its text has.
const SEAL: &str = "\"seal\":";

/// Place of the hash in the text of a result, if it has one.
fn place_of_seal(text: &str) -> Option<std::ops::Range<usize>> {
    let key = text.rfind(SEAL)? + SEAL.len();
    let start = key + text[key..].find('"')? + 1;
    Some(start..start + text[start..].find('"')?)
}

/// The text of a result with the hash of itself, without that hash.
pub fn sealed(mut text: String) -> String {
    if place_of_seal(&text).is_none() {
        let object = text.trim_end();
        let end = object.strip_suffix('}').unwrap_or(object).trim_end().len();
        text.replace_range(end.., &format!(",\n  {SEAL} \"\"\n}}"));
    }
    if let Some(place) = place_of_seal(&text) {
        text.replace_range(place.clone(), "");
        let seal = hash(text.as_bytes());
        text.insert_str(place.start, &seal);
    }
    text
}

/// Why a result is not the text that was written, if so.
pub fn problem_of_seal(text: &str) -> Option<&'static str> {
    if place_of_seal(text).is_none() {
        return Some("has no seal: it was edited, or written by version 0.1; solve again");
    }
    (sealed(text.to_owned()) != text).then_some("was changed since the plan was written; restore it, or solve again")
}

/// Stiffness of the controller.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Gains {
    /// Along every axis.
    pub translational_stiffness_n_m: f64,
    /// About every axis.
    pub rotational_stiffness_nm_rad: f64,
}

/// Inputs of a plan, as hashes (SHA-256, hexadecimal).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MadeFrom {
    /// [`Problem::identity`].
    pub problem: String,
    /// [`Problem::shapes_hash`].
    pub shapes: String,
    /// [`Problem::settings_hash`].
    pub settings: String,
}

impl From<&Problem> for MadeFrom {
    fn from(problem: &Problem) -> Self {
        let (shapes, settings) = (problem.shapes_hash(), problem.settings_hash());
        Self { problem: problem.identity().to_owned(), shapes, settings }
    }
}

/// Versions of the programs that made a plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Versions {
    /// Of this program.
    pub assembly_plan: String,
    /// Of Ipopt.
    pub ipopt: String,
}

/// How a scenario ends, how deep its shapes penetrate and how hard they push.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScenarioRecord {
    /// The grasp error.
    #[serde(flatten)]
    pub grasp: GraspRecord,
    /// Final distance from the goal.
    #[serde(with = "or_null")]
    pub position_error_m: f64,
    /// Final angle to the goal.
    #[serde(with = "or_null")]
    pub orientation_error_rad: f64,
    /// Deepest penetration of the exact shapes.
    #[serde(with = "or_null")]
    pub max_penetration_m: f64,
    /// Where that is.
    pub max_penetration_at: Option<Place>,
    /// Largest product of a contact force and the exact distance at the end of its step.
    #[serde(with = "or_null")]
    pub max_complementarity_nm: f64,
    /// Where that is.
    pub max_complementarity_at: Option<Place>,
    /// Largest contact force, the mean over 10 ms.
    #[serde(with = "or_null")]
    pub max_force_n: f64,
    /// Largest components.
    pub reached: LimitsRecord,
}

/// Place along a plan where a value is largest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Time.
    pub time_s: f64,
    /// Step, 0 for the start.
    pub step: usize,
    /// Body and environment part.
    pub pair: String,
}

/// [`Limits`]; infinity is null.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names of [limits] with their units")]
pub struct LimitsRecord {
    #[serde(with = "or_null")]
    pub translational_velocity_m_s: f64,
    #[serde(with = "or_null")]
    pub rotational_velocity_rad_s: f64,
    #[serde(with = "or_null")]
    pub translational_acceleration_m_s2: f64,
    #[serde(with = "or_null")]
    pub rotational_acceleration_rad_s2: f64,
    #[serde(with = "or_null")]
    pub contact_force_n: f64,
    #[serde(with = "or_null")]
    pub force_n: f64,
    #[serde(with = "or_null")]
    pub torque_nm: f64,
}

impl From<Limits> for LimitsRecord {
    fn from(limits: Limits) -> Self {
        Self {
            translational_velocity_m_s: limits.translational_velocity,
            rotational_velocity_rad_s: limits.rotational_velocity,
            translational_acceleration_m_s2: limits.translational_acceleration,
            rotational_acceleration_rad_s2: limits.rotational_acceleration,
            contact_force_n: limits.contact_force,
            force_n: limits.force,
            torque_nm: limits.torque,
        }
    }
}

impl LimitsRecord {
    /// Every limit with its name in scene files and its unit.
    pub fn named(&self) -> [(&'static str, &'static str, f64); 7] {
        Limits::from(*self).named()
    }
}

impl From<LimitsRecord> for Limits {
    fn from(record: LimitsRecord) -> Self {
        Self {
            translational_velocity: record.translational_velocity_m_s,
            rotational_velocity: record.rotational_velocity_rad_s,
            translational_acceleration: record.translational_acceleration_m_s2,
            rotational_acceleration: record.rotational_acceleration_rad_s2,
            contact_force: record.contact_force_n,
            force: record.force_n,
            torque: record.torque_nm,
        }
    }
}

impl PlanResult {
    /// Whether it is the solver's, which did not converge. Rollouts decide about a refined plan.
    pub fn is_unconverged(&self) -> bool {
        !self.converged && self.robust.is_none()
    }

    /// Whether times, errors and extremes of all scenarios are finite, and the cost of a plan that was not refined.
    pub fn is_finite(&self) -> bool {
        let scenarios = self.scenarios.iter().flat_map(|scenario| {
            let ScenarioRecord { position_error_m, orientation_error_rad, max_penetration_m, max_force_n, .. } =
                scenario;
            [*position_error_m, *orientation_error_rad, *max_penetration_m, *max_force_n]
        });
        let objective = if self.robust.is_some() { 0.0 } else { self.objective };
        let values = [objective, self.delta_m, self.wall_s, self.time_step_s];
        values.into_iter().chain(scenarios).all(f64::is_finite)
    }

    /// The result of a plan whose files have these hashes.
    pub fn new(plan: &Plan, files: BTreeMap<String, String>) -> Self {
        let status = plan.status();
        let records = || plan.iterations.iter().map(|iteration| &iteration.record);
        let chosen = &plan.chosen().record;
        Self {
            format: Format::CURRENT,
            outcome: status.outcome(),
            done: status == PlanStatus::Done,
            planned: status == PlanStatus::Planned,
            status: status.to_string(),
            converged: plan.is_converged(),
            goal_reached: plan.reaches_goal(),
            scene: plan.problem.scene().title.clone(),
            start: plan.problem.start().name.clone(),
            delta_m: plan.problem.offset_magnitude(),
            coverage: CoverageRecord::from(&plan.problem),
            turn_rad: plan.problem.scene().robustness.rotation_error,
            made_from: MadeFrom::from(&plan.problem),
            linear_solver: chosen.linear_solver.clone(),
            linear_solver_fallbacks: records().map(IterationRecord::fallbacks).sum(),
            threads: plan.threads,
            versions: Versions { assembly_plan: VERSION.to_owned(), ipopt: nlp::IPOPT_VERSION.to_owned() },
            iterations: records().map(|record| record.iterations).sum(),
            chosen_stage: plan.chosen_stage(),
            objective: chosen.objective,
            wall_s: records().map(|record| record.wall_s).sum(),
            quaternion_drift: plan.trajectory.quaternion_drift,
            time_step_s: plan.trajectory.time_step,
            gains: Gains {
                translational_stiffness_n_m: plan.task.impedance.translational_stiffness,
                rotational_stiffness_nm_rad: plan.task.impedance.rotational_stiffness,
            },
            admittance: plan.problem.scene().position_robot.as_ref().map(AdmittanceRecord::from),
            warnings: [warnings::of_problem(&plan.problem), warnings::of_plan(plan)].concat(),
            motion: Some(plan.motion()),
            limits: plan.task.limits.into(),
            reached: plan.trajectory.keeps().into(),
            allowed_penetration_m: plan.problem.allowed_penetration(),
            attempts: plan.attempts.iter().filter(|_| plan.attempts.len() > 1).cloned().collect(),
            stages: records().cloned().collect(),
            scenarios: plan.trajectory.scenarios.iter().map(|motion| scenario(motion, &plan.task)).collect(),
            explanation: explain::explanation(plan),
            tested: plan.tested.clone(),
            robust: plan.robustness.clone(),
            files,
        }
    }
}

fn scenario(motion: &ScenarioTrajectory, task: &AssemblyTask) -> ScenarioRecord {
    let quality = &motion.quality;
    let value = |peak: Option<Peak>| peak.map_or(0.0, |peak| peak.value);
    let place = |peak: Option<Peak>| {
        peak.map(|Peak { step, pair, .. }| Place {
            time_s: step as f64 * task.horizon.time_step,
            step,
            pair: task.pairs[pair].to_string(),
        })
    };
    ScenarioRecord {
        grasp: GraspRecord::from(&motion.grasp),
        position_error_m: quality.position_error,
        orientation_error_rad: quality.orientation_error,
        max_penetration_m: value(quality.penetration),
        max_penetration_at: place(quality.penetration),
        max_complementarity_nm: value(quality.complementarity),
        max_complementarity_at: place(quality.complementarity),
        max_force_n: quality.max_force,
        reached: motion.keeps.into(),
    }
}

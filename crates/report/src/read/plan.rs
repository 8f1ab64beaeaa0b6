//! A plan: its parts, its motion, its homotopy and its rollouts with hard contact.

use std::path::{Path, PathBuf};

use plan::records::LossRecord;
use plan::{Format, Millimetres, PlannerError, Problem, RobustnessTarget, VERSION};
use scene::{Part, RobustnessSpec};
use simulation::{Injection, Settings, Solid};
use store::trajectory::read_tables;
use store::{CoverageRecord, MotionTables, PlanResult, STAGES, ScenarioRecord, StoredPlan};
use task::GraspError;

use super::motion::{HARD, Measures, World};
use super::{arm, executed, simulation as rates, tolerance};
use crate::model::{ErrorsData, MotionData, PartData, PlanData, Source};
use crate::rounded::{LENGTH, rounded};

/// Reads the plan of a folder and logs of its executions, and computes what they do not hold.
///
/// # Errors
/// When the plan is damaged, is of an older format or has no homotopy steps, or its arm cannot be simulated;
/// when a log cannot be compared with it.
pub fn read(folder: &Path, logs: &[PathBuf]) -> Result<PlanData, PlannerError> {
    let plan = StoredPlan::open(folder)?;
    require_readable(&plan)?;
    let problem = plan.problem()?;
    let world = World::new(problem.scene().all_pairs(), problem.task().goal, problem.success());
    let tables = read_tables(folder)?;
    let mut motions = Vec::new();
    if plan.result.robust.is_none() {
        motions.push(planned(&plan.result, &tables, &problem, &world)?);
    }
    motions.extend(rollouts(&plan, &problem, &world)?);
    motions.extend(iterations(&plan, &world)?);
    motions.extend(executed::motions(logs, &plan, &problem, &world)?);
    let simulation = rates::read_if_there(folder)?;
    let (tolerated, other_plan) = tolerance::of_plan(&plan)?;
    let mut result = plan.result;
    result.files.clear();
    Ok(PlanData {
        goal: problem.task().goal,
        tolerance: [problem.success().position, problem.success().orientation],
        made_from: made_from(&problem, &tables),
        body: problem.scene().body.iter().map(part).collect(),
        environment: problem.scene().environment.iter().map(part).collect(),
        pairs: world.names(),
        joints: arm::joints(&problem),
        engagement_depth: problem.engagement().depth_m.map(|depth| rounded(depth, LENGTH)),
        errors: errors(&problem.scene().robustness),
        motions,
        notes: result.warnings.iter().cloned().chain(other_plan).chain(why_not_done(&result)).collect(),
        weakest: loss(&result).map_or_else(Vec::new, |loss| loss.sentences().into()),
        simulation,
        tolerated,
        result,
    })
}

/// Refuses plans of older formats and plans without homotopy steps.
fn require_readable(plan: &StoredPlan) -> Result<(), PlannerError> {
    if plan.result.format != Format::CURRENT {
        let written = &plan.result.versions.assembly_plan;
        let problem =
            format!("was written by version {written} and this is {VERSION}; solve again, or use that version");
        return Err(PlannerError::file(&plan.folder, problem));
    }
    match plan.folder.join(STAGES).is_dir() && !plan.result.stages.is_empty() {
        true => Ok(()),
        false => {
            Err(PlannerError::file(&plan.folder.join(STAGES), "holds no homotopy steps; restore it, or solve again"))
        }
    }
}

fn why_not_done(result: &PlanResult) -> Vec<String> {
    result.explanation.as_ref().map_or_else(Vec::new, |explanation| explanation.sentences(result.converged))
}

fn loss(result: &PlanResult) -> Option<&LossRecord> {
    result.robust.as_ref()?.loss.as_ref()
}

/// Smoothing with which the distances of the plan were written.
fn plan_tau(result: &PlanResult) -> f64 {
    let chosen = result.chosen_stage.checked_sub(1).and_then(|index| result.stages.get(index));
    chosen.map_or(HARD, |stage| stage.tau)
}

/// The plan as the solver sees it.
fn planned(
    result: &PlanResult,
    tables: &MotionTables,
    problem: &Problem,
    world: &World,
) -> Result<MotionData, PlannerError> {
    let measures = |scenario: &ScenarioRecord| Measures {
        errors: [scenario.position_error_m, scenario.orientation_error_rad],
        max_force: scenario.max_force_n,
    };
    let measures: Vec<Measures> = result.scenarios.iter().map(measures).collect();
    let grasps: Vec<GraspError> = result.scenarios.iter().map(|scenario| GraspError::from(&scenario.grasp)).collect();
    let mut motion = world.motion(tables, &measures, Source::Plan, plan_tau(result))?;
    motion.courses = arm::courses(problem, tables, &grasps);
    Ok(motion)
}

fn iterations(plan: &StoredPlan, world: &World) -> Result<Vec<MotionData>, PlannerError> {
    let folder = plan.folder.join(STAGES);
    let iteration = |(number, tau): (usize, f64)| {
        let tables = read_tables(&folder.join(number.to_string()))?;
        world.motion(&tables, &world.measures(&tables), Source::Iteration { number, tau }, tau)
    };
    (1..).zip(plan.result.stages.iter().map(|stage| stage.tau)).map(iteration).collect()
}

/// Rollouts of the planned offsets with hard contact at each friction that the scene names, and that of the errors that a
/// plan which is not robust loses most.
fn rollouts(plan: &StoredPlan, problem: &Problem, world: &World) -> Result<Vec<MotionData>, PlannerError> {
    let reference = plan.reference()?;
    let planned = GraspError::distinct(problem.task().grasps.clone());
    let planned: Vec<Injection> = planned.into_iter().map(Injection::from).collect();
    let at_friction = |friction: f64| {
        let settings = Settings { friction, ..Settings::default() };
        let lost = loss(&plan.result).filter(|loss| loss.worst.friction == friction);
        let lost = lost.filter(|loss| !planned.contains(&loss.injection()));
        let injections: Vec<Injection> = planned.iter().copied().chain(lost.map(LossRecord::injection)).collect();
        let played = problem.rollout(settings)?.trajectory(&reference, &injections, HARD);
        let measures: Vec<Measures> = played.scenarios.iter().map(|motion| Measures::from(&motion.quality)).collect();
        let (tables, grasps) = (world.tables(played), injections.iter().map(|injection| injection.grasp));
        let mut motion = world.motion(&tables, &measures, Source::Rollouts { friction }, HARD)?;
        motion.courses = arm::courses(problem, &tables, &grasps.collect::<Vec<_>>());
        if let (Some(loss), Some(scenario)) = (lost, motion.scenarios.last_mut()) {
            scenario.disturbances = loss.disturbance_in_words();
        }
        Ok(motion)
    };
    RobustnessTarget::of(&problem.scene().robustness).frictions.into_iter().map(at_friction).collect()
}

fn part(part: &Part) -> PartData {
    let solid = Solid::new(&part.shape);
    PartData {
        name: part.name.clone(),
        vertices: solid.vertices.iter().flatten().map(|&coordinate| rounded(coordinate, LENGTH)).collect(),
        facets: solid.facets.into_iter().map(|facet| facet.corners).collect(),
    }
}

/// Errors that rollouts vary besides offsets.
fn errors(spec: &RobustnessSpec) -> ErrorsData {
    let percent = |error: f64| format!("\u{b1}{:.0} %", 100.0 * error);
    let all = [
        (
            "rotation errors in the gripper",
            spec.rotation_error,
            format!("of up to {:.1}\u{b0}", spec.rotation_error.to_degrees()),
        ),
        ("errors of the inertia", spec.inertia_error, format!("of {}", percent(spec.inertia_error))),
        ("errors of the stiffness", spec.stiffness_error, format!("of {}", percent(spec.stiffness_error))),
        ("errors of the measured force", spec.bias[0], format!("of up to {:.1} N", spec.bias[0])),
        ("errors of the measured torque", spec.bias[1], format!("of up to {:.2} Nm", spec.bias[1])),
        ("delays of the controller", spec.delay, format!("of up to {:.1} ms", 1e3 * spec.delay)),
    ];
    let (varied, left_out): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, size, _)| *size > 0.0);
    ErrorsData {
        varied: varied.into_iter().map(|(name, _, words)| format!("{name} {words}")).collect(),
        left_out: left_out.into_iter().map(|(name, ..)| name.to_owned()).collect(),
    }
}

/// Settings of the plan, each as a name and a value in words.
fn made_from(problem: &Problem, tables: &MotionTables) -> Vec<[String; 2]> {
    let (scene, task) = (problem.scene(), problem.task());
    let count = |parts: &[Part]| match parts.len() {
        1 => "1 convex part".to_owned(),
        count => format!("{count} convex parts"),
    };
    let steps = tables.reference.len() - 1;
    let time = steps as f64 * tables.time_step;
    let mut facts = vec![
        ("body", count(&scene.body)),
        ("environment", count(&scene.environment)),
        ("pairs that may touch", format!("{} of {}", scene.pairs.len(), scene.body.len() * scene.environment.len())),
        ("clearance at the goal", format!("{:.3} mm", 1e3 * task.clearance(&task.goal))),
        ("planned offsets", format!("{} of {} mm", task.grasps.len(), Millimetres(problem.offset_magnitude()))),
        ("offsets covered", CoverageRecord::from(problem).to_string()),
        ("horizon", format!("{steps} steps of {} s, {time:.2} s", tables.time_step)),
        ("translational stiffness", format!("{:.1} N/m", task.impedance.translational_stiffness)),
        ("rotational stiffness", format!("{:.2} Nm/rad", task.impedance.rotational_stiffness)),
        ("friction in the plan", task.frictions.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")),
    ];
    if let Some(mass) = task.inertia.mass() {
        facts.push(("mass", format!("{mass:.3} kg")));
    }
    if let Some(robot) = &scene.robot {
        let file = robot.urdf.file_name().unwrap_or_default().to_string_lossy().into_owned();
        facts.push(("arm", format!("{file}, {} joints", robot.arm.joints().len())));
    }
    facts.into_iter().map(|(name, value)| [name.to_owned(), value]).collect()
}

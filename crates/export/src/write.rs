//! Writes the folder of an export.

use std::path::{Path, PathBuf};

use plan::{PlannerError, hash};
use store::{RESULT, StoredPlan, read_bytes, require_folder};

use crate::document::{Document, Exported};
use crate::folder::{ExportFolder, SUMS};
use crate::frames::Frames;
use crate::model::{Content, Model};
use crate::readme::readme;
use crate::ros2_control::Parameters;
use crate::smooth::SmoothReference;
use crate::target::Target;
use crate::text::plain;
use crate::trajectory::{resample, trajectory_csv};
use crate::trial::{LEAST_RATE, TrialRecord};
use crate::urscript::script;
use crate::wrench::wrench_csv;

/// Name of the file that describes an export.
pub const DOCUMENT: &str = "plan.json";
/// The reference of the tool at the rate of the robot.
pub const TRAJECTORY: &str = "trajectory.csv";
/// Expected wrench of the controller at the tool point.
pub const WRENCH: &str = "wrench.csv";
/// Explains the folder.
pub const README: &str = "README.md";
/// The script of `urscript`.
pub const SCRIPT: &str = "plan.script";
/// Parameters of the controllers of `ros2-control`.
pub const PARAMETERS: &str = "controllers.yaml";

/// A request for an export.
#[derive(Debug, Clone)]
pub struct Request<'path> {
    /// Folder of the plan.
    pub plan: &'path Path,
    /// Its target.
    pub target: Target,
    /// Samples per second (Hz).
    pub rate: f64,
    /// Folder to write; by default `export/TARGET` in that of the plan.
    pub out: Option<&'path Path>,
    /// Also export a plan that is not done, or succeeds too rarely in rollouts.
    pub anyway: bool,
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The folder.
    pub folder: PathBuf,
    /// Names of its files.
    pub files: Vec<String>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}

/// Exports a plan.
///
/// # Errors
/// When the plan is not whole, was changed, is not done or succeeds too rarely in rollouts, lacks what the target needs, or a
/// file would be replaced that is not from an earlier export. Then nothing is written.
pub fn write(request: &Request) -> Result<Written, PlannerError> {
    let plan = StoredPlan::open(request.plan)?;
    let problem = plan.problem()?;
    let target = request.out.map_or_else(|| plan.folder.join("export").join(request.target.name()), Path::to_owned);
    require_interface(&plan, problem.scene(), request.target)?;
    if request.target.is_model() {
        require_folder(&target)?;
        return fill(target, &Model::new(&plan, &problem)?.files(request.target)?, Vec::new());
    }
    require_done(&plan, request.anyway)?;
    require_arm(&plan, problem.scene(), request.target)?;
    let parameters = parameters(&plan, problem.scene(), request.target)?;
    require_folder(&target)?;

    let (reference, frames) = (plan.reference()?, Frames::of(problem.scene()));
    let smooth = SmoothReference::new(&reference);
    let states = resample(&smooth, &frames, request.rate)?;
    let trial = TrialRecord::new(&plan, &problem, &smooth)?;
    require_success(&plan, &trial, request.anyway)?;
    let anyway = request.anyway && (!plan.result.done || !trial.low_rates().is_empty());
    let (result, reference) = (hash_of_result(&plan)?, &reference);
    let exported = Exported { plan: &plan, result, problem: &problem, reference, smooth: &smooth, trial, anyway };
    let document = Document::new(exported, request.rate)?;
    require_smooth(&plan, &document, request)?;

    let json = serde_json::to_vec_pretty(&document).map_err(|_| PlannerError::Internal("plan.json"))?;
    let named = |name: &str, content: Vec<u8>| (name.to_owned(), content);
    let mut files = vec![
        named(DOCUMENT, json),
        named(TRAJECTORY, trajectory_csv(&states, request.rate)?),
        named(WRENCH, wrench_csv(&plan, &frames)?),
        named(README, readme(&document, request.target).into_bytes()),
    ];
    match (request.target, &document.arm, parameters) {
        (Target::UrScript, Some(arm), _) => {
            files.push(named(SCRIPT, script(&document, arm, &smooth, &frames).into_bytes()));
        }
        (Target::Ros2Control, Some(arm), Some(parameters)) => {
            files.push(named(PARAMETERS, parameters.yaml(&document, arm).into_bytes()));
        }
        _ => {}
    }
    files.extend(request.target.player().into_iter().map(|(name, text)| named(name, text.as_bytes().to_vec())));
    fill(target, &files, document.warnings)
}

/// Puts the files of an export into their folder.
fn fill(folder: PathBuf, files: &[Content], remarks: Vec<String>) -> Result<Written, PlannerError> {
    ExportFolder::claim(&folder)?.fill(files)?;
    let names = files.iter().map(|(name, _)| name.clone()).chain([SUMS.to_owned()]).collect();
    Ok(Written { folder, files: names, remarks })
}

fn hash_of_result(plan: &StoredPlan) -> Result<String, PlannerError> {
    let file = plan.folder.join(RESULT);
    read_bytes(&file).map(|content| hash(&content))
}

/// Refuses a plan that is not done, unless `anyway`.
fn require_done(plan: &StoredPlan, anyway: bool) -> Result<(), PlannerError> {
    if plan.result.done || plan.result.planned || anyway {
        return Ok(());
    }
    let advice = "a robot should not play it; solve again, or export it with --anyway";
    let status = plain(&plan.result.status);
    Err(PlannerError::file(&plan.folder, format!("the plan is not done ({status}): {advice}")))
}

/// Refuses a plan that succeeds too rarely in rollouts, unless `anyway`.
fn require_success(plan: &StoredPlan, trial: &TrialRecord, anyway: bool) -> Result<(), PlannerError> {
    let low = trial.low_rates();
    if low.is_empty() || anyway {
        return Ok(());
    }
    let advice = "solve it with --robust, or export it with --anyway";
    let problem = format!("{}, less than {} %: {advice}", low.join("; "), 100.0 * LEAST_RATE);
    Err(PlannerError::file(&plan.folder, problem))
}

/// Refuses a reference whose torque steps exceed those of the target's robots, unless `anyway`.
fn require_smooth(plan: &StoredPlan, document: &Document, request: &Request) -> Result<(), PlannerError> {
    let Some((step, limit)) = document.torque_step_nm_per_ms.zip(request.target.torque_step()) else { return Ok(()) };
    if step <= limit || request.anyway {
        return Ok(());
    }
    let advice = "solve it with lower [limits] of acceleration, or export it with --anyway";
    let problem = format!(
        "--to {}: a joint torque steps by {step:.2} Nm within a millisecond, and these robots stop beyond {limit} Nm: {advice}",
        request.target
    );
    Err(PlannerError::file(&plan.folder, problem))
}

/// Refuses a target whose robots are not commanded what the plan was made for.
fn require_interface(plan: &StoredPlan, scene: &scene::Scene, target: Target) -> Result<(), PlannerError> {
    let interface = scene.position_robot.as_ref().map(|robot| robot.force_mode.is_some());
    let (planned, others) = match interface {
        None => ("torque", "csv, ur-rtde, franka, urscript or ros2"),
        Some(false) => ("position", "csv, correction or ros2-control"),
        Some(true) => ("force", "csv, ur-rtde or urscript"),
    };
    let suits = match target {
        Target::Csv => true,
        Target::UrRtde | Target::UrScript => interface != Some(false),
        // A model follows on the springs of torque control.
        Target::Franka | Target::Ros2 | Target::Mjcf | Target::Sdf | Target::Usd => interface.is_none(),
        Target::Correction | Target::Ros2Control => interface == Some(false),
    };
    if suits {
        return Ok(());
    }
    let problem = format!(
        "--to {target}: the plan was made for a robot with the interface `{planned}`: use --to {others}, or change robot.interface of \
         the scene and solve again"
    );
    Err(PlannerError::file(&plan.folder, problem))
}

/// Refuses a scene without the arm that a target needs.
fn require_arm(plan: &StoredPlan, scene: &scene::Scene, target: Target) -> Result<(), PlannerError> {
    if !target.needs_arm() {
        return Ok(());
    }
    let refuse = |problem: String| Err(PlannerError::file(&plan.folder, format!("--to {target}: {problem}")));
    match (scene.robot.as_ref().map(|robot| robot.arm.joints().len()), target.joints()) {
        (Some(number), Some(joints)) if number != joints => {
            refuse(format!("the arm of the scene has {number} joints, and these robots have {joints}"))
        }
        (Some(_), _) => Ok(()),
        (None, _) => refuse(
            "the plan was made without an arm; add [robot] with `urdf`, `tip`, `base`, `grasp` and `configuration` to the \
             scene and solve again, or use --to csv"
                .to_owned(),
        ),
    }
}

/// The parameters of `ros2-control`, whose controller may not be able to run the law of the plan.
fn parameters(plan: &StoredPlan, scene: &scene::Scene, target: Target) -> Result<Option<Parameters>, PlannerError> {
    let (Target::Ros2Control, Some(robot)) = (target, &scene.position_robot) else { return Ok(None) };
    let refuse = |problem| PlannerError::file(&plan.folder, format!("--to {target}: {problem}"));
    Parameters::new(robot, &Frames::of(scene)).map(Some).map_err(refuse)
}

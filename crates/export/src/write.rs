//! Writes the folder of an export.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use planner::PlannerError;
use planner::files::{StoredPlan, hash, read_text, require_folder, write_file};
use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::frames::Frames;
use crate::readme::readme;
use crate::target::Target;
use crate::trajectory::{resample, trajectory_csv};
use crate::urscript::script;
use crate::wrench::wrench_csv;

/// Name of the file that says what an export is. It is written last: where it stands, the export is whole.
pub const DOCUMENT: &str = "plan.json";
/// The reference of the tool at the rate of the robot.
pub const TRAJECTORY: &str = "trajectory.csv";
/// What the controller is expected to do at the tool point.
pub const WRENCH: &str = "wrench.csv";
/// Explains the folder.
pub const README: &str = "README.md";
/// The script of `urscript`.
pub const SCRIPT: &str = "plan.script";

/// What is exported, and how.
#[derive(Debug, Clone)]
pub struct Request<'path> {
    /// Folder of the plan.
    pub plan: &'path Path,
    /// What for.
    pub target: Target,
    /// Samples per second (Hz).
    pub rate: f64,
    /// Folder to write; by default `export/TARGET` in that of the plan.
    pub out: Option<&'path Path>,
    /// Also export a plan that is not done.
    pub anyway: bool,
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The folder.
    pub folder: PathBuf,
    /// Names of its files.
    pub files: Vec<String>,
    /// What the user should know.
    pub remarks: Vec<String>,
}

/// `plan.json` with the hashes of the other files.
#[derive(Serialize)]
struct Sealed<'document> {
    #[serde(flatten)]
    document: &'document Document,
    files: BTreeMap<&'document str, String>,
}

/// What is read of an earlier `plan.json`.
#[derive(Deserialize)]
struct Earlier {
    files: BTreeMap<String, String>,
}

/// Exports a plan.
///
/// # Errors
/// When the plan is not whole, was changed or is not done, lacks what the target needs, or a file would be replaced that is
/// not from an earlier export. Then nothing is written.
pub fn write(request: &Request) -> Result<Written, PlannerError> {
    let plan = StoredPlan::open(request.plan)?;
    let scene = plan.scene()?;
    require_done(&plan, request.anyway)?;
    require_arm(&plan, &scene, request.target)?;
    let folder = request.out.map_or_else(|| plan.folder.join("export").join(request.target.name()), Path::to_owned);
    require_folder(&folder)?;

    let (reference, frames) = (plan.reference()?, Frames::of(&scene));
    let document = Document::new(&plan, &scene, &reference, request.rate)?;
    let states = resample(&reference, &frames, request.rate)?;
    let mut files: Vec<(&str, Vec<u8>)> = vec![
        (TRAJECTORY, trajectory_csv(&states, request.rate)?),
        (WRENCH, wrench_csv(&plan, &frames)?),
        (README, readme(&document, request.target).into_bytes()),
    ];
    if let (Target::UrScript, Some(arm)) = (request.target, &document.arm) {
        files.push((SCRIPT, script(&document, arm, &reference, &frames).into_bytes()));
    }
    files.extend(request.target.player().into_iter().map(|(name, text)| (name, text.as_bytes().to_vec())));

    require_free(&folder, files.iter().map(|(name, _)| *name))?;
    for (name, content) in &files {
        write_file(&folder.join(name), content)?;
    }
    let hashes = files.iter().map(|(name, content)| (*name, hash(content))).collect();
    let sealed = serde_json::to_vec_pretty(&Sealed { document: &document, files: hashes })
        .map_err(|_| PlannerError::Internal("a document cannot be written"))?;
    write_file(&folder.join(DOCUMENT), &sealed)?;
    let names = std::iter::once(DOCUMENT).chain(files.iter().map(|(name, _)| *name)).map(str::to_owned).collect();
    Ok(Written { folder, files: names, remarks: remarks(&plan, &document) })
}

/// Refuses a plan that does not do what was asked for, unless it is wanted anyway.
fn require_done(plan: &StoredPlan, anyway: bool) -> Result<(), PlannerError> {
    if plan.result.done || anyway {
        return Ok(());
    }
    let advice = "a robot should not play it; solve again, or export it with --anyway";
    Err(PlannerError::file(&plan.folder, format!("the plan is not done ({}): {advice}", plan.result.status)))
}

/// Refuses a scene without the arm that a target needs.
fn require_arm(plan: &StoredPlan, scene: &scene::Scene, target: Target) -> Result<(), PlannerError> {
    let Some(joints) = target.joints() else { return Ok(()) };
    let refuse = |problem: String| Err(PlannerError::file(&plan.folder, format!("--to {target}: {problem}")));
    match scene.robot.as_ref().map(|robot| robot.arm.joints().len()) {
        Some(number) if number == joints => Ok(()),
        Some(number) => refuse(format!("the arm of the scene has {number} joints, and these robots have {joints}")),
        None => refuse(
            "the plan was made without an arm; add [robot] with `urdf`, `tip`, `base`, `grasp` and `configuration` to the \
             scene and solve again, or use --to csv"
                .to_owned(),
        ),
    }
}

/// Refuses to replace what is not from an earlier export.
fn require_free<'name>(folder: &Path, names: impl Iterator<Item = &'name str>) -> Result<(), PlannerError> {
    let document = folder.join(DOCUMENT);
    let refuse = |file: &Path| {
        let problem = "would be replaced and is not from an earlier export, or was changed since; choose another --out";
        Err(PlannerError::file(file, problem))
    };
    let stands = |file: &Path| file.symlink_metadata().is_ok();
    let earlier = if stands(&document) {
        let earlier = read_text(&document).ok().and_then(|text| serde_json::from_str::<Earlier>(&text).ok());
        let Some(earlier) = earlier else { return refuse(&document) };
        earlier.files
    } else {
        BTreeMap::new()
    };
    for name in names {
        let file = folder.join(name);
        let is_ours =
            || earlier.get(name).is_some_and(|own| read_text(&file).is_ok_and(|text| hash(text.as_bytes()) == *own));
        if stands(&file) && !is_ours() {
            return refuse(&file);
        }
    }
    Ok(())
}

fn remarks(plan: &StoredPlan, document: &Document) -> Vec<String> {
    let mut remarks = Vec::new();
    if !plan.result.done {
        remarks.push(format!("the plan is not done: {}", plan.result.status));
    }
    if document.arm.is_none() {
        remarks.push(
            "the scene has no arm: poses are those of the part in the world, not of a tool in a robot's base"
                .to_owned(),
        );
    }
    remarks
}

//! Plans as their folders hold them.

use std::fs;
use std::path::{Path, PathBuf};

use scene::{Scene, Source};
use simulation::Reference;

use crate::error::PlannerError;
use crate::files::atomic::{hash, read_bytes, read_text};
use crate::files::result::{PlanResult, RESULT};
use crate::files::trajectory::{REFERENCE, TABLES, read_reference};
use crate::files::work_folder::WorkFolder;
use crate::problem::Problem;

/// Scene and homotopy after defaults and choices.
pub const RESOLVED: &str = "resolved.toml";
/// Folder of the homotopy iterations, which are folders named 1, 2, ...
pub const STAGES: &str = "stages";

/// A whole plan in a folder: none of its files was cut or changed.
#[derive(Debug, Clone)]
pub struct StoredPlan {
    /// The folder.
    pub folder: PathBuf,
    /// `result.json`.
    pub result: PlanResult,
}

impl StoredPlan {
    /// The plan in a folder, or all plans in folders below it, by name.
    ///
    /// # Errors
    /// When there is none, or one of them is damaged.
    pub fn find(folder: &Path) -> Result<Vec<Self>, PlannerError> {
        require_no_file(folder)?;
        let mut plans = Vec::new();
        collect(folder, &mut plans)?;
        if plans.is_empty() {
            let advice = "`assembly-plan solve SCENE --out DIR` writes a plan";
            return Err(PlannerError::file(folder, format!("no {RESULT} in it or below; {advice}")));
        }
        Ok(plans)
    }

    /// The plan in a folder.
    ///
    /// # Errors
    /// When there is none, or a file of it is missing or not the one that was written.
    pub fn open(folder: &Path) -> Result<Self, PlannerError> {
        let result = read_result(folder)?;
        for (name, expected) in &result.files {
            let file = folder.join(name);
            let content = read_bytes(&file).map_err(|error| {
                PlannerError::file(&file, format!("belongs to the plan and cannot be read ({error}); solve again"))
            })?;
            if hash(&content) != *expected {
                return Err(PlannerError::file(
                    &file,
                    "was changed since the plan was written; restore it, or solve into another folder",
                ));
            }
        }
        if !result.files.contains_key(REFERENCE) {
            return Err(PlannerError::file(&folder.join(RESULT), format!("lists no {REFERENCE}; solve again")));
        }
        Ok(Self { folder: folder.to_owned(), result })
    }

    /// The motion to track.
    ///
    /// # Errors
    /// When it is not one.
    pub fn reference(&self) -> Result<Reference, PlannerError> {
        read_reference(&self.folder.join(REFERENCE))
    }

    /// The reference after every homotopy iteration.
    ///
    /// # Errors
    /// When one of them is missing or wrong.
    pub fn iteration_references(&self) -> Result<Vec<Reference>, PlannerError> {
        let folder = self.folder.join(STAGES);
        (1..=self.result.stages.len())
            .map(|number| read_reference(&folder.join(number.to_string()).join(REFERENCE)))
            .collect()
    }

    /// The scene that the plan was made for.
    ///
    /// # Errors
    /// When the plan's `resolved.toml` is not a scene.
    pub fn scene(&self) -> Result<Scene, PlannerError> {
        let file = self.folder.join(RESOLVED);
        Ok(Scene::parse(Source { file: &file, text: &read_text(&file)? })?)
    }

    /// Checks that the plan was made for the shapes, the start and the goal of a problem. Returns whether everything
    /// else is the same too: inertia, impedance, offsets, horizon, cost, limits, homotopy.
    ///
    /// # Errors
    /// When it was made for others.
    pub fn require_made_for(&self, problem: &Problem) -> Result<bool, PlannerError> {
        let made_from = &self.result.made_from;
        if made_from.problem == problem.identity() {
            return Ok(true);
        }
        if made_from.shapes != problem.shapes_hash() {
            let scene = self.scene()?;
            if let Some(difference) = difference(&scene, problem) {
                let problem = format!("the plan was made for another scene: {difference}");
                return Err(PlannerError::file(&self.folder, problem));
            }
        }
        Ok(made_from.settings == problem.settings_hash())
    }
}

/// What differs between the scene of a plan and a problem, in words, beyond rounding.
fn difference(plan: &Scene, problem: &Problem) -> Option<String> {
    /// Values (m, or components of unit vectors) closer than this are the same: files are written with all digits.
    const SAME: f64 = 1e-6;
    let same = |one: &[f64], other: &[f64]| one.iter().zip(other).all(|(one, other)| (one - other).abs() <= SAME);
    let scene = problem.scene();
    for (parent, planned, given) in
        [("body", &plan.body, &scene.body), ("environment", &plan.environment, &scene.environment)]
    {
        if planned.len() != given.len() {
            return Some(format!("its {parent} has {} parts, this one {}", planned.len(), given.len()));
        }
        for (one, other) in planned.iter().zip(given) {
            let is_same = one.name == other.name
                && one.shape.offsets().len() == other.shape.offsets().len()
                && same(one.shape.offsets(), other.shape.offsets())
                && same(one.shape.normals().as_flattened(), other.shape.normals().as_flattened());
            if !is_same {
                return Some(format!("part `{}` of its {parent} is not part `{}` of this one", one.name, other.name));
            }
        }
    }
    if !same(&plan.goal, &scene.goal) {
        return Some("its goal is another pose".to_owned());
    }
    let name = &problem.start().name;
    (!same(&plan.starts[0].pose, &problem.start().pose)).then(|| format!("its start `{name}` is another pose"))
}

/// `result.json` of a folder.
///
/// # Errors
/// When it is missing, or not one of this program and version.
pub fn read_result(folder: &Path) -> Result<PlanResult, PlannerError> {
    require_no_file(folder)?;
    require_moved(folder)?;
    let file = folder.join(RESULT);
    let text = read_text(&file)?;
    let result: PlanResult = serde_json::from_str(&text).map_err(|error| {
        let advice = "not a result of this version of `assembly-plan solve`";
        PlannerError::line(&file, error.line(), format!("{advice}: {error}"))
    })?;
    if let Some(name) = result.files.keys().find(|name| !is_plan_file(name)) {
        return Err(PlannerError::file(&file, format!("lists `{name}`, which is not a file of a plan")));
    }
    match (result.done || result.planned) && !result.is_finite() {
        true => Err(PlannerError::file(&file, "is called done, but has a null where a value should be; solve again")),
        false => Ok(result),
    }
}

/// Refuses a file where the folder of a plan belongs.
fn require_no_file(folder: &Path) -> Result<(), PlannerError> {
    match folder.is_file() {
        true => {
            Err(PlannerError::file(folder, "is a file; name the folder of a plan, which `assembly-plan solve` wrote"))
        }
        false => Ok(()),
    }
}

/// Refuses a folder without a plan into which a run was moving one when it was killed.
///
/// # Errors
/// With what finishes that.
pub fn require_moved(folder: &Path) -> Result<(), PlannerError> {
    match !folder.join(RESULT).exists() && WorkFolder::is_half_moved(folder) {
        true => Err(PlannerError::file(
            folder,
            "a run was interrupted while it moved its plan in; `assembly-plan solve` into this folder finishes that first",
        )),
        false => Ok(()),
    }
}

/// Whether a path in a plan's folder, with slashes, is one that plans have besides `result.json`.
pub fn is_plan_file(name: &str) -> bool {
    let is_number = |text: &str| text.len() <= 4 && text.parse::<u16>().is_ok_and(|number| number > 0);
    match name.split('/').collect::<Vec<_>>().as_slice() {
        [file] => TABLES.contains(file) || *file == RESOLVED,
        [folder, number, file] => *folder == STAGES && is_number(number) && TABLES.contains(file),
        _ => false,
    }
}

fn collect(folder: &Path, plans: &mut Vec<StoredPlan>) -> Result<(), PlannerError> {
    if folder.join(RESULT).exists() {
        plans.push(StoredPlan::open(folder)?);
        return Ok(());
    }
    require_moved(folder)?;
    let entries: Vec<_> = fs::read_dir(folder).and_then(Iterator::collect).map_err(PlannerError::read(folder))?;
    // Links are not followed: they may lead in a circle. Hidden folders hold unfinished work.
    let is_folder = |entry: &fs::DirEntry| {
        entry.file_type().is_ok_and(|kind| kind.is_dir()) && !entry.file_name().to_string_lossy().starts_with('.')
    };
    let mut folders: Vec<PathBuf> = entries.iter().filter(|entry| is_folder(entry)).map(fs::DirEntry::path).collect();
    folders.sort();
    folders.iter().try_for_each(|folder| collect(folder, plans))
}

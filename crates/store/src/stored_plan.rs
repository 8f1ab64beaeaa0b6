//! Plans as their folders hold them.

use std::fs;
use std::path::{Path, PathBuf};

use plan::{Choices, PlannerError, Problem, hash};
use scene::{Scene, Source};
use simulation::Reference;
use task::Pose;

use crate::atomic::{read_bytes, read_text};
use crate::manifest::Manifest;
use crate::result::{PlanResult, RESULT, problem_of_seal};
use crate::trajectory::{REFERENCE, SCENARIOS, TABLES, read_ends, read_reference};
use crate::work_folder::WorkFolder;

/// Scene and homotopy after defaults and choices.
pub const RESOLVED: &str = "resolved.toml";
/// Folder of the homotopy steps, which are folders named 1, 2, ...
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
        if folder.exists() {
            collect(folder, &mut plans)?;
        }
        if plans.is_empty() {
            return Err(without_plan(folder));
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

    /// A problem for which this plan is tried before anything is solved, moved to its start and its goal.
    ///
    /// # Errors
    /// When a file of the plan is damaged, or its arm does not reach its start.
    pub fn tried_first_for(&self, problem: Problem) -> Result<Problem, PlannerError> {
        let reference = plan::moved(&self.reference()?, &self.problem()?, &problem)?;
        Ok(problem.with_earlier(reference))
    }

    /// The reference after every homotopy step.
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
    /// When the plan's `resolved.toml` is not a scene, or not the one that the plan was made for.
    pub fn scene(&self) -> Result<Scene, PlannerError> {
        let file = self.folder.join(RESOLVED);
        let scene = Scene::parse(Source { file: &file, text: &read_text(&file)? })?;
        self.require_goal(&scene.goal)?;
        Ok(scene)
    }

    /// The problem that the plan was made for, from its own `resolved.toml`.
    ///
    /// # Errors
    /// When that file is not a scene, or differs from the settings of the plan.
    pub fn problem(&self) -> Result<Problem, PlannerError> {
        let file = self.folder.join(RESOLVED);
        let problem = Problem::choose(self.scene()?, &file, &Choices::default())?;
        let result = &self.result;
        for (what, own, theirs) in
            [("scene", &result.scene, &problem.scene().title), ("start", &result.start, &problem.start().name)]
        {
            if own != theirs {
                let problem =
                    format!("{what} is `{own}`, and {RESOLVED} makes it `{theirs}`: it was changed; solve again");
                return Err(PlannerError::file(&self.folder.join(RESULT), problem));
            }
        }
        if self.require_made_for(&problem)? {
            return Ok(problem);
        }
        let problem = "has other settings than the plan was made with: it was changed; solve again";
        Err(PlannerError::file(&file, problem))
    }

    /// Checks that the errors at the end, which `result.json` states, are those of the tables to a goal: files that are whole
    /// each may still be of several plans. A refined plan is judged later, after its end was held, and one that was made by hand
    /// may have no scenarios.
    fn require_goal(&self, goal: &Pose) -> Result<(), PlannerError> {
        /// How far a stated error may be from that of the table (m, rad).
        const SAME: f64 = 1e-5;
        if self.result.robust.is_some() || !self.result.files.contains_key(SCENARIOS) {
            return Ok(());
        }
        let file = self.folder.join(SCENARIOS);
        let ends = read_ends(&file)?;
        let stated = &self.result.scenarios;
        if ends.len() != stated.len() {
            let problem = format!("has {} scenarios, {RESULT} {}; solve again", ends.len(), stated.len());
            return Err(PlannerError::file(&file, problem));
        }
        for ((end, stated), number) in ends.iter().zip(stated).zip(1..) {
            let error = end.error(goal);
            let differs = |found: f64, stated: f64| stated.is_finite() && !((found - stated).abs() <= SAME);
            if differs(error.position, stated.position_error_m)
                || differs(error.orientation, stated.orientation_error_rad)
            {
                let problem = format!(
                    "scenario {number} ends {:.3} mm and {:.3} rad from the goal of {RESOLVED}, {RESULT} says {:.3} mm and \
                     {:.3} rad: the files are not of one plan; solve again",
                    1e3 * error.position,
                    error.orientation,
                    1e3 * stated.position_error_m,
                    stated.orientation_error_rad
                );
                return Err(PlannerError::file(&file, problem));
            }
        }
        Ok(())
    }

    /// Checks that the plan was made for the shapes, the start and the goal of a problem. Returns whether everything
    /// else is the same too: inertia, impedance, offsets, horizon, cost, limits, homotopy.
    ///
    /// # Errors
    /// When it was made for others.
    pub fn require_made_for(&self, problem: &Problem) -> Result<bool, PlannerError> {
        let made_from = &self.result.made_from;
        let is_same = made_from.problem == problem.identity();
        if !is_same && made_from.shapes != problem.shapes_hash() {
            let scene = self.scene()?;
            if let Some(difference) = difference(&scene, problem) {
                let problem = format!("the plan was made for another scene: {difference}");
                return Err(PlannerError::file(&self.folder, problem));
            }
        }
        self.require_goal(&problem.scene().goal)?;
        Ok(is_same || made_from.settings == problem.settings_hash())
    }
}

/// Difference between the scene of a plan and a problem, in words, beyond rounding.
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
    if !same(&plan.goal[..], &scene.goal[..]) {
        return Some("its goal is another pose".to_owned());
    }
    let name = &problem.start().name;
    (!same(&plan.starts[0].pose[..], &problem.start().pose[..])).then(|| format!("its start `{name}` is another pose"))
}

/// `result.json` of a folder.
///
/// # Errors
/// When it is missing, or not one of this program and version.
pub fn read_result(folder: &Path) -> Result<PlanResult, PlannerError> {
    require_no_file(folder)?;
    require_moved(folder)?;
    let file = folder.join(RESULT);
    if !file.exists() {
        return Err(without_plan(folder));
    }
    let text = read_text(&file)?;
    let result: PlanResult = serde_json::from_str(&text).map_err(|error| {
        let advice = "not a result of this version of `assembly-plan solve`";
        PlannerError::line(&file, error.line(), format!("{advice}: {error}"))
    })?;
    if let Some(name) = result.files.keys().find(|name| !is_plan_file(name)) {
        return Err(PlannerError::file(&file, format!("lists `{name}`, which is not a file of a plan")));
    }
    let infinite = || {
        let problem = "is called done, but has a null where a value should be; solve again";
        ((result.done || result.planned) && !result.is_finite()).then_some(problem)
    };
    match infinite().or_else(|| problem_of_seal(&text)) {
        Some(problem) => Err(PlannerError::file(&file, problem)),
        None => Ok(result),
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

/// What a folder without a plan is instead.
fn without_plan(folder: &Path) -> PlannerError {
    let cells = Manifest::load(folder).map(|manifest| manifest.cells).unwrap_or_default();
    let problem = match cells.first() {
        Some(cell) => format!(
            "is the folder of a batch; name that of one of its plans, such as {}, which `assembly-plan batch run` writes",
            folder.join(&cell.folder).display()
        ),
        None if WorkFolder::is_unfinished(folder) => {
            "has no plan yet, a run on it has not ended; if it was interrupted, the same command with --resume resumes it"
                .to_owned()
        }
        None if !folder.exists() => {
            "there is no such folder; `assembly-plan solve SCENE --out DIR` writes a plan".to_owned()
        }
        None => format!("no {RESULT} in it or below; `assembly-plan solve SCENE --out DIR` writes a plan"),
    };
    PlannerError::file(folder, problem)
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

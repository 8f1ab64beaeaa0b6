//! The folder of a plan in the making. All work is done in a hidden folder beside it, under a lock; only a whole plan
//! is moved in. A run replaces and deletes only files of an earlier run.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use plan::{Keeper, Plan, PlannerError, hash};
use task::{AssemblyTask, Trajectory};

use crate::atomic::{read_bytes, read_text, remove_file, write_file};
use crate::result::{PlanResult, RESULT, sealed};
use crate::stored_plan::{RESOLVED, STAGES, StoredPlan, is_plan_file, read_result};
use crate::trajectory::{TABLES, read_trajectory, write_trajectory};
use crate::work_folder::WorkFolder;

/// `result.json` of the plan that is being replaced, while its files are.
const REPLACED: &str = "replaced.json";
/// The plan has the tables of one motion more than its homotopy steps, and all are read again for their hashes.
const WRITING_MARGIN: u32 = 2;
/// Homotopy steps of refined plans, in a folder for every round, where they are not those of the scene itself.
const REFINED: &str = "refined";

/// A plan's folder that this process alone may write, and the hidden folder of unfinished work beside it.
#[derive(Debug)]
pub struct PlanFolder {
    folder: WorkFolder,
    /// Time to write the tables of homotopy steps so far.
    writing: Mutex<Duration>,
}

impl PlanFolder {
    /// Claims a folder for a plan, before anything is computed. Nothing in it changes until [`PlanFolder::finish`].
    ///
    /// # Errors
    /// When another process writes a plan into it, when it holds a file that the plan would replace and that no earlier
    /// run has written, or when one of the `inputs` is such a file.
    pub fn claim(target: &Path, inputs: &[&Path]) -> Result<Self, PlannerError> {
        let folder = Self { folder: WorkFolder::claim(target)?, writing: Mutex::default() };
        if folder.folder.whole().join(RESULT).exists() {
            // A run was killed while it moved a whole plan in.
            folder.move_in()?;
        }
        folder.require_replaceable()?;
        inputs.iter().try_for_each(|input| folder.require_kept(input))?;
        Ok(folder)
    }

    /// Folder of the finished plan.
    pub fn target(&self) -> &Path {
        self.folder.target()
    }

    /// Whether an earlier run has left unfinished work.
    pub fn has_unfinished_work(&self) -> bool {
        self.folder.has_unfinished_work()
    }

    /// Folder of unfinished work.
    pub fn work(&self) -> &Path {
        self.folder.path()
    }

    /// Writes a whole plan and moves it in; the older plan is replaced only then. Unfinished work stays if another run can
    /// resume it ([`Plan::can_go_on`]).
    ///
    /// # Errors
    /// When it cannot be written; the older plan then still stands, and the unfinished work too.
    pub fn finish(self, plan: &Plan) -> Result<PlanResult, PlannerError> {
        let whole = self.folder.whole();
        let motions = plan.iterations.iter().map(|iteration| &iteration.trajectory);
        write_iterations(&whole.join(STAGES), motions, &plan.variant.task)?;
        write_trajectory(&whole, &plan.trajectory, &plan.task)?;
        write_file(&whole.join(RESOLVED), plan.problem.resolved().as_bytes())?;
        let result = PlanResult::new(plan, hashes(&whole)?);
        let json = serde_json::to_string_pretty(&result).map_err(|_| PlannerError::Internal("result.json"))?;
        write_file(&whole.join(RESULT), sealed(json).as_bytes())?;
        if !plan.can_go_on() {
            self.folder.discard_unfinished()?;
        }
        self.move_in()?;
        Ok(result)
    }

    /// Copies a stored plan and moves the copy in.
    ///
    /// # Errors
    /// When its folder no longer holds this plan, or a file cannot be read or written.
    pub fn copy(self, stored: &StoredPlan) -> Result<(), PlannerError> {
        let StoredPlan { folder, result } = stored;
        if StoredPlan::open(folder)?.result.files != result.files {
            return Err(PlannerError::file(folder, "holds another plan by now; open it again"));
        }
        let whole = self.folder.whole();
        for name in result.files.keys().map(String::as_str).chain([RESULT]) {
            let from = folder.join(name);
            write_file(&whole.join(name), &read_bytes(&from)?)?;
        }
        self.folder.discard_unfinished()?;
        self.move_in()
    }

    /// Moves a whole plan from the working folder to its place, `result.json` first out and last in. A run that is
    /// killed meanwhile loses nothing: the next one that claims the folder continues here.
    fn move_in(&self) -> Result<(), PlannerError> {
        let whole = self.folder.whole();
        let result = read_result(&whole)?;
        let standing = self.target().join(RESULT);
        if standing.exists() {
            rename(&standing, &self.work().join(REPLACED))?;
        }
        let replaced = read_text(&self.work().join(REPLACED)).ok();
        let replaced: Option<PlanResult> = replaced.and_then(|text| serde_json::from_str(&text).ok());
        for name in replaced.iter().flat_map(|replaced| replaced.files.keys()) {
            if is_plan_file(name) && !result.files.contains_key(name) {
                remove_file(&self.target().join(name))?;
                remove_empty_folders(self.target(), name);
            }
        }
        for name in result.files.keys().map(String::as_str).chain([RESULT]) {
            let (from, to) = (whole.join(name), self.target().join(name));
            if from.exists() {
                let parent = to.parent().unwrap_or(self.target());
                fs::create_dir_all(parent).map_err(PlannerError::written(parent))?;
                rename(&from, &to)?;
            }
        }
        fs::remove_dir_all(&whole).map_err(PlannerError::written(&whole))?;
        remove_file(&self.work().join(REPLACED))
    }

    /// Refuses to replace what no earlier run has written.
    fn require_replaceable(&self) -> Result<(), PlannerError> {
        let refuse = |name: &str, problem: &str| Err(PlannerError::file(&self.target().join(name), problem));
        let standing = plan_files(self.target())?;
        let earlier = match standing.iter().any(|name| name == RESULT) {
            true => match read_result(self.target()) {
                Ok(result) => result.files,
                Err(error) => {
                    return Err(PlannerError::file(
                        self.target(),
                        format!("holds no plan that may be replaced ({error}); choose another --out, or remove it"),
                    ));
                }
            },
            false => BTreeMap::new(),
        };
        for name in standing.iter().filter(|name| *name != RESULT) {
            let file = self.target().join(name);
            match earlier.get(name) {
                None => {
                    return refuse(name, "was not written by an earlier run; choose another --out, or move it away");
                }
                Some(expected) if hash(&read_bytes(&file)?) != *expected => {
                    return refuse(
                        name,
                        "was changed since the plan was written; choose another --out, or move it away",
                    );
                }
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// Refuses to replace an input.
    fn require_kept(&self, input: &Path) -> Result<(), PlannerError> {
        let Ok(path) = input.canonicalize() else { return Ok(()) };
        let Ok(inside) = path.strip_prefix(self.target()) else { return Ok(()) };
        let name = inside.to_string_lossy();
        if is_plan_file(&name) || name == RESULT {
            let problem = "is an input of this run, which would replace it; choose another --out";
            return Err(PlannerError::file(input, problem));
        }
        Ok(())
    }
}

impl PlanFolder {
    /// Names and hashes of the tables of a motion.
    fn hashed(&self, folder: &str) -> Result<Vec<(String, String)>, PlannerError> {
        let hashed = |table: &str| {
            let name = format!("{folder}/{table}");
            let file = self.work().join(&name);
            Ok((name, hash(&read_bytes(&file)?)))
        };
        TABLES.into_iter().map(hashed).collect()
    }
}

impl Keeper for PlanFolder {
    fn keep_iteration(
        &self,
        number: usize,
        motion: &Trajectory,
        task: &AssemblyTask,
    ) -> Result<Vec<(String, String)>, PlannerError> {
        let begin = Instant::now();
        write_trajectory(&self.work().join(STAGES).join(number.to_string()), motion, task)?;
        *self.writing.lock().unwrap_or_else(PoisonError::into_inner) += begin.elapsed();
        self.hashed(&format!("{STAGES}/{number}"))
    }

    fn iteration(&self, number: usize, task: &AssemblyTask) -> Result<Trajectory, PlannerError> {
        read_trajectory(&self.work().join(STAGES).join(number.to_string()), task)
    }

    fn keep_refined(
        &self,
        round: usize,
        motions: &[&Trajectory],
        task: &AssemblyTask,
    ) -> Result<Vec<(String, String)>, PlannerError> {
        let folder = format!("{REFINED}/{round}");
        write_iterations(&self.work().join(&folder), motions.iter().copied(), task)?;
        let of_step = |number: usize| self.hashed(&format!("{folder}/{number}"));
        let hashed: Vec<_> = (1..=motions.len()).map(of_step).collect::<Result<_, _>>()?;
        Ok(hashed.concat())
    }

    fn refined(&self, round: usize, number: usize, task: &AssemblyTask) -> Result<Trajectory, PlannerError> {
        read_trajectory(&self.work().join(REFINED).join(round.to_string()).join(number.to_string()), task)
    }

    fn keep_record(&self, name: &str, record: &[u8]) -> Result<(), PlannerError> {
        write_file(&self.work().join(name), record)
    }

    fn record(&self, name: &str) -> Option<String> {
        read_text(&self.work().join(name)).ok()
    }

    fn is_unchanged(&self, name: &str, expected: &str) -> bool {
        read_bytes(&self.work().join(name)).is_ok_and(|content| hash(&content) == expected)
    }

    fn discard(&self) -> Result<bool, PlannerError> {
        self.folder.discard()
    }

    fn writing_time(&self) -> Duration {
        WRITING_MARGIN * *self.writing.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Writes the tables of all homotopy steps, each into a folder named after its number.
fn write_iterations<'motion>(
    folder: &Path,
    motions: impl Iterator<Item = &'motion Trajectory>,
    task: &AssemblyTask,
) -> Result<(), PlannerError> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(PlannerError::written(folder))?;
    }
    (1..)
        .zip(motions)
        .try_for_each(|(number, motion): (usize, _)| write_trajectory(&folder.join(number.to_string()), motion, task))
}

/// Hashes of all files of the plan in a folder.
fn hashes(folder: &Path) -> Result<BTreeMap<String, String>, PlannerError> {
    let mut hashes = BTreeMap::new();
    for name in plan_files(folder)? {
        let file = folder.join(&name);
        if name != RESULT {
            hashes.insert(name, hash(&read_bytes(&file)?));
        }
    }
    Ok(hashes)
}

/// Everything in a folder that has the name of a plan's file, and everything below `stages`; paths with slashes.
fn plan_files(folder: &Path) -> Result<Vec<String>, PlannerError> {
    let names = TABLES.into_iter().chain([RESOLVED, RESULT]);
    let mut found: Vec<String> =
        names.filter(|name| folder.join(name).symlink_metadata().is_ok()).map(str::to_owned).collect();
    let stages = folder.join(STAGES);
    match stages.symlink_metadata() {
        Ok(metadata) if metadata.is_dir() => files_below(&stages, STAGES, &mut found)?,
        Ok(_) => found.push(STAGES.to_owned()),
        Err(_) => {}
    }
    Ok(found)
}

fn files_below(folder: &Path, prefix: &str, found: &mut Vec<String>) -> Result<(), PlannerError> {
    for entry in fs::read_dir(folder).map_err(PlannerError::read(folder))? {
        let entry = entry.map_err(PlannerError::read(folder))?;
        let name = format!("{prefix}/{}", entry.file_name().to_string_lossy());
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            files_below(&entry.path(), &name, found)?;
        } else {
            found.push(name);
        }
    }
    Ok(())
}

/// Removes the folders of a removed file, as far as they are empty.
fn remove_empty_folders(target: &Path, name: &str) {
    let folders = Path::new(name).ancestors().skip(1).filter(|folder| !folder.as_os_str().is_empty());
    for folder in folders {
        if fs::remove_dir(target.join(folder)).is_err() {
            return;
        }
    }
}

fn rename(from: &Path, to: &Path) -> Result<(), PlannerError> {
    fs::rename(from, to).map_err(PlannerError::written(to))
}

//! `manifest.jsonl`: all cells of a batch, one per line, never changed once it is written.

use std::fs;
use std::path::{Component, Path, PathBuf};

use plan::{Format, PlannerError, short};
use serde::{Deserialize, Serialize};
use task::LinearSolver;

use crate::atomic::{read_text, require_folder, write_file};
use crate::work_folder::WorkFolder;

/// Name of the file.
pub const MANIFEST: &str = "manifest.jsonl";
/// Digits of an identity that name a folder.
const NAME_DIGITS: usize = 16;
/// Largest offset magnitude of a scene (m).
const LARGEST_DELTA: f64 = 10.0;

/// One problem of a batch. Its paths are relative to the batch's folder, so that both can be moved together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cell {
    /// Format of the line.
    #[serde(default)]
    pub format: Format,
    /// Line in the manifest, from 0.
    pub index: usize,
    /// Scene file.
    pub scene: PathBuf,
    /// Name of the start pose.
    pub start: String,
    /// Offset magnitude `delta-hat` (m).
    pub delta_m: f64,
    /// Homotopy file; none for the scene's own.
    pub homotopy: Option<PathBuf>,
    /// Linear solver; none for the homotopy's.
    pub linear_solver: Option<String>,
    /// [`Problem::identity`](plan::Problem::identity).
    pub identity: String,
    /// Folder of its plan.
    pub folder: PathBuf,
}

impl Cell {
    /// The folder of a problem's plan in the folder of a batch.
    pub fn folder_of(identity: &str) -> PathBuf {
        Path::new("cells").join(&identity[..NAME_DIGITS])
    }

    /// The fault of a cell that was read, if any: its folder must be the one of its identity.
    fn problem(&self, index: usize) -> Option<String> {
        let is_identity = self.identity.len() == 64 && self.identity.bytes().all(|byte| byte.is_ascii_hexdigit());
        if self.index != index {
            return Some(format!("this is line {index} from 0, but its index is {}", self.index));
        }
        if !is_identity || self.folder != Self::folder_of(&self.identity) {
            return Some("folder and identity do not belong together; expand the batch again".to_owned());
        }
        if !(0.0..=LARGEST_DELTA).contains(&self.delta_m) {
            return Some(format!("delta_m = {}: must lie between 0 and {LARGEST_DELTA} m", short(self.delta_m)));
        }
        let is_solver = self.linear_solver.as_deref().is_none_or(|name| LinearSolver::from_name(name).is_some());
        (!is_solver).then(|| "linear_solver is unknown".to_owned())
    }

    /// The cell in the user's words.
    pub fn label(&self) -> String {
        let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let homotopy = self.homotopy.as_ref().map_or_else(String::new, |file| format!(", {}", stem(file)));
        let Self { index, start, delta_m, .. } = self;
        format!("cell {index} ({}, start {start}, delta {delta_m}{homotopy})", stem(&self.scene))
    }
}

/// The cells of a batch and the folder that holds everything of it.
#[derive(Debug)]
pub struct Manifest {
    /// Folder of the batch.
    pub folder: PathBuf,
    /// All cells, by index.
    pub cells: Vec<Cell>,
}

impl Manifest {
    /// From cells whose files have absolute paths.
    ///
    /// # Errors
    /// When the folder cannot be made.
    pub fn new(folder: &Path, mut cells: Vec<Cell>) -> Result<Self, PlannerError> {
        require_folder(folder)?;
        fs::create_dir_all(folder).map_err(PlannerError::written(folder))?;
        let from = folder.canonicalize().map_err(PlannerError::written(folder))?;
        for cell in &mut cells {
            cell.scene = relative(&from, &cell.scene);
            cell.homotopy = cell.homotopy.as_ref().map(|file| relative(&from, file));
        }
        Ok(Self { folder: folder.to_owned(), cells })
    }

    /// Reads the manifest of a folder.
    ///
    /// # Errors
    /// When it is not found, or with the line that is wrong.
    pub fn load(folder: &Path) -> Result<Self, PlannerError> {
        let file = folder.join(MANIFEST);
        if !file.exists() {
            return Err(PlannerError::file(&file, "not found; `assembly-plan batch expand` writes it"));
        }
        let text = read_text(&file)?;
        let mut cells = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let refuse = |problem: String| PlannerError::line(&file, index + 1, problem);
            let cell: Cell = serde_json::from_str(line).map_err(|error| refuse(error.to_string()))?;
            match cell.problem(index) {
                Some(problem) => return Err(refuse(problem)),
                None => cells.push(cell),
            }
        }
        if cells.is_empty() {
            return Err(PlannerError::file(&file, "has no cells; expand the batch again"));
        }
        Ok(Self { folder: folder.to_owned(), cells })
    }

    /// Name of the file.
    pub fn file(&self) -> PathBuf {
        self.folder.join(MANIFEST)
    }

    /// Writes the file and returns true, or returns false where it stands already.
    ///
    /// # Errors
    /// When another manifest stands there.
    pub fn write(&self) -> Result<bool, PlannerError> {
        let mut text = String::new();
        for cell in &self.cells {
            text += &serde_json::to_string(cell).map_err(|_| PlannerError::Internal("a cell cannot be written"))?;
            text.push('\n');
        }
        // Two batches do not replace each other's.
        let _lock = WorkFolder::claim(&self.folder)?;
        let file = self.file();
        if file.symlink_metadata().is_err() {
            return write_file(&file, text.as_bytes()).map(|()| true);
        }
        match read_text(&file)? {
            standing if standing == text => Ok(false),
            standing => Err(PlannerError::line(
                &file,
                first_difference(&standing, &text),
                "this folder belongs to another batch, and a manifest is never changed; choose another --out, or remove \
                 the folder to start over",
            )),
        }
    }
}

/// Line, from 1, in which two texts differ first.
fn first_difference(one: &str, other: &str) -> usize {
    one.lines().zip(other.lines()).take_while(|(one, other)| one == other).count() + 1
}

/// `to` as seen from the folder `from`, both absolute and without links.
fn relative(from: &Path, to: &Path) -> PathBuf {
    let shared = from.components().zip(to.components()).take_while(|(one, other)| one == other).count();
    if shared == 0 {
        return to.to_owned();
    }
    let up = from.components().skip(shared).map(|_| Component::ParentDir);
    up.chain(to.components().skip(shared)).collect()
}

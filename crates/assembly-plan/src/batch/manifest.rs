//! `manifest.jsonl`: all cells of a batch, one per line, never changed once it is written.

use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::output::write_file;

const FILE: &str = "manifest.jsonl";

/// One problem of a batch. Its paths are relative to the batch's folder, so that both can be moved together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cell {
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
    /// [`crate::problem::Problem::identity`].
    pub identity: String,
    /// Where its plan goes.
    pub folder: PathBuf,
}

impl Cell {
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
    /// Of cells whose files have absolute paths.
    ///
    /// # Errors
    /// When the folder cannot be made.
    pub fn new(folder: &Path, mut cells: Vec<Cell>) -> Result<Self, Failure> {
        fs::create_dir_all(folder).map_err(|error| Failure::io(folder, &error))?;
        let from = folder.canonicalize().map_err(|error| Failure::io(folder, &error))?;
        for cell in &mut cells {
            cell.scene = relative(&from, &cell.scene);
            cell.homotopy = cell.homotopy.as_ref().map(|file| relative(&from, file));
        }
        Ok(Self { folder: folder.to_owned(), cells })
    }

    /// Reads the manifest of a folder.
    ///
    /// # Errors
    /// When there is none, or with the line that is wrong.
    pub fn load(folder: &Path) -> Result<Self, Failure> {
        let file = folder.join(FILE);
        let text = fs::read_to_string(&file).map_err(|error| match error.kind() {
            ErrorKind::NotFound => {
                Failure::Input(format!("{}: there is none; `assembly-plan batch expand` writes it", file.display()))
            }
            _ => Failure::io(&file, &error),
        })?;
        let mut cells = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let refuse = |reason: String| Failure::Input(format!("{}:{}: {reason}", file.display(), index + 1));
            let cell: Cell = serde_json::from_str(line).map_err(|error| refuse(error.to_string()))?;
            if cell.index != index {
                return Err(refuse(format!("this is line {index} from 0, but its index is {}", cell.index)));
            }
            cells.push(cell);
        }
        Ok(Self { folder: folder.to_owned(), cells })
    }

    /// Name of the file.
    pub fn file(&self) -> PathBuf {
        self.folder.join(FILE)
    }

    /// Writes the file and returns true, or returns false where it stands already.
    ///
    /// # Errors
    /// When another manifest stands there.
    pub fn write(&self) -> Result<bool, Failure> {
        let mut text = String::new();
        for cell in &self.cells {
            text += &serde_json::to_string(cell).map_err(|error| Failure::Internal(error.to_string()))?;
            text.push('\n');
        }
        let file = self.file();
        match fs::read_to_string(&file) {
            Ok(standing) if standing == text => Ok(false),
            Ok(standing) => Err(Failure::Input(format!(
                "{}:{}: this folder belongs to another batch, and a manifest is never changed; choose another --out, or \
                 remove the folder to start over",
                file.display(),
                first_difference(&standing, &text)
            ))),
            Err(error) if error.kind() == ErrorKind::NotFound => write_file(&file, text.as_bytes()).map(|()| true),
            Err(error) => Err(Failure::io(&file, &error)),
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

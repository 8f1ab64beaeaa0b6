//! The state of a cell, according to its folder.

use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};

use crate::{Cell, Manifest, PlanResult, RESULT, StoredPlan, read_text};

/// State of a cell.
#[derive(Debug)]
pub enum CellState {
    /// Its plan is whole, good or bad.
    Finished(Box<PlanResult>),
    /// A process is solving it.
    Running,
    /// It has failed, for this reason: from the process that solved it last, or a file of its plan that was changed.
    Failed(String),
    /// Not started, or interrupted.
    ToDo,
}

impl CellState {
    /// Reads the state of a cell.
    pub fn of(manifest: &Manifest, cell: &Cell) -> Self {
        let files = CellFiles::new(manifest, cell);
        if files.is_locked() {
            return Self::Running;
        }
        match files.result() {
            Ok(Some(result)) => return Self::Finished(Box::new(result)),
            Ok(None) => {}
            Err(problem) => return Self::Failed(problem),
        }
        match read_text(&files.failure()) {
            Ok(reason) => Self::Failed(reason.trim_end().to_owned()),
            Err(_) => Self::ToDo,
        }
    }

    /// The state in a word or two.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Finished(result) if result.done => "done",
            Self::Finished(result) if result.planned => "planned",
            Self::Finished(..) | Self::Failed(_) => "failed",
            Self::Running => "running",
            Self::ToDo => "to do",
        }
    }

    /// Why the cell counts as failed, if it does.
    pub fn failure(&self) -> Option<&str> {
        match self {
            Self::Finished(result) if !(result.done || result.planned) => Some(&result.status),
            Self::Failed(reason) => Some(reason),
            _ => None,
        }
    }
}

/// Files of a cell.
#[derive(Debug)]
pub struct CellFiles {
    cell: Cell,
    folder: PathBuf,
}

impl CellFiles {
    /// In the folder of a batch.
    pub fn new(manifest: &Manifest, cell: &Cell) -> Self {
        Self { cell: cell.clone(), folder: manifest.folder.join(&cell.folder) }
    }

    /// The folder of its plan.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Output of its last process. The process that solves the cell holds a lock on it.
    pub fn log(&self) -> PathBuf {
        self.folder.join("log.txt")
    }

    /// Reason why its last process has failed.
    pub fn failure(&self) -> PathBuf {
        self.folder.join("failure.txt")
    }

    /// Its result, if it is finished; `Err` with what is wrong when a file of its plan is missing or was changed, or the plan
    /// is that of another cell.
    ///
    /// # Errors
    /// In the user's words.
    pub fn result(&self) -> Result<Option<PlanResult>, String> {
        let folder = self.folder.display();
        if self.folder.exists() && !self.folder.is_dir() {
            return Err(format!("{folder} is a file, where the plan's folder should be; remove it, to solve the cell"));
        }
        if !self.folder.join(RESULT).exists() {
            return Ok(None);
        }
        let result = match StoredPlan::open(&self.folder) {
            Ok(plan) => plan.result,
            Err(error) => return Err(format!("{error}; or remove {folder}, to solve the cell again")),
        };
        if self.is_made_for_the_cell(&result) {
            return Ok(Some(result));
        }
        Err(format!(
            "{folder}: the plan was made for start {}, offset magnitude {} m, and not for this cell; move it back to its \
             own folder, or remove it, to solve the cell again",
            result.start, result.delta_m
        ))
    }

    fn is_made_for_the_cell(&self, result: &PlanResult) -> bool {
        let Cell { identity, start, delta_m, .. } = &self.cell;
        // The identity includes start and offset, but an edited manifest may state others beside it.
        result.made_from.problem == *identity && result.start == *start && result.delta_m == *delta_m
    }

    fn is_locked(&self) -> bool {
        let log = input::require_regular(&self.log()).and_then(|()| File::open(self.log()));
        let Ok(log) = log else { return false };
        matches!(log.try_lock_shared(), Err(TryLockError::WouldBlock))
    }
}

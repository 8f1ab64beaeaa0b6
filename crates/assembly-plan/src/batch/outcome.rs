//! What has become of a cell, as its folder says.

use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

use super::manifest::{Cell, Manifest};

/// What `result.json` says of a plan.
#[derive(Debug, Deserialize)]
pub struct Outcome {
    pub status: String,
    pub converged: bool,
    pub goal_reached: bool,
    pub linear_solver: String,
    pub iterations: usize,
    /// None where the number is not finite, here and below.
    pub objective: Option<f64>,
    pub wall_s: f64,
    pub stages: Vec<StageOutcome>,
    pub scenarios: Vec<ScenarioOutcome>,
}

/// One homotopy iteration.
#[derive(Debug, Deserialize)]
pub struct StageOutcome {
    pub wall_split_s: Split,
}

/// Where the time went (s).
#[derive(Debug, Deserialize)]
pub struct Split {
    pub distances: f64,
    pub model: f64,
    pub linear_solver: f64,
    pub rest: f64,
}

/// How a scenario ends.
#[derive(Debug, Deserialize)]
pub struct ScenarioOutcome {
    pub position_error_m: Option<f64>,
    pub orientation_error_rad: Option<f64>,
    pub max_penetration_m: Option<f64>,
    pub max_force_n: Option<f64>,
}

impl Outcome {
    /// Whether the plan converged and every scenario ends at the goal.
    pub fn is_done(&self) -> bool {
        self.converged && self.goal_reached
    }
}

/// State of a cell.
#[derive(Debug)]
pub enum State {
    /// Its plan is whole, good or bad.
    Finished(Box<Outcome>, Value),
    /// A process is solving it.
    Running,
    /// The process that solved it last has failed, for this reason.
    Crashed(String),
    /// Not begun, or interrupted.
    ToDo,
}

impl State {
    /// Reads the state of a cell.
    pub fn of(manifest: &Manifest, cell: &Cell) -> Self {
        let places = Places::new(manifest, cell);
        if let Some((outcome, whole)) = places.result() {
            return Self::Finished(outcome, whole);
        }
        if places.is_locked() {
            return Self::Running;
        }
        match fs::read_to_string(places.failure()) {
            Ok(reason) => Self::Crashed(reason.trim_end().to_owned()),
            Err(_) => Self::ToDo,
        }
    }

    /// The state in one word.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Finished(outcome, _) if outcome.is_done() => "done",
            Self::Finished(..) | Self::Crashed(_) => "failed",
            Self::Running => "running",
            Self::ToDo => "to do",
        }
    }

    /// Why the cell counts as failed, if it does.
    pub fn failure(&self) -> Option<&str> {
        match self {
            Self::Finished(outcome, _) if !outcome.is_done() => Some(&outcome.status),
            Self::Crashed(reason) => Some(reason),
            _ => None,
        }
    }
}

/// Files of a cell.
#[derive(Debug)]
pub struct Places {
    folder: PathBuf,
}

impl Places {
    /// In the folder of a batch.
    pub fn new(manifest: &Manifest, cell: &Cell) -> Self {
        Self { folder: manifest.folder.join(&cell.folder) }
    }

    /// The folder of its plan.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// What its last process has printed. The process that solves the cell holds a lock on it.
    pub fn log(&self) -> PathBuf {
        self.folder.join("log.txt")
    }

    /// Why its last process has failed.
    pub fn failure(&self) -> PathBuf {
        self.folder.join("failure.txt")
    }

    /// Its result, if it is finished. A file that cannot be read, after a failure of the disk say, is none.
    pub fn result(&self) -> Option<(Box<Outcome>, Value)> {
        let text = fs::read_to_string(self.folder.join("result.json")).ok()?;
        let whole: Value = serde_json::from_str(&text).ok()?;
        let outcome = Outcome::deserialize(&whole).ok()?;
        Some((Box::new(outcome), whole))
    }

    fn is_locked(&self) -> bool {
        let Ok(log) = File::open(self.log()) else { return false };
        matches!(log.try_lock_shared(), Err(TryLockError::WouldBlock))
    }
}

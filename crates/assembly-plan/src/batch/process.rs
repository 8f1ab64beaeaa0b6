//! The process that solves a cell.

use std::ffi::OsString;
use std::fs::{self, TryLockError};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};

use planner::batch::{Cell, CellFiles, Manifest};
use planner::files::{PlanResult, read_bytes, remove_file, write_file};

use crate::exit::{CommandError, Exit};
use crate::program::Program;

/// Variables that limit the threads of the libraries in a solve; a cell has one.
const THREAD_LIMITS: [&str; 4] = ["OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS"];

/// Result of the attempt to start a cell.
pub enum Begun {
    /// A process solves it now.
    Process(Box<Process>),
    /// It was finished before.
    Finished(Box<PlanResult>),
    /// Another run solves it.
    Busy,
}

/// How a process has ended.
pub enum Ended {
    /// With a whole plan, good or bad.
    Finished(Box<PlanResult>),
    /// It was stopped; the next one resumes after its last finished homotopy step.
    Interrupted,
    /// Without a plan, for this reason.
    Crashed(String),
}

/// A running `solve` of one cell.
pub struct Process {
    /// Index of the cell.
    pub cell: usize,
    files: CellFiles,
    child: Child,
}

impl Process {
    /// Solves a cell unless it is finished or another run is at it.
    ///
    /// # Errors
    /// When its files cannot be written or the program cannot be started.
    pub fn begin(manifest: &Manifest, cell: &Cell) -> Result<Begun, CommandError> {
        let files = CellFiles::new(manifest, cell);
        fs::create_dir_all(files.folder()).map_err(in_system(files.folder()))?;
        let path = files.log();
        let log = input::append(&path).map_err(in_system(&path))?;
        match log.try_lock() {
            Err(TryLockError::WouldBlock) => return Ok(Begun::Busy),
            Err(TryLockError::Error(error)) => return Err(in_system(&path)(error)),
            Ok(()) => {}
        }
        // Only now, for the run that held the lock may just have finished it.
        if let Some(result) = files.result().map_err(CommandError::Usage)? {
            return Ok(Begun::Finished(Box::new(result)));
        }
        remove_file(&files.failure())?;
        log.set_len(0).map_err(in_system(&path))?;
        let errors = log.try_clone().map_err(in_system(&path))?;
        // The process inherits the lock with the log and holds it even when this one is killed.
        let mut command = solve(manifest, cell);
        let child = command.stdin(Stdio::piped()).stdout(log).stderr(errors).spawn();
        let child = child.map_err(in_system(Path::new(command.get_program())))?;
        Ok(Begun::Process(Box::new(Self { cell: cell.index, files, child })))
    }

    /// Asks the process to stop. It does so at its next iteration.
    pub fn stop(&mut self) {
        self.child.stdin = None;
    }

    /// How the process has ended, if it has.
    ///
    /// # Errors
    /// When this is not known, or the reason of its failure cannot be written.
    pub fn ended(&mut self) -> Result<Option<Ended>, CommandError> {
        let status = self.child.try_wait().map_err(|error| CommandError::System(error.to_string()))?;
        let Some(status) = status else { return Ok(None) };
        if let Some(result) = self.files.result().map_err(CommandError::Usage)? {
            return Ok(Some(Ended::Finished(Box::new(result))));
        }
        // One that is stopped before it can handle that has not failed either.
        let is_stopped = self.child.stdin.is_none();
        if is_stopped || status.code() == Some(Exit::Interrupted as i32) {
            return Ok(Some(Ended::Interrupted));
        }
        let reason = reason(status, &self.files.log());
        write_file(&self.files.failure(), reason.as_bytes())?;
        Ok(Some(Ended::Crashed(reason)))
    }
}

fn solve(manifest: &Manifest, cell: &Cell) -> Command {
    let mut command = Program::command();
    command.args(["solve", "--resume"]).arg(flag("--out=", &manifest.folder.join(&cell.folder)));
    command.arg(format!("--start={}", cell.start)).arg(format!("--delta={}", cell.delta_m));
    // Cells are solved side by side.
    command.args(["--jobs", "1", "--cell", &cell.identity]);
    if let Some(homotopy) = &cell.homotopy {
        command.arg(flag("--homotopy=", &manifest.folder.join(homotopy)));
    }
    if let Some(solver) = &cell.linear_solver {
        command.arg(format!("--linear-solver={solver}"));
    }
    command.envs(THREAD_LIMITS.map(|name| (name, "1")));
    command.arg("--").arg(manifest.folder.join(&cell.scene));
    command
}

/// A flag and its file in one word: names may begin with a dash.
fn flag(flag: &str, file: &Path) -> OsString {
    let mut word = OsString::from(flag);
    word.push(file);
    word
}

/// Why a process has failed: its last error, else its exit status.
fn reason(status: ExitStatus, log: &Path) -> String {
    let text = read_bytes(log).unwrap_or_default();
    let text = String::from_utf8_lossy(&text);
    let error = text.lines().rev().find_map(|line| line.strip_prefix("error: "));
    match (status.code(), error) {
        (Some(_), Some(error)) => error.to_owned(),
        _ => status.to_string(),
    }
}

/// A file that the system cannot read or write.
pub fn in_system(path: &Path) -> impl FnOnce(std::io::Error) -> CommandError {
    |error| CommandError::System(format!("{}: {error}", path.display()))
}

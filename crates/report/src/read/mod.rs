//! From a folder that `solve`, `batch`, `simulate` or `tolerance` wrote to the data of its page.

mod arm;
mod batch;
mod beside;
mod executed;
mod motion;
mod plan;
mod simulation;
mod tolerance;

use std::path::{Path, PathBuf};

use ::plan::PlannerError;
use ::tolerance::TOLERANCE;
pub use beside::read_beside;
use store::{MANIFEST, RESULT, SUCCESS, require_moved};

use crate::model::PageData;

/// Reads a folder, and logs of executions of the plan in it.
///
/// # Errors
/// When it is not one of these, is unfinished or damaged, or was written by another version; when there are logs
/// that are not of its plan.
pub fn read(folder: &Path, logs: &[PathBuf]) -> Result<PageData, PlannerError> {
    let holds = |name: &str| folder.join(name).exists();
    if !folder.is_dir() {
        return Err(PlannerError::file(
            folder,
            "is not a folder; name one that `solve`, `batch`, `simulate` or `tolerance` wrote",
        ));
    }
    if holds(RESULT) {
        return Ok(PageData::Plan(Box::new(plan::read(folder, logs)?)));
    }
    if let ([log, ..], true) = (logs, [MANIFEST, SUCCESS, TOLERANCE].into_iter().any(holds)) {
        let problem = format!("is not the folder of a plan that {} could have executed; name one", log.display());
        return Err(PlannerError::file(folder, problem));
    }
    if holds(MANIFEST) {
        return Ok(PageData::Batch(batch::read(folder)?));
    }
    if holds(TOLERANCE) {
        return Ok(PageData::Tolerance(Box::new(tolerance::read(folder)?)));
    }
    if holds(SUCCESS) {
        return Ok(PageData::Simulation(simulation::read(folder)?));
    }
    require_moved(folder)?;
    Err(PlannerError::file(folder, nothing(folder)))
}

/// Reason why there is nothing to show, and what to do.
fn nothing(folder: &Path) -> String {
    let absolute = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = absolute.file_name().unwrap_or_default().to_string_lossy();
    let work = absolute.with_file_name(format!(".{name}.unfinished"));
    if name.ends_with(".unfinished") || work.exists() {
        let (what, command) = match work.join(TOLERANCE).exists() {
            true => ("unfinished tolerances; wait for them", "tolerance"),
            false => ("an unfinished plan; wait for its solve", "solve"),
        };
        return format!("holds {what}, or resume with `assembly-plan {command} --resume`");
    }
    format!(
        "holds no {RESULT}, {MANIFEST}, {SUCCESS} or {TOLERANCE}; name a folder that `assembly-plan solve`, `batch`, \
         `simulate` or `tolerance` wrote"
    )
}

/// The name of a folder.
fn title(folder: &Path) -> String {
    let absolute = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    absolute.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

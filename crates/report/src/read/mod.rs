//! From a folder that `solve`, `batch` or `simulate` wrote to the data of its page.

mod arm;
mod batch;
mod beside;
mod executed;
mod motion;
mod plan;
mod simulation;

use std::path::{Path, PathBuf};

use ::plan::PlannerError;
pub use beside::read_beside;
use store::{MANIFEST, RESULT, SUCCESS, require_moved};

use crate::model::PageData;

/// Reads a folder, and logs of executions of the plan in it.
///
/// # Errors
/// When it is no plan, batch or simulation, is unfinished or damaged, or was written by another version; when there are logs
/// that are not of its plan.
pub fn read(folder: &Path, logs: &[PathBuf]) -> Result<PageData, PlannerError> {
    let holds = |name: &str| folder.join(name).exists();
    if !folder.is_dir() {
        return Err(PlannerError::file(folder, "is not a folder; name one that `solve`, `batch` or `simulate` wrote"));
    }
    if holds(RESULT) {
        return Ok(PageData::Plan(Box::new(plan::read(folder, logs)?)));
    }
    if let ([log, ..], true) = (logs, holds(MANIFEST) || holds(SUCCESS)) {
        let problem = format!("is not the folder of a plan that {} could have executed; name one", log.display());
        return Err(PlannerError::file(folder, problem));
    }
    if holds(MANIFEST) {
        return Ok(PageData::Batch(batch::read(folder)?));
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
        return "holds an unfinished plan; wait for its solve, or resume it with `assembly-plan solve --resume`"
            .to_owned();
    }
    format!(
        "holds no {RESULT}, {MANIFEST} or {SUCCESS}; name a folder that `assembly-plan solve`, `batch` or `simulate` wrote"
    )
}

/// The name of a folder.
fn title(folder: &Path) -> String {
    let absolute = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    absolute.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

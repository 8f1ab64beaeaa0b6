//! `report`: HTML pages of plans, batches and simulations.

use std::path::{Path, PathBuf};

use planner::PlannerError;

use crate::arguments::ReportArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the page of a folder, and those of the finished cells of a batch.
pub fn run(arguments: &ReportArguments) -> Result<Exit, CommandError> {
    write(&arguments.folder, arguments.out.as_deref())?;
    if let Some(folder) = &arguments.figures {
        let names = report::write_figures(&arguments.folder, folder)?;
        say!("figures written to {}: {}", folder.display(), names.join(", "));
    }
    Ok(Exit::Done)
}

/// Writes the page of a folder, by default into it, and says where it is.
///
/// # Errors
/// When the folder cannot be read or the page cannot be written.
pub fn write(folder: &Path, out: Option<&Path>) -> Result<(), PlannerError> {
    let pages = report::write_page(folder, out)?;
    let file = out.map_or_else(|| page_of(folder), Path::to_owned);
    match pages {
        1 => say!("page written to {}; open it in a browser", file.display()),
        _ => say!("page written to {}, with those of {} plans; open it in a browser", file.display(), pages - 1),
    }
    Ok(())
}

/// Where the page of a folder goes.
pub fn page_of(folder: &Path) -> PathBuf {
    folder.join(report::PAGE)
}

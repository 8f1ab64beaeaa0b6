//! `report`: HTML pages of plans, batches and simulations, and figures.

use std::path::{Path, PathBuf};

use planner::PlannerError;
use report::Written;

use crate::arguments::ReportArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the page of a folder, those of the finished cells of a batch, and figures.
pub fn run(arguments: &ReportArguments) -> Result<Exit, CommandError> {
    let ReportArguments { folder, executed, out, figures } = arguments;
    let written = report::write(folder, executed, out.as_deref(), figures.as_deref())?;
    tell_pages(&written);
    if let Some(folder) = figures {
        say!("figures written to {}: {}", folder.display(), written.figures.join(", "));
    }
    Ok(Exit::Done)
}

/// Writes the page of a folder into it and prints its name.
///
/// # Errors
/// When the folder cannot be read or the page cannot be written.
pub fn write_into(folder: &Path) -> Result<(), PlannerError> {
    tell_pages(&report::write(folder, &[], None, None)?);
    Ok(())
}

/// Refuses, before anything is computed, a folder in which something else than a page of ours would be replaced.
///
/// # Errors
/// With the name of the file.
pub fn require_writable(folder: &Path) -> Result<(), PlannerError> {
    report::require_writable(&page_of(folder))
}

/// Name of the page of a folder.
pub fn page_of(folder: &Path) -> PathBuf {
    folder.join(report::PAGE)
}

fn tell_pages(written: &Written) {
    let page = written.page.display();
    match written.cells {
        0 => say!("page written to {page}; open it in a browser"),
        1 => say!("page written to {page}, with that of 1 plan; open it in a browser"),
        cells => say!("page written to {page}, with those of {cells} plans; open it in a browser"),
    }
}

//! `report`: HTML pages of plans, batches, simulations and tolerances, figures and animations.

use std::path::{Path, PathBuf};

use planner::PlannerError;
use report::{Animation, Request, Written};

use crate::arguments::ReportArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the page of a folder, those of the finished cells of a batch, figures and an animation.
pub fn run(arguments: &ReportArguments) -> Result<Exit, CommandError> {
    let ReportArguments { folder, executed, out, beside, figures, animation, scenario } = arguments;
    let animation = animation.as_ref().map(|file| Animation { file: file.clone(), scenario: *scenario });
    let request = Request {
        folder,
        logs: executed,
        beside: beside.as_deref(),
        page: out.as_deref(),
        figures: figures.as_deref(),
        animation: animation.as_ref(),
    };
    let written = report::write(&request)?;
    tell_pages(&written);
    if let Some(folder) = figures {
        say!("figures written to {}: {}", folder.display(), written.figures.join(", "));
    }
    if let Some(Animation { file, .. }) = animation {
        say!("animation written to {}", file.display());
    }
    Ok(Exit::Done)
}

/// Writes the page of a folder into it and prints its name.
///
/// # Errors
/// When the folder cannot be read or the page cannot be written.
pub fn write_into(folder: &Path) -> Result<(), PlannerError> {
    tell_pages(&report::write(&Request::new(folder))?);
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

//! Writes pages.

use std::path::{Path, PathBuf};

use planner::PlannerError;
use planner::files::{read_text, require_folder, write_file};

use crate::figures::{BEGIN as FIGURE, figures};
use crate::html::{BEGIN, page};
use crate::model::PageData;
use crate::read::read;

/// Name of a page in the folder that it shows.
pub const PAGE: &str = "report.html";

/// Writes the page of a folder, and with a batch the pages of its finished cells. Returns how many pages that are.
///
/// # Errors
/// When the folder cannot be read, or a file stands there that is no page of ours.
pub fn write_page(folder: &Path, file: Option<&Path>) -> Result<usize, PlannerError> {
    let target = file.map_or_else(|| folder.join(PAGE), Path::to_owned);
    require_writable(&target)?;
    let mut data = read(folder)?;
    let mut count = 1;
    if let PageData::Batch(batch) = &mut data {
        let links = batch.cells.iter_mut().filter_map(|cell| cell.page.as_mut());
        for link in links {
            let own = folder.join(&*link);
            write_page(own.parent().unwrap_or(folder), None)?;
            count += 1;
            if file.is_some() {
                // The page stands elsewhere than its cells.
                *link = absolute(&own).display().to_string();
            }
        }
    }
    write_file(&target, page(&data)?.as_bytes())?;
    Ok(count)
}

/// Writes the figures of a folder into another one. Returns their names.
///
/// # Errors
/// When the folder cannot be read or has no figures, or a file stands there that is no figure of ours.
pub fn write_figures(folder: &Path, target: &Path) -> Result<Vec<String>, PlannerError> {
    require_folder(target)?;
    let figures = figures(&read(folder)?);
    if figures.is_empty() {
        let advice = "a batch without a simulation has no figures; name the folder of a cell, or simulate first";
        return Err(PlannerError::file(folder, advice));
    }
    for (name, _) in &figures {
        let file = target.join(name);
        let stands = file.symlink_metadata().is_ok();
        if stands && !read_text(&file).is_ok_and(|text| text.starts_with(FIGURE)) {
            return Err(PlannerError::file(&file, "is no earlier figure and would be replaced; choose another folder"));
        }
    }
    for (name, figure) in &figures {
        write_file(&target.join(name), figure.as_bytes())?;
    }
    Ok(figures.into_iter().map(|(name, _)| name).collect())
}

fn absolute(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// Refuses to replace what is no page of ours.
///
/// # Errors
/// With the name of the file.
pub fn require_writable(file: &Path) -> Result<(), PlannerError> {
    let stands = file.symlink_metadata().is_ok();
    if stands && !read_text(file).is_ok_and(|text| text.starts_with(BEGIN)) {
        return Err(PlannerError::file(file, "is no earlier report and would be replaced; choose another --out"));
    }
    Ok(())
}

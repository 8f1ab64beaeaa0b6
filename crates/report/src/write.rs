//! Writes pages and figures.

use std::path::{Path, PathBuf};

use plan::PlannerError;
use store::{read_text, require_folder, write_file};

use crate::figures::{BEGIN as FIGURE, figures};
use crate::html::{BEGIN, PAGE, page};
use crate::model::{BatchData, PageData};
use crate::read::read;

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The page.
    pub page: PathBuf,
    /// Number of pages of cells, to which the page of a batch leads.
    pub cells: usize,
    /// Names of the figures.
    pub figures: Vec<String>,
}

/// Writes the page of a folder, by default into it, for a batch also the pages of its finished cells, and its figures
/// into another folder, if one is named. The page of a plan also shows the executions in logs.
///
/// # Errors
/// When the folder cannot be read or has no figures, or a foreign file is in the way. Then neither the page
/// nor a figure is written.
pub fn write(
    folder: &Path,
    logs: &[PathBuf],
    file: Option<&Path>,
    figures: Option<&Path>,
) -> Result<Written, PlannerError> {
    let target = file.map_or_else(|| folder.join(PAGE), Path::to_owned);
    require_writable(&target)?;
    let mut data = read(folder, logs)?;
    let drawn = figures.map_or(Ok(Vec::new()), |figures| drawn(&data, folder, figures))?;
    let cells = match &mut data {
        PageData::Batch(batch) => write_cells(batch, folder, file.is_some())?,
        _ => 0,
    };
    for (file, figure) in &drawn {
        write_file(file, figure.as_bytes())?;
    }
    write_file(&target, page(&data)?.as_bytes())?;
    let name = |(file, _): &(PathBuf, String)| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Written { page: target, cells, figures: drawn.iter().map(name).collect() })
}

/// Writes the page of every finished cell of a batch; returns their number. A page that stands elsewhere leads to them by
/// their absolute paths.
fn write_cells(batch: &mut BatchData, folder: &Path, is_elsewhere: bool) -> Result<usize, PlannerError> {
    let mut count = 0;
    for link in batch.cells.iter_mut().filter_map(|cell| cell.page.as_mut()) {
        let own = folder.join(&*link);
        write(own.parent().unwrap_or(folder), &[], None, None)?;
        count += 1;
        if is_elsewhere {
            *link = own.canonicalize().unwrap_or(own).display().to_string();
        }
    }
    Ok(count)
}

/// Files and contents of the figures of a folder.
fn drawn(data: &PageData, folder: &Path, target: &Path) -> Result<Vec<(PathBuf, String)>, PlannerError> {
    require_folder(target)?;
    let drawn: Vec<(PathBuf, String)> =
        figures(data).into_iter().map(|(name, figure)| (target.join(name), figure)).collect();
    if drawn.is_empty() {
        let advice = "a batch without a simulation has no figures; name the folder of a cell, or simulate first";
        return Err(PlannerError::file(folder, advice));
    }
    drawn.iter().try_for_each(|(file, _)| require_own(file, FIGURE, "figure; choose another folder for --figures"))?;
    Ok(drawn)
}

/// Refuses to replace what is no page of ours.
///
/// # Errors
/// With the name of the file.
pub fn require_writable(file: &Path) -> Result<(), PlannerError> {
    require_own(file, BEGIN, "report; choose another --out, or move it away")
}

/// Refuses to replace a file with another beginning.
fn require_own(file: &Path, begin: &str, kind_and_advice: &str) -> Result<(), PlannerError> {
    let stands = file.symlink_metadata().is_ok();
    if stands && !read_text(file).is_ok_and(|text| text.starts_with(begin)) {
        return Err(PlannerError::file(file, format!("exists and is not an earlier {kind_and_advice}")));
    }
    Ok(())
}

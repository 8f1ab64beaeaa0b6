//! Writes pages and figures.

use std::path::{Path, PathBuf};

use plan::PlannerError;
use store::{read_text, require_folder, write_file};

use crate::animation::Animation;
use crate::figures::{BEGIN as FIGURE, figures};
use crate::html::{BEGIN, PAGE, page};
use crate::model::{BatchData, PageData};
use crate::read::{read, read_beside};

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

/// What to write, and where.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// Folder to show.
    pub folder: &'a Path,
    /// Logs of executions of the plan in it.
    pub logs: &'a [PathBuf],
    /// Folder of another plan of the same parts, which the page shows beside it.
    pub beside: Option<&'a Path>,
    /// File of the page; by default in the folder.
    pub page: Option<&'a Path>,
    /// Folder for figures; none are drawn without one.
    pub figures: Option<&'a Path>,
    /// The animation to draw.
    pub animation: Option<&'a Animation>,
}

impl<'a> Request<'a> {
    /// Only the page of a folder, in it.
    pub fn new(folder: &'a Path) -> Self {
        Self { folder, logs: &[], beside: None, page: None, figures: None, animation: None }
    }
}

/// Writes the page of a folder, for a batch also the pages of its finished cells, its figures and its animation.
///
/// # Errors
/// When a folder cannot be read, has no figures, does not move or cannot be shown beside the other, or a foreign file is in the
/// way. Then nothing is written.
pub fn write(request: &Request) -> Result<Written, PlannerError> {
    let Request { folder, logs, beside, page: file, figures, animation } = *request;
    let target = file.map_or_else(|| folder.join(PAGE), Path::to_owned);
    require_writable(&target)?;
    animation.map_or(Ok(()), Animation::require_writable)?;
    let mut data = read(folder, logs)?;
    let mut drawn = figures.map_or(Ok(Vec::new()), |figures| drawn(&data, folder, figures))?;
    let names =
        drawn.iter().map(|(file, _)| file.file_name().unwrap_or_default().to_string_lossy().into_owned()).collect();
    if let Some(animation) = animation {
        drawn.push((animation.file.clone(), animation.draw(&data, folder)?));
    }
    if let Some(other) = beside {
        data = read_beside(data, folder, other)?;
    }
    let cells = match &mut data {
        PageData::Batch(batch) => write_cells(batch, folder, file.is_some())?,
        _ => 0,
    };
    for (file, content) in &drawn {
        write_file(file, content)?;
    }
    write_file(&target, page(&data)?.as_bytes())?;
    Ok(Written { page: target, cells, figures: names })
}

/// Writes the page of every finished cell of a batch; returns their number. A page that stands elsewhere leads to them by
/// their absolute paths.
fn write_cells(batch: &mut BatchData, folder: &Path, is_elsewhere: bool) -> Result<usize, PlannerError> {
    let mut count = 0;
    for link in batch.cells.iter_mut().filter_map(|cell| cell.page.as_mut()) {
        let own = folder.join(&*link);
        write(&Request::new(own.parent().unwrap_or(folder)))?;
        count += 1;
        if is_elsewhere {
            *link = own.canonicalize().unwrap_or(own).display().to_string();
        }
    }
    Ok(count)
}

/// Files and contents of the figures of a folder.
fn drawn(data: &PageData, folder: &Path, target: &Path) -> Result<Vec<(PathBuf, Vec<u8>)>, PlannerError> {
    require_folder(target)?;
    let drawn: Vec<(PathBuf, Vec<u8>)> =
        figures(data).into_iter().map(|(name, figure)| (target.join(name), figure.into_bytes())).collect();
    if drawn.is_empty() {
        let advice = match data {
            PageData::Tolerance(_) => "the map of tolerances is tolerance.svg there, and it has no other figures",
            _ => "a batch without a simulation has no figures; name the folder of a cell, or simulate first",
        };
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

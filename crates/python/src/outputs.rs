//! What is written of the plan in a folder: its page, its figures, what robots read.

use std::path::PathBuf;

use export::{Target, write};
use planner::PlannerError;
use pyo3::prelude::*;
use report::{Animation, Request};

use crate::background;

/// Writes the page of the plan in a folder into a file.
#[pyfunction]
pub fn write_page(py: Python, folder: PathBuf, file: PathBuf) -> PyResult<()> {
    background::run(py, None, move |_| {
        report::write(&Request { page: Some(&file), ..Request::new(&folder) }).map(|_| ())
    })
}

/// Writes the moving plan in a folder into an SVG or GIF file, with all of its scenarios or one (from 1).
#[pyfunction]
#[pyo3(signature = (folder, file, scenario))]
pub fn write_animation(py: Python, folder: PathBuf, file: PathBuf, scenario: Option<usize>) -> PyResult<()> {
    background::run(py, None, move |_| Animation { file, scenario }.write(&report::read(&folder, &[])?, &folder))
}

/// Names and texts (SVG) of the figures of the plan in a folder.
#[pyfunction]
pub fn figures(py: Python, folder: PathBuf) -> PyResult<Vec<(String, String)>> {
    background::run(py, None, move |_| Ok(report::figures::figures(&report::read(&folder, &[])?)))
}

/// Exports the plan in a folder. Returns the names of the files.
#[pyfunction]
pub fn write_export(
    py: Python,
    plan: PathBuf,
    target: String,
    out: PathBuf,
    rate: f64,
    anyway: bool,
) -> PyResult<Vec<String>> {
    background::run(py, None, move |watch| {
        let names = Target::ALL.map(Target::name).join(", ");
        let unknown = || PlannerError::value("target", &target, &format!("unknown; choose one of {names}"));
        let target = Target::from_name(&target).ok_or_else(unknown)?;
        let written = write(&export::Request { plan: &plan, target, rate, out: Some(&out), anyway })?;
        written.remarks.into_iter().for_each(|remark| watch.warn(remark));
        Ok(written.files)
    })
}

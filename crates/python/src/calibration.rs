//! Calibrations: the robot of a scene, fitted to logs of its motions.

use std::path::{Path, PathBuf};

use ::calibration::{CalibrationRecord, Entries, Log, calibrate};
use ::scene::Scene;
use planner::{Choices, PlannerError, Problem};
use pyo3::FromPyObject;
use workers::Workers;

use crate::background::Watch;

/// What is fitted to which logs.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct CalibrationOptions {
    logs: Vec<PathBuf>,
    out: Option<PathBuf>,
    force: bool,
    per_joint: bool,
    jobs: Option<usize>,
}

/// As the command `calibrate` does; what it prints as JSON.
///
/// # Errors
/// When a log is not one of the scene's robot, or the copy of the scene cannot be written.
pub fn fit(scene: &Scene, file: &Path, options: &CalibrationOptions, watch: &Watch) -> Result<String, PlannerError> {
    let problem = Problem::choose(scene.clone(), file, &Choices::default())?;
    let logs: Vec<Log> = options.logs.iter().map(|log| Log::read(log, problem.scene())).collect::<Result<_, _>>()?;
    let workers = Workers::new(watch.session(options.jobs).threads);
    let calibration = calibrate(&problem, &logs, options.per_joint, &workers, &|_| {})?;
    let entries = Entries::new(&calibration, &problem);
    let record = CalibrationRecord::new(&calibration, &entries, &problem);
    record.warnings.iter().for_each(|warning| watch.warn(warning.clone()));
    if let Some(out) = &options.out {
        entries.write(file, out, options.force)?;
    }
    serde_json::to_string(&record).map_err(|_| PlannerError::Internal("a calibration"))
}

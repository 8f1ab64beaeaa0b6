//! Which errors plans tolerate.

use std::path::Path;

use plan::{PlannerError, reference_hash};
use store::{StoredPlan, read_text};
use tolerance::{TOLERANCE, ToleranceRecord};

use super::simulation;
use crate::model::ToleranceData;

/// Reads `tolerance.json` of a folder without a plan.
///
/// # Errors
/// When it or the simulation beside it is wrong.
pub fn read(folder: &Path) -> Result<ToleranceData, PlannerError> {
    Ok(ToleranceData { record: record(folder)?, simulation: simulation::read_if_there(folder)? })
}

/// The tolerances of a plan in its folder, or a warning if the file there is of another plan; nothing without a file.
///
/// # Errors
/// When the file is wrong.
pub fn of_plan(plan: &StoredPlan) -> Result<(Option<ToleranceRecord>, Option<String>), PlannerError> {
    if !plan.folder.join(TOLERANCE).exists() {
        return Ok((None, None));
    }
    let record = record(&plan.folder)?;
    if record.reference == reference_hash(&plan.reference()?) {
        return Ok((Some(record), None));
    }
    let warning =
        format!("{TOLERANCE} is of another plan and is not shown; measure again with `assembly-plan tolerance`");
    Ok((None, Some(warning)))
}

fn record(folder: &Path) -> Result<ToleranceRecord, PlannerError> {
    let file = folder.join(TOLERANCE);
    let record = serde_json::from_str(&read_text(&file)?);
    record.map_err(|error| PlannerError::file(&file, format!("is no record of tolerances: {error}; measure again")))
}

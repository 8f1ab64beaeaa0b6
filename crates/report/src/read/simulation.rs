//! Success rates of a simulation.

use std::path::Path;

use plan::PlannerError;
use store::{SUCCESS, SimulationRecord, SuccessRow, read_csv};

use super::title;
use crate::model::SimulationData;

/// Reads `success.csv` of a folder.
///
/// # Errors
/// When it is not one, has no rows, or is of another simulation than the files beside it.
pub fn read(folder: &Path) -> Result<SimulationData, PlannerError> {
    let file = folder.join(SUCCESS);
    let groups: Vec<SuccessRow> = read_csv(&file)?;
    if groups.is_empty() {
        return Err(PlannerError::file(&file, "has no rows; simulate again"));
    }
    Ok(SimulationData { title: title(folder), record: Some(SimulationRecord::read(folder)?), groups })
}

/// The table and record of a folder that may hold none.
///
/// # Errors
/// When it holds a table that is wrong.
pub fn read_if_there(folder: &Path) -> Result<Option<SimulationData>, PlannerError> {
    folder.join(SUCCESS).exists().then(|| read(folder)).transpose()
}

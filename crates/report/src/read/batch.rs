//! All cells of a batch.

use std::path::Path;

use plan::PlannerError;
use store::PlanResult;
use store::batch::{Cell, CellState, Manifest};

use super::{simulation, title};
use crate::html::PAGE;
use crate::model::{BatchData, CellData};
use crate::rounded::{LENGTH, rounded};

/// Reads the manifest of a folder and the state of its cells.
///
/// # Errors
/// When the manifest is wrong, or no cell is finished yet.
pub fn read(folder: &Path) -> Result<BatchData, PlannerError> {
    let manifest = Manifest::load(folder)?;
    let states: Vec<CellState> = manifest.cells.iter().map(|cell| CellState::of(&manifest, cell)).collect();
    if !states.iter().any(|state| matches!(state, CellState::Finished(_) | CellState::Failed(_))) {
        let advice = "no cell of the batch is finished yet; `assembly-plan batch run` solves them";
        return Err(PlannerError::file(folder, advice));
    }
    let cells = manifest.cells.iter().zip(&states).map(|(cell, state)| of_cell(cell, state)).collect();
    Ok(BatchData { title: title(folder), cells, simulation: simulation::read_if_there(folder)? })
}

fn of_cell(cell: &Cell, state: &CellState) -> CellData {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let result = if let CellState::Finished(result) = state { Some(result.as_ref()) } else { None };
    let status = result.map(|result| result.status.as_str()).or(state.failure()).unwrap_or(state.word());
    CellData {
        index: cell.index,
        scene: stem(&cell.scene),
        start: cell.start.clone(),
        delta: cell.delta_m,
        homotopy: cell.homotopy.as_deref().map(stem),
        state: state.word(),
        status: status.to_owned(),
        page: result.map(|_| format!("{}/{PAGE}", cell.folder.display())),
        errors: result.map(largest_errors),
        effort: result.map(|result| (result.iterations, result.wall_s)),
        rate: result.and_then(|result| result.robust.as_ref()).map(|robust| robust.rate_after),
        rotation_error: result.map(|result| result.turn_rad),
        versions: result.map(|result| result.versions.clone()),
    }
}

/// Largest final distance and angle of all scenarios.
fn largest_errors(result: &PlanResult) -> [f64; 2] {
    let largest = |errors: &mut dyn Iterator<Item = f64>| rounded(errors.fold(0.0, f64::max), LENGTH);
    [
        largest(&mut result.scenarios.iter().map(|scenario| scenario.position_error_m)),
        largest(&mut result.scenarios.iter().map(|scenario| scenario.orientation_error_rad)),
    ]
}

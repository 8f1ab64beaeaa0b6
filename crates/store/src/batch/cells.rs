//! One table of all cells of a batch: `cells.csv` and `cells.json`.

use std::path::{Path, PathBuf};

use plan::{PlannerError, Split};
use serde::{Deserialize, Serialize};

use crate::atomic::{read_bytes, write_file};
use crate::batch::state::CellState;
use crate::manifest::{Cell, Manifest};
use crate::result::{PlanResult, ScenarioRecord};
use crate::table::to_csv;

/// A row of `cells.csv`. Unknown values of an unfinished cell are empty.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "as in result.json, with their units")]
pub struct CellRow {
    pub index: usize,
    pub scene: PathBuf,
    pub start: String,
    pub delta_m: f64,
    pub homotopy: Option<PathBuf>,
    pub state: String,
    pub status: Option<String>,
    pub converged: Option<bool>,
    pub goal_reached: Option<bool>,
    pub iterations: Option<usize>,
    pub objective: Option<f64>,
    /// Largest of all scenarios, here and below; empty when one of them is not finite.
    pub position_error_m: Option<f64>,
    pub orientation_error_rad: Option<f64>,
    pub max_penetration_m: Option<f64>,
    pub max_force_n: Option<f64>,
    pub wall_s: Option<f64>,
    pub distances_s: Option<f64>,
    pub model_s: Option<f64>,
    pub linear_solver_s: Option<f64>,
    pub rest_s: Option<f64>,
    pub linear_solver: Option<String>,
    pub folder: PathBuf,
}

/// An element of `cells.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CellElement {
    /// The line of the manifest.
    pub cell: Cell,
    /// Its state in a word or two.
    pub state: String,
    /// Why it counts as failed.
    pub failure: Option<String>,
    /// The cell's `result.json`.
    pub result: Option<PlanResult>,
}

/// Writes `cells.csv` and `cells.json`; returns those that have changed.
///
/// # Errors
/// When they cannot be written.
pub fn collect(manifest: &Manifest) -> Result<Vec<PathBuf>, PlannerError> {
    let states: Vec<CellState> = manifest.cells.iter().map(|cell| CellState::of(manifest, cell)).collect();
    let cells = || manifest.cells.iter().zip(&states);
    let table = to_csv(cells().map(|(cell, state)| CellRow::new(cell, state)))?;
    let elements: Vec<CellElement> = cells().map(|(cell, state)| CellElement::new(cell, state)).collect();
    let json = serde_json::to_vec_pretty(&elements).map_err(|_| PlannerError::Internal("cells.json"))?;
    let mut written = Vec::new();
    // An older table is recognised by its beginning: a header, or the first key of the first cell.
    let files = [("cells.csv", table, b'\n'), ("cells.json", json, b':')];
    files.iter().try_for_each(|(name, content, end)| require_own(&manifest.folder.join(name), content, *end))?;
    for (name, content, _) in files {
        let file = manifest.folder.join(name);
        // A second run leaves everything as it is.
        if !read_bytes(&file).is_ok_and(|standing| standing == content) {
            write_file(&file, &content)?;
            written.push(file);
        }
    }
    Ok(written)
}

/// Refuses to replace a file with another beginning than the new content, up to a byte.
fn require_own(file: &Path, content: &[u8], end: u8) -> Result<(), PlannerError> {
    let begin = |bytes: &[u8]| bytes.split(|&byte| byte == end).next().map(<[u8]>::to_vec);
    match read_bytes(file) {
        Ok(standing) if begin(&standing) != begin(content) => {
            Err(PlannerError::file(file, "exists and is not a table of an earlier run; move it away"))
        }
        _ => Ok(()),
    }
}

impl CellElement {
    fn new(cell: &Cell, state: &CellState) -> Self {
        let result = if let CellState::Finished(result) = state { Some((**result).clone()) } else { None };
        let failure = state.failure().map(str::to_owned);
        Self { cell: cell.clone(), state: state.word().to_owned(), failure, result }
    }
}

impl CellRow {
    fn new(cell: &Cell, state: &CellState) -> Self {
        let result = if let CellState::Finished(result) = state { Some(result.as_ref()) } else { None };
        let worst = |value: fn(&ScenarioRecord) -> f64| result.and_then(|result| worst(result, value));
        let seconds = |part: fn(&Split) -> f64| {
            result.map(|result| result.stages.iter().map(|iteration| part(&iteration.wall_split_s)).sum())
        };
        Self {
            index: cell.index,
            scene: cell.scene.clone(),
            start: cell.start.clone(),
            delta_m: cell.delta_m,
            homotopy: cell.homotopy.clone(),
            state: state.word().to_owned(),
            status: result.map(|result| result.status.clone()).or(state.failure().map(str::to_owned)),
            converged: result.map(|result| result.converged),
            goal_reached: result.map(|result| result.goal_reached),
            iterations: result.map(|result| result.iterations),
            objective: result.map(|result| result.objective).filter(|objective| objective.is_finite()),
            position_error_m: worst(|scenario| scenario.position_error_m),
            orientation_error_rad: worst(|scenario| scenario.orientation_error_rad),
            max_penetration_m: worst(|scenario| scenario.max_penetration_m),
            max_force_n: worst(|scenario| scenario.max_force_n),
            wall_s: result.map(|result| result.wall_s),
            distances_s: seconds(|split| split.distances),
            model_s: seconds(|split| split.model),
            linear_solver_s: seconds(|split| split.linear_solver),
            rest_s: seconds(|split| split.rest),
            linear_solver: result.map(|result| result.linear_solver.clone()),
            folder: cell.folder.clone(),
        }
    }
}

/// Largest value of all scenarios; none when one of them is not finite.
fn worst(result: &PlanResult, value: fn(&ScenarioRecord) -> f64) -> Option<f64> {
    let largest = result
        .scenarios
        .iter()
        .map(value)
        .fold(0.0, |largest: f64, value| if value.is_finite() { largest.max(value) } else { f64::INFINITY });
    largest.is_finite().then_some(largest)
}

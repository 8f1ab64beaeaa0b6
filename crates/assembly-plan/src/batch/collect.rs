//! One table of all cells.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::Value;

use super::manifest::{Cell, Manifest};
use super::outcome::{Outcome, ScenarioOutcome, Split, State};
use crate::console::say;
use crate::failure::Failure;
use crate::output::write_file;

/// A line of `cells.csv`. What is not known of an unfinished cell is empty.
#[derive(Serialize)]
struct Row<'cell> {
    index: usize,
    scene: &'cell Path,
    start: &'cell str,
    delta_m: f64,
    homotopy: Option<&'cell PathBuf>,
    state: &'static str,
    status: Option<&'cell str>,
    converged: Option<bool>,
    goal_reached: Option<bool>,
    iterations: Option<usize>,
    objective: Option<f64>,
    /// Largest of all scenarios, here and below.
    position_error_m: Option<f64>,
    orientation_error_rad: Option<f64>,
    max_penetration_m: Option<f64>,
    max_force_n: Option<f64>,
    wall_s: Option<f64>,
    distances_s: Option<f64>,
    model_s: Option<f64>,
    linear_solver_s: Option<f64>,
    rest_s: Option<f64>,
    linear_solver: Option<&'cell str>,
    folder: &'cell Path,
}

/// An element of `cells.json`.
#[derive(Serialize)]
struct Element<'cell> {
    cell: &'cell Cell,
    state: &'static str,
    failure: Option<&'cell str>,
    /// The cell's `result.json`.
    result: Option<&'cell Value>,
}

/// Writes `cells.csv` and `cells.json`.
///
/// # Errors
/// When they cannot be written.
pub fn collect(manifest: &Manifest) -> Result<(), Failure> {
    let states: Vec<State> = manifest.cells.iter().map(|cell| State::of(manifest, cell)).collect();
    let cells = || manifest.cells.iter().zip(&states);
    let internal = |error: &dyn std::fmt::Display| Failure::Internal(format!("a table cannot be written: {error}"));
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (cell, state) in cells() {
        writer.serialize(row(cell, state)).map_err(|error| internal(&error))?;
    }
    let table = writer.into_inner().map_err(|error| internal(&error))?;
    let elements: Vec<Element> = cells().map(|(cell, state)| element(cell, state)).collect();
    let json = serde_json::to_vec_pretty(&elements).map_err(|error| internal(&error))?;
    for (name, content) in [("cells.csv", table), ("cells.json", json)] {
        let file = manifest.folder.join(name);
        // A second run leaves everything as it is.
        if fs::read(&file).is_ok_and(|standing| standing == content) {
            continue;
        }
        write_file(&file, &content)?;
        say!("written {}", file.display());
    }
    Ok(())
}

fn element<'cell>(cell: &'cell Cell, state: &'cell State) -> Element<'cell> {
    let result = if let State::Finished(_, whole) = state { Some(whole) } else { None };
    Element { cell, state: state.word(), failure: state.failure(), result }
}

fn row<'cell>(cell: &'cell Cell, state: &'cell State) -> Row<'cell> {
    let outcome = if let State::Finished(outcome, _) = state { Some(outcome.as_ref()) } else { None };
    let worst = |error: fn(&ScenarioOutcome) -> Option<f64>| outcome.and_then(|outcome| worst(outcome, error));
    let seconds = |part: fn(&Split) -> f64| {
        outcome.map(|outcome| outcome.stages.iter().map(|stage| part(&stage.wall_split_s)).sum())
    };
    Row {
        index: cell.index,
        scene: &cell.scene,
        start: &cell.start,
        delta_m: cell.delta_m,
        homotopy: cell.homotopy.as_ref(),
        state: state.word(),
        status: outcome.map(|outcome| outcome.status.as_str()).or(state.failure()),
        converged: outcome.map(|outcome| outcome.converged),
        goal_reached: outcome.map(|outcome| outcome.goal_reached),
        iterations: outcome.map(|outcome| outcome.iterations),
        objective: outcome.and_then(|outcome| outcome.objective),
        position_error_m: worst(|scenario| scenario.position_error_m),
        orientation_error_rad: worst(|scenario| scenario.orientation_error_rad),
        max_penetration_m: worst(|scenario| scenario.max_penetration_m),
        max_force_n: worst(|scenario| scenario.max_force_n),
        wall_s: outcome.map(|outcome| outcome.wall_s),
        distances_s: seconds(|split| split.distances),
        model_s: seconds(|split| split.model),
        linear_solver_s: seconds(|split| split.linear_solver),
        rest_s: seconds(|split| split.rest),
        linear_solver: outcome.map(|outcome| outcome.linear_solver.as_str()),
        folder: &cell.folder,
    }
}

/// Largest number of all scenarios; none when one of them is not finite.
fn worst(outcome: &Outcome, error: fn(&ScenarioOutcome) -> Option<f64>) -> Option<f64> {
    outcome.scenarios.iter().map(error).try_fold(0.0, |worst: f64, error| error.map(|error| worst.max(error)))
}

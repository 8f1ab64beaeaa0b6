//! From a matrix to its cells.

use std::path::{Path, PathBuf};

use plan::{Format, PlannerError, Problem, homotopy};
use scene::Scene;

use crate::Cell;
use crate::batch::matrix::{Key, Matrix, Starts};

/// More cells than anyone solves.
const MOST_CELLS: usize = 100_000;

/// All cells, with absolute paths: scene by scene, start by start, by magnitude, by homotopy; and remarks on the scenes.
/// Everything is read and checked here, so that a mistake shows before anything is solved.
///
/// # Errors
/// The first thing that is wrong.
pub fn expand(matrix: &Matrix) -> Result<(Vec<Cell>, Vec<String>), PlannerError> {
    if matrix.scenes.is_empty() {
        return Err(matrix.refuse(Key::Scenes, "at least one scene is needed"));
    }
    let (mut cells, mut warnings) = (Vec::new(), Vec::new());
    for file in &matrix.scenes {
        add_scene(matrix, file, &mut cells, &mut warnings)?;
    }
    for (index, cell) in cells.iter_mut().enumerate() {
        cell.index = index;
    }
    match twins(&cells) {
        Some((one, other)) => {
            let message = format!("{} and {} are the same problem; name it once", one.label(), other.label());
            Err(matrix.refuse(Key::Scenes, &message))
        }
        None => Ok((cells, warnings)),
    }
}

fn add_scene(
    matrix: &Matrix,
    file: &Path,
    cells: &mut Vec<Cell>,
    warnings: &mut Vec<String>,
) -> Result<(), PlannerError> {
    let scene = Scene::load(file)?;
    warnings.extend(scene.warnings.iter().cloned());
    let mut homotopies = Vec::new();
    for file in &matrix.homotopies {
        homotopies.push((Some(absolute(file)?), homotopy(&scene, Some(file), matrix.linear_solver)?));
    }
    if homotopies.is_empty() {
        homotopies.push((None, homotopy(&scene, None, matrix.linear_solver)?));
    }
    let deltas = if matrix.deltas.is_empty() { &[scene.offset_magnitude][..] } else { &matrix.deltas };
    let starts = starts(matrix, file, &scene)?;
    if cells.len() + starts.len() * deltas.len() * homotopies.len() > MOST_CELLS {
        return Err(matrix.refuse(Key::Scenes, &format!("more than {MOST_CELLS} cells; make several batches")));
    }
    for start in starts {
        for &delta_m in deltas {
            for (homotopy_file, homotopy) in &homotopies {
                let problem =
                    Problem::new(scene.clone(), Some(&start), Some(delta_m), homotopy.clone()).map_err(|error| {
                        match error {
                            PlannerError::Task(_) => matrix.refuse(Key::Deltas, &error.to_string()),
                            other => other,
                        }
                    })?;
                cells.push(Cell {
                    format: Format::CURRENT,
                    index: 0,
                    scene: absolute(file)?,
                    start: start.clone(),
                    delta_m,
                    homotopy: homotopy_file.clone(),
                    linear_solver: matrix.linear_solver.map(|solver| solver.name().to_owned()),
                    folder: Cell::folder_of(problem.identity()),
                    identity: problem.identity().to_owned(),
                });
            }
        }
    }
    Ok(())
}

fn starts(matrix: &Matrix, file: &Path, scene: &Scene) -> Result<Vec<String>, PlannerError> {
    match &matrix.starts {
        Starts::First => Ok(vec![scene.starts[0].name.clone()]),
        Starts::All => Ok(scene.starts.iter().map(|start| start.name.clone()).collect()),
        Starts::Named(names) => {
            let known = |name: &String| match scene.start(Some(name)) {
                Ok(_) => Ok(name.clone()),
                Err(error) => Err(matrix.refuse(Key::Starts, &format!("{}: {error}", file.display()))),
            };
            names.iter().map(known).collect()
        }
    }
}

fn absolute(file: &Path) -> Result<PathBuf, PlannerError> {
    let absolute = file.canonicalize().map_err(PlannerError::read(file))?;
    match absolute.to_str() {
        Some(_) => Ok(absolute),
        None => Err(PlannerError::file(file, "has a path that is not UTF-8, which a manifest cannot hold; rename it")),
    }
}

/// Two cells that solve the same problem.
fn twins(cells: &[Cell]) -> Option<(&Cell, &Cell)> {
    let mut by_identity: Vec<&Cell> = cells.iter().collect();
    by_identity.sort_by_key(|cell| (&cell.identity, cell.index));
    by_identity.windows(2).find(|pair| pair[0].identity == pair[1].identity).map(|pair| (pair[0], pair[1]))
}

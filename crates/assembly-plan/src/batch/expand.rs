//! From a matrix to its cells.

use std::path::{Path, PathBuf};

use scene::Scene;

use super::arguments::MatrixArguments;
use super::manifest::Cell;
use super::matrix::{Key, Matrix, Starts};
use crate::console::tell;
use crate::failure::Failure;
use crate::problem::{Problem, homotopy};

/// So many digits of a hash name a folder.
const NAME_DIGITS: usize = 16;

/// All cells, with absolute paths: scene by scene, start by start, by magnitude, by homotopy. Everything is read and
/// checked here, so that a mistake shows before anything is solved.
///
/// # Errors
/// The first thing that is wrong.
pub fn cells(arguments: &MatrixArguments) -> Result<Vec<Cell>, Failure> {
    let matrix = Matrix::load(arguments)?;
    if matrix.scenes.is_empty() {
        return Err(matrix.refuse(Key::Scenes, "at least one scene is needed"));
    }
    let mut cells = Vec::new();
    for file in &matrix.scenes {
        scene_cells(&matrix, file, &mut cells)?;
    }
    for (index, cell) in cells.iter_mut().enumerate() {
        cell.index = index;
    }
    match twins(&cells) {
        Some((one, other)) => {
            let message = format!("{} and {} are the same problem; name it once", one.label(), other.label());
            Err(matrix.refuse(Key::Scenes, &message))
        }
        None => Ok(cells),
    }
}

fn scene_cells(matrix: &Matrix, file: &Path, cells: &mut Vec<Cell>) -> Result<(), Failure> {
    let scene = Scene::load(file)?;
    for warning in &scene.warnings {
        tell!("warning: {warning}");
    }
    let solver = matrix.linear_solver.as_deref();
    let mut homotopies = Vec::new();
    for file in &matrix.homotopies {
        homotopies.push((Some(absolute(file)?), homotopy(&scene, Some(file), solver)?));
    }
    if homotopies.is_empty() {
        homotopies.push((None, homotopy(&scene, None, solver)?));
    }
    let deltas = if matrix.deltas.is_empty() { &[scene.offset_magnitude][..] } else { &matrix.deltas };
    for start in starts(matrix, file, &scene)? {
        for &delta_m in deltas {
            for (homotopy_file, homotopy) in &homotopies {
                let problem = Problem::new(&scene, Some(start), Some(delta_m), homotopy.clone())
                    .map_err(|error| matrix.refuse(Key::Deltas, &error.to_string()))?;
                cells.push(Cell {
                    index: 0,
                    scene: absolute(file)?,
                    start: start.to_owned(),
                    delta_m,
                    homotopy: homotopy_file.clone(),
                    linear_solver: matrix.linear_solver.clone(),
                    folder: Path::new("cells").join(&problem.identity[..NAME_DIGITS]),
                    identity: problem.identity,
                });
            }
        }
    }
    Ok(())
}

fn starts<'scene>(matrix: &'scene Matrix, file: &Path, scene: &'scene Scene) -> Result<Vec<&'scene str>, Failure> {
    match &matrix.starts {
        Starts::First => Ok(vec![&scene.starts[0].name]),
        Starts::All => Ok(scene.starts.iter().map(|start| start.name.as_str()).collect()),
        Starts::Named(names) => {
            let known = |name: &'scene String| match scene.start(Some(name)) {
                Ok(_) => Ok(name.as_str()),
                Err(message) => Err(matrix.refuse(Key::Starts, &format!("{}: {message}", file.display()))),
            };
            names.iter().map(known).collect()
        }
    }
}

fn absolute(file: &Path) -> Result<PathBuf, Failure> {
    file.canonicalize().map_err(|error| Failure::io(file, &error))
}

/// Two cells that solve the same problem.
fn twins(cells: &[Cell]) -> Option<(&Cell, &Cell)> {
    let mut by_identity: Vec<&Cell> = cells.iter().collect();
    by_identity.sort_by_key(|cell| (&cell.identity, cell.index));
    by_identity.windows(2).find(|pair| pair[0].identity == pair[1].identity).map(|pair| (pair[0], pair[1]))
}

//! The state of a batch.

use planner::batch::{CellState, Manifest};

use crate::console::say;
use crate::exit::Exit;

const WORDS: [&str; 4] = ["planned", "running", "failed", "to do"];

/// Prints how many cells are planned, running, failed and to do, and names those that run or have failed.
pub fn status(manifest: &Manifest) -> Exit {
    let states: Vec<CellState> = manifest.cells.iter().map(|cell| CellState::of(manifest, cell)).collect();
    let count = |word: &str| states.iter().filter(|state| state.word() == word).count();
    let counts = WORDS.map(|word| format!("{} {word}", count(word)));
    say!("{} cells: {}", states.len(), counts.join(", "));
    for (cell, state) in manifest.cells.iter().zip(&states) {
        let folder = manifest.folder.join(&cell.folder);
        match (state, state.failure()) {
            (CellState::Running, _) => say!("running: {} (see {})", cell.label(), folder.display()),
            (_, Some(reason)) => say!("failed: {}: {reason} (see {})", cell.label(), folder.display()),
            _ => {}
        }
    }
    Exit::Done
}

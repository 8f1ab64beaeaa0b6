//! Where a batch stands.

use super::manifest::Manifest;
use super::outcome::State;
use crate::DONE;
use crate::console::say;
use crate::failure::Failure;

const WORDS: [&str; 4] = ["done", "running", "failed", "to do"];

/// Prints how many cells are done, running, failed and to do, and names those that run or have failed.
pub fn status(manifest: &Manifest) -> Result<u8, Failure> {
    let states: Vec<State> = manifest.cells.iter().map(|cell| State::of(manifest, cell)).collect();
    let count = |word: &str| states.iter().filter(|state| state.word() == word).count();
    let counts = WORDS.map(|word| format!("{} {word}", count(word)));
    say!("{} cells: {}", states.len(), counts.join(", "));
    for (cell, state) in manifest.cells.iter().zip(&states) {
        let folder = manifest.folder.join(&cell.folder);
        match (state, state.failure()) {
            (State::Running, _) => say!("running: {} (see {})", cell.label(), folder.display()),
            (_, Some(reason)) => say!("failed: {}: {reason} (see {})", cell.label(), folder.display()),
            _ => {}
        }
    }
    Ok(DONE)
}

//! `generate`: write the scene of a peg and its hole.

use planner::files::write_new_scene;
use planner::require_plannable;

use crate::arguments::GenerateArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the scene.
pub fn run(arguments: &GenerateArguments) -> Result<Exit, CommandError> {
    let (peg, file) = arguments.peg();
    let scene = peg.scene().map_err(|error| CommandError::Usage(error.to_string()))?;
    require_plannable(&file.out, &scene)?;
    write_new_scene(&file.out, &scene, file.force)?;
    say!("written to {}", file.out.display());
    Ok(Exit::Done)
}

//! `new`: write a scene to begin with.

use planner::PlannerError;
use planner::files::write_new_scene;
use scene::{FilePair, starter_scene};

use crate::arguments::NewArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the scene.
pub fn run(arguments: &NewArguments) -> Result<Exit, CommandError> {
    let text = starter_scene(&arguments.file, arguments.files().as_ref()).map_err(PlannerError::from)?;
    write_new_scene(&arguments.file, &text, arguments.force)?;
    say!("written to {}", arguments.file.display());
    Ok(Exit::Done)
}

impl NewArguments {
    /// The files of parts, if any are named; the command line wants both or none.
    fn files(&self) -> Option<FilePair> {
        let (body, environment) = (self.body.clone()?, self.environment.clone()?);
        Some(FilePair { body, environment, unit: self.unit.clone(), axis: self.axis })
    }
}

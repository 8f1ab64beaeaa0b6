//! `schema`: JSON schemas, with which editors complete and check files.

use planner::PlannerError;
use scene::{homotopy_schema, scene_schema};

use crate::arguments::SchemaArguments;
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Prints the schema of scene or homotopy files.
pub fn run(arguments: &SchemaArguments) -> Result<Exit, CommandError> {
    let schema = if arguments.homotopy { homotopy_schema() } else { scene_schema() };
    let json = serde_json::to_string_pretty(&schema).map_err(|_| PlannerError::Internal("a schema"))?;
    say!("{json}");
    Ok(Exit::Done)
}

//! `export`: what a robot reads of a plan.

use export::Request;

use crate::arguments::ExportArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};

/// Writes the folder of an export and lists its content.
pub fn run(arguments: &ExportArguments) -> Result<Exit, CommandError> {
    let written = export::write(&Request {
        plan: &arguments.folder,
        target: arguments.to,
        rate: arguments.rate,
        out: arguments.out.as_deref(),
        anyway: arguments.anyway,
    })?;
    for remark in &written.remarks {
        tell!("warning: {remark}");
    }
    let folder = written.folder.display();
    say!("written to {folder}: {}", written.files.join(", "));
    say!("{folder}/{} explains how to check and run it", export::README);
    Ok(Exit::Done)
}

//! `batch`: every start, offset magnitude and homotopy of some scenes, on one machine or as a job array. Each cell is
//! solved by a `solve` of its own, in a process of its own.

mod process;
mod run;
mod status;
mod submit;
mod tally;

use planner::batch::{Manifest, collect, expand};

use crate::arguments::{BatchArguments, BatchCommand, MatrixArguments};
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::report;

/// Runs one of the steps or, when none is named, all that a batch on this machine needs.
pub fn run(arguments: &BatchArguments) -> Result<Exit, CommandError> {
    match &arguments.step {
        None => {
            if arguments.report {
                report::require_writable(&arguments.matrix.folder()?)?;
            }
            let manifest = write_manifest(&arguments.matrix)?;
            let exit = run::run(&manifest, &manifest.cells, arguments.jobs, &arguments.progress)?;
            if exit != Exit::Interrupted {
                write_tables(&manifest)?;
                if arguments.report {
                    report::write_into(&manifest.folder)?;
                }
            }
            Ok(exit)
        }
        Some(BatchCommand::Expand(matrix)) => write_manifest(matrix).map(|_| Exit::Done),
        Some(BatchCommand::Run(arguments)) => {
            let manifest = Manifest::load(&arguments.folder)?;
            let cells = run::select(&manifest, arguments.index, arguments.count)?;
            run::run(&manifest, cells, arguments.jobs, &arguments.progress)
        }
        Some(BatchCommand::Status(arguments)) => Ok(status::status(&Manifest::load(&arguments.folder)?)),
        Some(BatchCommand::Collect(arguments)) => write_tables(&Manifest::load(&arguments.folder)?),
        Some(BatchCommand::Submit(arguments)) => submit::submit(&Manifest::load(&arguments.folder)?, arguments),
    }
}

/// Writes the manifest, unless it stands there already.
fn write_manifest(arguments: &MatrixArguments) -> Result<Manifest, CommandError> {
    let folder = arguments.folder()?;
    let (cells, warnings) = expand(&arguments.matrix()?)?;
    warnings.iter().for_each(|warning| tell!("warning: {warning}"));
    let manifest = Manifest::new(&folder, cells)?;
    let (count, file) = (manifest.cells.len(), manifest.file());
    match manifest.write()? {
        true => tell!("{count} cells written to {}", file.display()),
        false => tell!("{count} cells, as {} already says", file.display()),
    }
    Ok(manifest)
}

fn write_tables(manifest: &Manifest) -> Result<Exit, CommandError> {
    for file in collect(manifest)? {
        say!("written {}", file.display());
    }
    Ok(Exit::Done)
}

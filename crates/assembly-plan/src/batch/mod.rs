//! `batch`: every start, offset magnitude and homotopy of some scenes, on one machine or as a job array.
//!
//! [`mod@expand`] turns a [`matrix`] into the cells of an immutable [`manifest`]; [`mod@run`] solves them, each by a
//! `solve` of its own in a folder named after what it solves. The files are the truth: a cell is finished when its
//! `result.json` stands, and being solved while a process holds the lock on its log. So any number of runs, on one
//! machine or many, share one folder, and each can be killed at any moment and started again.

mod arguments;
mod collect;
mod expand;
mod manifest;
mod matrix;
mod outcome;
mod process;
mod progress;
mod run;
mod status;
mod submit;

pub use arguments::BatchArguments;

use crate::console::tell;
use crate::failure::Failure;
use crate::{DONE, INTERRUPTED};
use arguments::{BatchCommand, MatrixArguments};
use manifest::Manifest;

/// Runs one of the steps or, when none is named, all that a batch on this machine needs.
pub fn run(arguments: &BatchArguments) -> Result<u8, Failure> {
    match &arguments.step {
        None => {
            let manifest = expand(&arguments.matrix)?;
            let code = run::run(&manifest, &manifest.cells, arguments.jobs)?;
            if code != INTERRUPTED {
                collect::collect(&manifest)?;
            }
            Ok(code)
        }
        Some(BatchCommand::Expand(matrix)) => expand(matrix).map(|_| DONE),
        Some(BatchCommand::Run(arguments)) => {
            let manifest = Manifest::load(&arguments.folder)?;
            let cells = run::select(&manifest, arguments.index, arguments.count)?;
            run::run(&manifest, cells, arguments.jobs)
        }
        Some(BatchCommand::Status(arguments)) => status::status(&Manifest::load(&arguments.folder)?),
        Some(BatchCommand::Collect(arguments)) => collect::collect(&Manifest::load(&arguments.folder)?).map(|()| DONE),
        Some(BatchCommand::Submit(arguments)) => submit::submit(&Manifest::load(&arguments.folder)?, arguments),
    }
}

/// Writes the manifest, unless it stands there already.
fn expand(arguments: &MatrixArguments) -> Result<Manifest, Failure> {
    let manifest = Manifest::new(&arguments.folder()?, expand::cells(arguments)?)?;
    let cells = manifest.cells.len();
    let file = manifest.file();
    match manifest.write()? {
        true => tell!("{cells} cells written to {}", file.display()),
        false => tell!("{cells} cells, as {} already says", file.display()),
    }
    Ok(manifest)
}

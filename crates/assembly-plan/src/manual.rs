//! `man`: the manual pages.

use std::fs::create_dir_all;

use clap::CommandFactory;

use crate::arguments::{Arguments, ManualArguments};
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Writes the pages of the program and of every command.
pub fn run(arguments: &ManualArguments) -> Result<Exit, CommandError> {
    let folder = &arguments.folder;
    create_dir_all(folder).and_then(|()| clap_mangen::generate_to(Arguments::command(), folder)).map_err(|error| {
        CommandError::System(format!("{}: the manual cannot be written: {error}", folder.display()))
    })?;
    say!("written to {}", folder.display());
    Ok(Exit::Done)
}

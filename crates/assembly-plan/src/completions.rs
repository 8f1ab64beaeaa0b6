//! `completions`: what shells need to complete a command line.

use clap::CommandFactory;

use crate::arguments::{Arguments, CompletionsArguments};
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Prints the script of a shell.
pub fn run(arguments: &CompletionsArguments) -> Result<Exit, CommandError> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "assembly-plan", &mut script);
    say!("{}", String::from_utf8_lossy(&script).trim_end());
    Ok(Exit::Done)
}

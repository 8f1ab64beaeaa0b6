//! `completions`: what shells need to complete a command line.

use clap_complete::{Shell, generate};

use crate::arguments::{CompletionsArguments, command_line};
use crate::console::say;
use crate::exit::{CommandError, Exit};

/// Prints the script of a shell.
pub fn run(arguments: &CompletionsArguments) -> Result<Exit, CommandError> {
    let mut script = Vec::new();
    generate(arguments.shell, &mut command_line(), "assembly-plan", &mut script);
    let mut script = String::from_utf8_lossy(&script).into_owned();
    if arguments.shell == Shell::Bash {
        // The generator writes the hyphen of the name as `__` where it recognises a command and as `__subcmd__` where it
        // completes one.
        script = script.replace("assembly__subcmd__plan", "assembly__plan");
    }
    say!("{}", script.trim_end());
    Ok(Exit::Done)
}

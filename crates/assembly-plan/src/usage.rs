//! Parses the command line, and advises on mistakes.

use std::ffi::OsString;
use std::io::{Write, stdout};

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error, FromArgMatches};

use crate::arguments::{Arguments, command_line};
use crate::console::{lose, lost, tell};
use crate::exit::Exit;

/// Names that people try, and flags that they may mean, the likeliest first.
const MEANT: &[(&str, &[&str])] = &[
    ("tolerance", &["position-tolerance"]),
    ("tol", &["position-tolerance"]),
    ("offset", &["delta", "magnitude", "offsets"]),
    ("offsets", &["delta", "deltas"]),
    ("offset-magnitude", &["delta", "magnitude"]),
    ("magnitudes", &["magnitude"]),
    ("frictions", &["friction"]),
    ("mu", &["friction"]),
    ("rotation", &["rotation-error"]),
    ("threads", &["jobs"]),
    ("output", &["out"]),
    ("target", &["to"]),
    ("format", &["to"]),
    ("time", &["time-limit"]),
    ("timeout", &["time-limit"]),
    ("solver", &["linear-solver"]),
    ("overwrite", &["force"]),
    ("success-rate", &["target-rate"]),
];

/// The arguments, of which the first is the program's name. Ends the process after help, a version or a mistake, with
/// the exit code 2 after a mistake, and 3 where the output cannot be written.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Arguments {
    let mut command = command_line();
    let words = present(arguments.into_iter().collect());
    command
        .try_get_matches_from_mut(&words)
        .and_then(|matches| Arguments::from_arg_matches(&matches))
        .unwrap_or_else(|error| exit_with(&advised(error, subcommand(&command, &words))))
}

/// Arguments with the present names of flags. Warns of the former ones.
fn present(words: Vec<OsString>) -> Vec<OsString> {
    let end = words.iter().position(|word| word == "--").unwrap_or(words.len());
    let present = |(index, word): (usize, OsString)| {
        let Some(text) = word.to_str().filter(|_| index < end) else { return word };
        let (flag, value) = text.find('=').map_or((text, ""), |place| text.split_at(place));
        let Some(renamed) = input::FLAGS.iter().find(|renamed| renamed.old == flag) else { return word };
        tell!("warning: {}", renamed.warning());
        format!("{}{value}", renamed.new).into()
    };
    words.into_iter().enumerate().map(present).collect()
}

fn exit_with(error: &Error) -> ! {
    if let Err(lost) = error.print().and_then(|()| stdout().flush()) {
        lose("standard output", &lost);
    }
    std::process::exit(lost().map_or(error.exit_code(), |_| Exit::Failed as i32))
}

/// The command whose arguments some words are.
fn subcommand<'command>(command: &'command Command, words: &[OsString]) -> &'command Command {
    words
        .iter()
        .skip(1)
        .map_while(|word| word.to_str())
        .fold(command, |command, word| command.find_subcommand(word).unwrap_or(command))
}

/// An error with advice on an argument that the command does not know.
fn advised(mut error: Error, command: &Command) -> Error {
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else { return error };
    let argument = argument.clone();
    if error.kind() != ErrorKind::UnknownArgument {
        return error;
    }
    if let Some(flag) = argument.strip_prefix("--") {
        // Advice that a value may begin with hyphens is of no use here.
        error.remove(ContextKind::Suggested);
        if let Some(meant) = meant(flag, command) {
            error.insert(ContextKind::SuggestedArg, ContextValue::String(format!("--{meant}")));
            error.insert(ContextKind::Usage, ContextValue::StyledStr(command.clone().render_usage()));
        }
    } else if argument.parse::<f64>().is_ok()
        && command.get_arguments().any(|known| known.get_value_delimiter().is_some())
    {
        let tip = "numbers of a list are separated by commas, without spaces: 0,0.1";
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
    }
    error
}

/// The flag of a command that a wrong one most likely means.
fn meant(flag: &str, command: &Command) -> Option<&'static str> {
    let (_, candidates) = MEANT.iter().find(|(name, _)| *name == flag)?;
    candidates.iter().copied().find(|name| command.get_arguments().any(|known| known.get_long() == Some(*name)))
}

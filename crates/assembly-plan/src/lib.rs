//! The command line of assembly-plan: parse, call the planner, show. A library, so that the Python package has it too.

mod arguments;
mod batch;
mod calibrate;
mod check;
mod completions;
mod console;
mod exit;
mod export;
mod generate;
mod interrupt;
mod manual;
mod new;
mod played;
mod program;
mod progress;
mod report;
mod schema;
mod shell;
mod simulate;
mod solve;
mod summary;
mod tolerance;
mod usage;
mod values;

use std::ffi::OsString;

use planner::RunClock;

use crate::arguments::Command;
use crate::console::tell;
use crate::exit::Exit;

pub use program::Program;

/// Runs the command line with arguments, of which the first is the program's name. `program` starts it again: a batch
/// solves each of its cells in a process of its own.
///
/// Returns the exit code; what help, a wrong usage and some interrupts end, ends the process.
pub fn run(program: Program, arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let clock = RunClock::start();
    program.remember();
    let arguments = usage::parse(arguments);
    let outcome = interrupt::begin().and_then(|()| match &arguments.command {
        Command::Solve(arguments) => solve::run(arguments, clock),
        Command::Simulate(arguments) => simulate::run(arguments),
        Command::Batch(arguments) => batch::run(arguments),
        Command::Tolerance(arguments) => tolerance::run(arguments, clock),
        Command::Report(arguments) => report::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Calibrate(arguments) => calibrate::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::New(arguments) => new::run(arguments),
        Command::Generate(arguments) => generate::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Completions(arguments) => completions::run(arguments),
        Command::Man(arguments) => manual::run(arguments),
    });
    let exit = outcome.unwrap_or_else(|error| {
        tell!("error: {error}");
        Exit::from(&error)
    });
    if let Some(lost) = console::lost() {
        tell!("error: {lost}");
        return Exit::Failed as u8;
    }
    exit as u8
}

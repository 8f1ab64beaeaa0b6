//! The command line of assembly-plan: parse, call the planner, show.

mod arguments;
mod batch;
mod check;
mod console;
mod exit;
mod export;
mod generate;
mod interrupt;
mod new;
mod progress;
mod report;
mod schema;
mod simulate;
mod solve;
mod summary;
mod values;

use std::process::ExitCode;

use clap::Parser;

use crate::arguments::{Arguments, Command};
use crate::console::tell;
use crate::exit::Exit;

fn main() -> ExitCode {
    // Clap prints usage errors itself and exits with 2.
    let arguments = Arguments::parse();
    let outcome = match &arguments.command {
        Command::Solve(arguments) => solve::run(arguments),
        Command::Simulate(arguments) => simulate::run(arguments),
        Command::Batch(arguments) => batch::run(arguments),
        Command::Report(arguments) => report::run(arguments),
        Command::Export(arguments) => export::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::New(arguments) => new::run(arguments),
        Command::Generate(arguments) => generate::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
    };
    let exit = outcome.unwrap_or_else(|error| {
        tell!("error: {error}");
        Exit::from(&error)
    });
    ExitCode::from(exit as u8)
}

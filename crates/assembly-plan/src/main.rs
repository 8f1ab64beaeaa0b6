//! The command line of assembly-plan.

mod arguments;
mod batch;
mod check;
mod checkpoint;
mod console;
mod failure;
mod interrupt;
mod limits;
mod output;
mod plan;
mod planned;
mod played;
mod problem;
mod progress;
mod result;
mod robust;
mod simulate;
mod smoothing;
mod solve;
mod stage;
mod success_table;
mod trace;

use std::process::ExitCode;

use clap::Parser;

use crate::arguments::{Arguments, Command};
use crate::console::tell;

/// The goal is reached and everything is written.
const DONE: u8 = 0;
/// The plan did not converge or does not reach the goal.
const NO_PLAN: u8 = 1;
/// The user stopped the program.
const INTERRUPTED: u8 = 130;

fn main() -> ExitCode {
    // Clap prints usage errors itself and exits with 2.
    let arguments = Arguments::parse();
    let outcome = match &arguments.command {
        Command::Solve(arguments) => solve::run(arguments),
        Command::Simulate(arguments) => simulate::run(arguments),
        Command::Batch(arguments) => batch::run(arguments),
        Command::Check(arguments) => check::run(arguments),
    };
    let code = outcome.unwrap_or_else(|failure| {
        tell!("error: {failure}");
        failure.exit_code()
    });
    ExitCode::from(code)
}

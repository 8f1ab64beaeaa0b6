//! The program `assembly-plan`.

use std::process::ExitCode;

use assembly_plan::{Program, run};

fn main() -> ExitCode {
    ExitCode::from(run(Program::itself(), std::env::args_os()))
}

//! The program `assembly-plan`.

use std::panic::resume_unwind;
use std::process::ExitCode;
use std::thread::Builder;

use assembly_plan::{Program, run};

/// Stack (bytes): that of the first thread is what the user's limits (`ulimit -s`) leave of it.
const STACK: usize = 8 << 20;

fn main() -> ExitCode {
    let program = || run(Program::itself(), std::env::args_os());
    match Builder::new().stack_size(STACK).spawn(program) {
        Ok(thread) => ExitCode::from(thread.join().unwrap_or_else(|panic| resume_unwind(panic))),
        Err(error) => {
            eprintln!("error: the program cannot begin a thread: {error}");
            ExitCode::from(3)
        }
    }
}

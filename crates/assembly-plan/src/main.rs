//! The program `assembly-plan`.

use std::process::ExitCode;
use std::thread::Builder;

use assembly_plan::{Program, run};

/// Stack (bytes): that of the first thread is what the user's limits (`ulimit -s`) leave of it.
const STACK: usize = 8 << 20;

/// Exit code of a program that failed.
const FAILED: u8 = 3;

fn main() -> ExitCode {
    let program = || run(Program::itself(), std::env::args_os());
    match Builder::new().stack_size(STACK).spawn(program) {
        // What a panic says is printed already.
        Ok(thread) => ExitCode::from(thread.join().unwrap_or(FAILED)),
        Err(error) => {
            eprintln!("error: the program cannot begin a thread: {error}");
            ExitCode::from(FAILED)
        }
    }
}

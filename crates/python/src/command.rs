//! The command line.

use std::ffi::OsString;

use assembly_plan::Program;
use pyo3::prelude::*;

/// Runs the command line with arguments, of which the first is the program's name. The interpreter with the arguments
/// `first` starts it again. Returns the exit code.
#[pyfunction]
pub fn run_command(py: Python, interpreter: OsString, first: Vec<OsString>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| assembly_plan::run(Program::with_arguments(interpreter, first), arguments))
}

//! How this program is started again.

use std::ffi::OsString;
use std::process::Command;
use std::sync::OnceLock;

/// A program and its first arguments, which start this command line.
#[derive(Debug, Clone)]
pub struct Program(Vec<OsString>);

/// Command that has started the command line of this process.
static PROGRAM: OnceLock<Program> = OnceLock::new();

impl Program {
    /// The executable file of this process.
    pub fn itself() -> Self {
        // Where the system does not provide it, the shell's search finds it.
        Self(vec![std::env::current_exe().map_or_else(|_| "assembly-plan".into(), Into::into)])
    }

    /// A program that runs this command line when it is started with these arguments first, such as an interpreter.
    pub fn with_arguments(program: OsString, first: impl IntoIterator<Item = OsString>) -> Self {
        Self(std::iter::once(program).chain(first).collect())
    }

    /// Keeps it for [`Program::command`] and [`Program::words`]; what is kept first, stays.
    pub(crate) fn remember(self) {
        let _ = PROGRAM.set(self);
    }

    /// Starts the command line again.
    pub(crate) fn command() -> Command {
        let words = Self::words();
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]);
        command
    }

    /// Program and first arguments.
    pub(crate) fn words() -> &'static [OsString] {
        &PROGRAM.get_or_init(Self::itself).0
    }
}

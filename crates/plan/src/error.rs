//! Why something could not be done.

use std::io;
use std::path::{Path, PathBuf};

use nlp::SolveError;
use scene::{SceneError, TaskError};

/// Why something could not be done. Every message names the file, key or flag concerned and what to do.
#[derive(Debug, thiserror::Error)]
pub enum PlannerError {
    /// A scene or homotopy file is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A scene has no task for a choice.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// Ipopt or a linear solver cannot run as asked.
    #[error(transparent)]
    Solver(#[from] SolveError),
    /// The time of the run ended before its scene was read.
    #[error("the time limit ended while the scene was read: allow more with --time-limit")]
    NoTimeToRead,
    /// The session's time ended before the first homotopy step had found anything.
    #[error(
        "the time limit ended before the first homotopy step of {pairs} pairs of parts in {scenarios} scenarios of \
         {steps} steps: allow more with --time-limit, or plan fewer of them"
    )]
    OutOfTime {
        /// Pairs of parts.
        pairs: usize,
        /// Scenarios.
        scenarios: usize,
        /// Steps of the horizon.
        steps: usize,
    },
    /// A value is out of its range.
    #[error("{name} = {value}: {rule}")]
    Value {
        /// Name of the value, in the user's words.
        name: &'static str,
        /// The value.
        value: String,
        /// The valid values.
        rule: String,
    },
    /// A distance could not be computed.
    #[error("distance of {pair}: {source}")]
    Distance {
        /// Body and environment part.
        pair: String,
        /// Why not.
        source: collision::DistanceError,
    },
    /// Settings of a simulation are out of range.
    #[error(transparent)]
    Settings(#[from] simulation::SettingsError),
    /// The arm of the scene cannot be simulated.
    #[error("robot: {0}; check robot.base, robot.grasp and robot.configuration")]
    Arm(#[from] simulation::ArmModelError),
    /// A choice is not possible.
    #[error("{name}: {problem}")]
    Choice {
        /// Name of the choice, in the user's words.
        name: &'static str,
        /// The problem and its solution.
        problem: String,
    },
    /// A file is not what it should be.
    #[error("{}{}: {problem}", file.display(), line.map(|line| format!(":{line}")).unwrap_or_default())]
    File {
        /// The file or folder.
        file: PathBuf,
        /// Line, from 1, where that is known.
        line: Option<usize>,
        /// The problem and its solution.
        problem: String,
    },
    /// A file or folder cannot be read or written.
    #[error("{}: cannot be {action}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// The attempted action: `read` or `written`.
        action: &'static str,
        /// Error of the system.
        source: io::Error,
    },
    /// Something that should be there is not: a mistake of the program.
    #[error("internal error: {0}; please report it")]
    Internal(&'static str),
}

/// The cause of an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// The input is wrong; the message says what would be right.
    Input,
    /// There is no plan, as far as the planner can tell.
    NoPlan,
    /// The system or the program failed.
    System,
}

/// A number as it is, or with an exponent where it has many digits.
pub fn short(value: impl ToString) -> String {
    const LONGEST: usize = 20;
    let text = value.to_string();
    match text.parse::<f64>() {
        Ok(number) if text.len() > LONGEST => format!("{number:e}"),
        _ => text,
    }
}

/// Why a checkpoint cannot be resumed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Unusable {
    /// Another scene, start, offset, homotopy or version.
    #[error("it belongs to another problem")]
    OtherProblem,
    /// A newer version has left it.
    #[error("a newer version of assembly-plan has left it")]
    Newer,
    /// The checkpoint was cut or changed.
    #[error("its checkpoint is damaged")]
    DamagedCheckpoint,
    /// A table of a homotopy step was cut or changed.
    #[error("its tables are damaged")]
    DamagedTables,
    /// Another target of the refinement.
    #[error(
        "it was refined for other requirements: frictions, errors to tolerate, tolerances or parameters of the search"
    )]
    OtherTarget,
    /// The record of the refinement was cut or changed.
    #[error("its refinement is damaged")]
    DamagedRefinement,
    /// A table of the refined plan was cut or changed.
    #[error("the tables of its refinement are damaged")]
    DamagedRefinementTables,
}

/// Whether a file cannot be written because something else stands there.
fn is_in_the_way(kind: io::ErrorKind) -> bool {
    use io::ErrorKind::{AlreadyExists, InvalidInput, IsADirectory, NotADirectory};
    matches!(kind, AlreadyExists | InvalidInput | IsADirectory | NotADirectory)
}

/// Whether the system has no memory or file descriptors left.
fn is_exhausted(error: &io::Error) -> bool {
    const OUT_OF_MEMORY: i32 = 12;
    const TOO_MANY_FILES: [i32; 2] = [23, 24];
    error.raw_os_error().is_some_and(|code| code == OUT_OF_MEMORY || TOO_MANY_FILES.contains(&code))
}

impl PlannerError {
    /// The cause of the error.
    pub fn fault(&self) -> Fault {
        match self {
            Self::NoTimeToRead | Self::OutOfTime { .. } => Fault::NoPlan,
            Self::Io { source, .. } if is_exhausted(source) => Fault::System,
            // What is read was named by the user, and so was what another kind of file stands in the way of.
            Self::Io { action: "read", .. } => Fault::Input,
            Self::Io { source, .. } if is_in_the_way(source.kind()) => Fault::Input,
            Self::Distance { .. } | Self::Solver(SolveError::Problem(_)) | Self::Io { .. } | Self::Internal(_) => {
                Fault::System
            }
            _ => Fault::Input,
        }
    }

    /// A file that is not what it should be.
    pub fn file(file: &Path, problem: impl Into<String>) -> Self {
        Self::File { file: file.to_owned(), line: None, problem: problem.into() }
    }

    /// A line (from 1) of a file that is not what it should be.
    pub fn line(file: &Path, line: usize, problem: impl Into<String>) -> Self {
        Self::File { file: file.to_owned(), line: Some(line), problem: problem.into() }
    }

    /// A value that is out of its range.
    pub fn value(name: &'static str, value: impl ToString, rule: &str) -> Self {
        Self::Value { name, value: short(value), rule: rule.to_owned() }
    }

    /// A file that cannot be read, for `map_err`.
    pub fn read(path: &Path) -> impl FnOnce(io::Error) -> Self {
        |source| Self::Io { path: path.to_owned(), action: "read", source }
    }

    /// A file that cannot be written.
    pub fn written(path: &Path) -> impl FnOnce(io::Error) -> Self {
        |source| Self::Io { path: path.to_owned(), action: "written", source }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_system_has_too_little_of_is_no_fault_of_the_input() {
        let fault = |code: i32| PlannerError::read(Path::new("a"))(io::Error::from_raw_os_error(code)).fault();
        // No memory, too many files; no such file, no permission.
        assert_eq!([12, 23, 24].map(fault), [Fault::System; 3]);
        assert_eq!([2, 13].map(fault), [Fault::Input; 2]);
    }
}

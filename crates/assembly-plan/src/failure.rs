//! Why a command ends without a result.

use std::fmt;
use std::path::Path;

use nlp::SolveError;
use scene::{SceneError, TaskError};

/// What went wrong, by whose fault.
#[derive(Debug)]
pub enum Failure {
    /// The input or the arguments are wrong.
    Input(String),
    /// Anything else.
    Internal(String),
}

impl Failure {
    /// Exit code of the design.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Internal(_) => 3,
        }
    }

    /// A file or folder that cannot be written or read.
    pub fn io(path: &Path, error: &dyn fmt::Display) -> Self {
        Self::Internal(format!("{}: {error}", path.display()))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Input(message) | Self::Internal(message) => formatter.write_str(message),
        }
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<TaskError> for Failure {
    fn from(error: TaskError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::Option { .. } | SolveError::LinearSolver { .. } => Self::Input(error.to_string()),
            SolveError::Problem(_) => Self::Internal(error.to_string()),
        }
    }
}

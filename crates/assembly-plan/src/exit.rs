//! How commands end.

use planner::{Fault, PlannerError};

/// How the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// The request is done, and everything is written.
    Done = 0,
    /// The plan did not converge, does not reach the goal, or is less robust than requested.
    NoPlan = 1,
    /// The input or the arguments are wrong.
    WrongInput = 2,
    /// Anything else.
    Failed = 3,
    /// The user stopped the program.
    Interrupted = 130,
}

impl From<&CommandError> for Exit {
    fn from(error: &CommandError) -> Self {
        match error {
            CommandError::Usage(_) => Self::WrongInput,
            CommandError::System(_) => Self::Failed,
            CommandError::Planner(error) => match error.fault() {
                Fault::Input => Self::WrongInput,
                Fault::NoPlan => Self::NoPlan,
                Fault::System => Self::Failed,
            },
        }
    }
}

/// Why a command ends without a result.
#[derive(Debug)]
pub enum CommandError {
    /// The planner could not do it.
    Planner(PlannerError),
    /// The arguments are wrong.
    Usage(String),
    /// The system could not do it.
    System(String),
}

impl From<PlannerError> for CommandError {
    fn from(error: PlannerError) -> Self {
        Self::Planner(error)
    }
}

impl std::fmt::Display for CommandError {
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Planner(error) => error.fmt(formatter),
            Self::Usage(message) | Self::System(message) => formatter.write_str(message),
        }
    }
}

//! Why a solve is refused.

use crate::options::OptionValue;

/// Why a solve did not begin.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// Ipopt refuses an option.
    #[error(
        "Ipopt refuses the option {name} = {value}: the name is unknown or the value is of the wrong type or out of range"
    )]
    Option {
        /// Its name.
        name: String,
        /// Its value.
        value: OptionValue,
    },
    /// A linear solver cannot be used.
    #[error("linear solver \"{name}\": {reason}")]
    LinearSolver {
        /// Its name.
        name: String,
        /// Why not.
        reason: String,
    },
    /// Sizes of the problem contradict each other.
    #[error("invalid problem: {0}")]
    Problem(String),
}

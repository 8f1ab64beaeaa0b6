//! Outcome of a solve.

use std::fmt;

use ipopt_sys::ApplicationReturnStatus as code;

/// Outcome of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolveStatus {
    /// Converged to the desired tolerances.
    Solved,
    /// Converged to the acceptable tolerances only.
    SolvedToAcceptableLevel,
    /// Converged to a point of local infeasibility.
    Infeasible,
    /// The steps became too small.
    StepTooSmall,
    /// The iterates diverge.
    Diverging,
    /// The observer asked to stop.
    Interrupted,
    /// A feasible point of a square problem was found.
    FeasiblePointFound,
    /// The iteration limit was reached.
    IterationLimit,
    /// The restoration phase failed.
    RestorationFailed,
    /// No step could be computed.
    StepComputationFailed,
    /// The time limit was reached.
    TimeLimit,
    /// More equality constraints than variables.
    TooFewDegreesOfFreedom,
    /// A function returned NaN or an infinite value.
    InvalidNumber,
    /// Not enough memory.
    OutOfMemory,
    /// Any other outcome, by Ipopt's code.
    Other(i32),
}

impl SolveStatus {
    pub(crate) fn from_code(status: code::Type) -> Self {
        match status {
            code::Solve_Succeeded => Self::Solved,
            code::Solved_To_Acceptable_Level => Self::SolvedToAcceptableLevel,
            code::Infeasible_Problem_Detected => Self::Infeasible,
            code::Search_Direction_Becomes_Too_Small => Self::StepTooSmall,
            code::Diverging_Iterates => Self::Diverging,
            code::User_Requested_Stop => Self::Interrupted,
            code::Feasible_Point_Found => Self::FeasiblePointFound,
            code::Maximum_Iterations_Exceeded => Self::IterationLimit,
            code::Restoration_Failed => Self::RestorationFailed,
            code::Error_In_Step_Computation => Self::StepComputationFailed,
            code::Maximum_CpuTime_Exceeded => Self::TimeLimit,
            code::Not_Enough_Degrees_Of_Freedom => Self::TooFewDegreesOfFreedom,
            code::Invalid_Number_Detected => Self::InvalidNumber,
            code::Insufficient_Memory => Self::OutOfMemory,
            other => Self::Other(other),
        }
    }

    /// Whether the final point is a solution.
    pub fn is_success(self) -> bool {
        matches!(self, Self::Solved | Self::SolvedToAcceptableLevel | Self::FeasiblePointFound)
    }
}

impl fmt::Display for SolveStatus {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(match self {
            Self::Solved => "solved",
            Self::SolvedToAcceptableLevel => "solved to an acceptable level",
            Self::Infeasible => "converged to a point of local infeasibility",
            Self::StepTooSmall => "the steps became too small",
            Self::Diverging => "the iterates diverge",
            Self::Interrupted => "interrupted",
            Self::FeasiblePointFound => "feasible point found",
            Self::IterationLimit => "iteration limit reached",
            Self::RestorationFailed => "the restoration of feasibility failed",
            Self::StepComputationFailed => "no step could be computed",
            Self::TimeLimit => "time limit reached",
            Self::TooFewDegreesOfFreedom => "more equality constraints than variables",
            Self::InvalidNumber => "a function returned NaN or an infinite value",
            Self::OutOfMemory => "out of memory",
            Self::Other(code) => return write!(formatter, "Ipopt failed with code {code}"),
        })
    }
}

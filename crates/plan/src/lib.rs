//! A planning problem, its solution, and its rollouts: in memory, without files of its own.
//!
//! | module | what it holds |
//! |---|---|
//! | [`Problem`] | one start and offset magnitude of a scene with its homotopy: the one gate for all input |
//! | [`solve()`] | from a problem to a [`Plan`] |
//! | [`simulate`](mod@simulate) | rollouts of plans, success rates |
//! | [`Session`], [`Keeper`] | who watches a computation, how it is stopped, where unfinished work is kept |
//! | [`RobustnessTarget`], [`parameters`] | what robust plans must tolerate, and the parameters of the search for them |
//! | [`records`] | what files say of motions and errors |

mod arm_course;
mod attempt;
pub mod carried;
mod checkpoint;
pub mod clearance;
mod clock;
mod digest;
pub mod directions;
mod engagement;
mod error;
mod event_record;
mod format;
mod homotopy_run;
mod iteration;
mod keeper;
mod length;
mod moved;
pub mod or_null;
pub mod parameters;
mod plan;
pub mod pose_clearance;
mod problem;
pub mod ranges;
pub mod records;
mod robustness;
mod sealed;
mod session;
pub mod simulate;
mod solve;
mod success_rates;
mod success_table;
mod target;
#[cfg(test)]
mod testing;
mod tolerance;
mod unsolved;
mod variant;

pub use arm_course::ArmCourse;
pub use checkpoint::Checkpoint;
pub use clock::{Now, RunClock};
pub use digest::{Hasher, hash, reference_hash};
pub use engagement::{Engagement, Entrance, engagement};
pub use error::{Fault, PlannerError, Unusable, short};
pub use format::Format;
pub use homotopy_run::HomotopyRun;
pub use iteration::{Fallbacks, IterationRecord, PlanIteration, Split, StageSolverRecord};
pub use keeper::Keeper;
pub use length::Millimetres;
pub use moved::moved;
pub use parameters::RobustParameters;
pub use plan::{Cut, Outcome, Plan, PlanStatus, Stop};
pub use problem::{Choices, Problem, VERSION, homotopy};
pub use robustness::{PushReport, RobustnessReport, Round, TestReport};
pub use sealed::{seal, unseal};
pub use session::{Event, Observer, Session};
pub use simulate::{
    GraspErrors, Motion, OffsetSource, PlayedRollout, Region, RolloutRemarks, SimulationRequest, simulate,
    simulate_each,
};
pub use solve::{EarlyEnd, solve, solve_until};
pub use success_rates::{OffsetRegion, SuccessRate, SuccessRates, interval, max_force, rate};
pub use success_table::{SuccessGroup, SuccessTable};
pub use target::RobustnessTarget;
pub use tolerance::ChosenTolerance;
pub use unsolved::unsolved;
pub use variant::Variant;

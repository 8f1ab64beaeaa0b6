//! Plans of robotic assembly motions: load, check, solve, simulate, refine, batches, and the files of all that.
//!
//! Nothing here prints, reads arguments or handles signals: a [`Session`] says who watches a computation and how it is
//! stopped, a [`PlannerError`] why something could not be done.
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//!
//! use planner::{Choices, Event, Motion, Problem, RobustnessTarget, Session, SimulationRequest};
//!
//! # fn main() -> Result<(), planner::PlannerError> {
//! let scene = std::path::Path::new("../../scenes/corner.toml");
//! let problem = Problem::load(scene, &Choices { delta: Some(0.01), ..Choices::default() })?;
//! let stopped = AtomicBool::new(false);
//! let session = Session::new(&|_: &Event| {}, &stopped);
//! let plan = planner::solve(&problem, &session)?;
//! let request = SimulationRequest { frictions: vec![0.0, 0.1], ..SimulationRequest::default() };
//! let rollouts = planner::simulate(&problem, &[(Motion::Plan, plan.reference())], &request, &session)?;
//! let lost = rollouts.iter().filter(|rollout| rollout.motion == Motion::Plan && !rollout.success).count();
//! println!("{}: {lost} rollouts miss the goal", plan.status());
//! let target = RobustnessTarget { frictions: vec![0.0], ..RobustnessTarget::default() };
//! let robust = planner::refine(plan, &target, &session)?;
//! assert!(robust.reaches_goal());
//! # Ok(())
//! # }
//! ```
//!
//! | module | what it holds |
//! |---|---|
//! | [`Problem`] | one start and offset magnitude of a scene with its homotopy: the one gate for all input |
//! | [`solve`], [`refine`](mod@refine) | from a problem to a [`Plan`], and to a robust one |
//! | [`simulate`](mod@simulate) | rollouts of plans, success rates |
//! | [`Execution`] | what a robot did, beside a rollout |
//! | [`explain`] | why a plan is not done |
//! | [`ArmCourse`] | how the joints of an arm move along a plan |
//! | [`starter`](fn@starter) | a scene to begin with, from two files |
//! | [`check`](mod@check) | what a scene says, without solving it |
//! | [`batch`] | every start, offset magnitude and homotopy of some scenes |
//! | [`files`] | every file that is written or read |
//!
//! The paper is *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives*
//! by Dietz et al., numbers as in the preprint:
//!
//! | paper | label | here |
//! |---|---|---|
//! | homotopy, Sec. V-D | `Sec. ocp:homotopy` | [`solve()`] |
//! | Fig. 12, success by modelled and injected offset | `Fig. realworldresults` | [`SuccessTable`] |

mod arm_course;
mod attempt;
pub mod batch;
pub mod carried;
pub mod check;
mod checkpoint;
mod clearance;
mod clock;
mod digest;
mod directions;
mod engagement;
mod error;
mod event_record;
mod executed;
pub mod explain;
pub mod files;
mod format;
mod homotopy_run;
mod iteration;
mod keeper;
mod length;
mod or_null;
mod plan;
mod play;
mod problem;
mod ranges;
mod records;
pub mod refine;
mod robustness;
mod sealed;
mod session;
pub mod simulate;
mod solve;
mod starter;
mod success_rates;
mod success_table;
mod tolerance;
mod variant;
pub mod warnings;

pub use arm_course::ArmCourse;
pub use clock::{Now, RunClock};
pub use directions::axis_name;
pub use engagement::{Engagement, engagement};
pub use error::{Fault, PlannerError, Unusable};
pub use executed::{Ending, Execution};
pub use iteration::{Fallbacks, IterationRecord, PlanIteration, Split, StageSolverRecord};
pub use keeper::Keeper;
pub use length::Millimetres;
pub use nlp::Progress as SolverProgress;
pub use ocp::Event as SolverEvent;
pub use plan::{Cut, Outcome, Plan, PlanStatus, Stop};
pub use problem::{Choices, Problem, VERSION, homotopy};
pub use records::AttemptRecord;
pub use refine::{RobustnessTarget, refine, refine_reference, test};
pub use robustness::{PushReport, RobustnessReport, Round, TestReport};
pub use session::{Event, Observer, Session};
pub use simulate::{GraspErrors, Motion, OffsetSource, PlayedRollout, Region, SimulationRequest, simulate};
pub use solve::solve;
pub use starter::{Starter, StarterFit, starter};
pub use success_rates::{OffsetRegion, SuccessRate, SuccessRates, interval, max_force, rate};
pub use success_table::{SuccessGroup, SuccessTable};
pub use tolerance::ChosenTolerance;
pub use variant::Variant;

/// The examples of `docs/library.md` compile.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/library.md")]
struct LibraryPage;

//! Plans of robotic assembly motions: load, check, solve, simulate, refine, batches, and the files of all that. The work is done in
//! crates of their own, which this one puts under one name.
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
//! let problem = Problem::load(scene, &Choices { offset_magnitude: Some(0.01), ..Choices::default() })?;
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
//! | here | what it holds |
//! |---|---|
//! | [`Problem`], [`solve()`], [`simulate`](mod@simulate) | the crate `plan`: a problem, its solution, rollouts of that |
//! | [`check`](mod@check), [`explain`], [`warnings`] | `diagnosis`: why a scene or a plan does not work |
//! | [`refine()`], [`test()`] | `refine`: robust plans |
//! | [`files`], [`batch`], [`Execution`] | `store`: every file that is written or read |
//! | [`starter`](fn@starter) | a scene to begin with, from two files |
//!
//! The paper is *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives*
//! by Dietz et al., numbers as in the preprint:
//!
//! | paper | label | here |
//! |---|---|---|
//! | homotopy, Sec. V-D | `Sec. ocp:homotopy` | [`solve()`] |
//! | Fig. 12, success by modelled and injected offset | `Fig. realworldresults` | [`SuccessTable`] |

mod starter;

/// Every file of a plan, a batch or a simulation.
pub mod files {
    pub use plan::records::{AdmittanceRecord, Extreme, GraspRecord, MotionRecord};
    pub use plan::{Checkpoint, Format, hash};
    pub use refine::{BestRecord, RefinementCheckpoint, TestCaseRecord};
    pub use store::*;
}

pub use ::refine::{refine, refine_reference, solve_robust, test};
pub use diagnosis::{check, explain, warnings};
pub use nlp::Progress as SolverProgress;
pub use ocp::Event as SolverEvent;
pub use plan::directions::axis_name;
pub use plan::records::AttemptRecord;
pub use plan::{
    ArmCourse, Choices, ChosenTolerance, Cut, Engagement, Event, Fallbacks, Fault, GraspErrors, IterationRecord,
    Keeper, Millimetres, Motion, Now, Observer, OffsetRegion, OffsetSource, Outcome, Plan, PlanIteration, PlanStatus,
    PlannerError, PlayedRollout, Problem, PushReport, Region, RobustParameters, RobustnessReport, RobustnessTarget,
    RolloutRemarks, Round, RunClock, Session, SimulationRequest, Split, StageSolverRecord, Stop, SuccessGroup,
    SuccessRate, SuccessRates, SuccessTable, TestReport, Unusable, VERSION, Variant, carried, engagement, homotopy,
    interval, max_force, moved, rate, simulate, simulate_each, solve,
};
pub use starter::{Starter, StarterFit, require_plannable, starter};
pub use store::{Ending, Execution, batch};

/// The examples of `docs/reference/library.md` compile.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/reference/library.md")]
struct LibraryPage;

//! Rollouts of a plan under injected offsets with hard contacts, success statistics, and refinement by them.
//!
//! A plan is converged when Ipopt says so; it is good when a body that tracks it under the impedance law, with offsets
//! that were not planned for, ends at the goal. The body is that of the plan: constant inertia, no gravity, no gyroscopic
//! term. It starts displaced by the offset, the controller never learns of it, and after the last knot the reference
//! rests until the outcome is judged.
//!
//! ```
//! use simulation::{Reference, Rollout, Settings, Success, offsets};
//!
//! /// Successes of 100 rollouts with random offsets.
//! fn successes(task: &task::AssemblyTask, plan: &task::Trajectory) -> usize {
//!     let reference = Reference::new(plan.time_step, &plan.reference);
//!     let rollout = Rollout::new(task, Settings { friction: 0.1, ..Settings::default() });
//!     let outcomes = rollout.simulate(&reference, &offsets::hull(&task.offsets, 100, 1), 2);
//!     outcomes.iter().filter(|outcome| outcome.is(&Success::default())).count()
//! }
//! ```
//!
//! A [`Refinement`] changes a reference until it passes all trials of an [`Examiner`].
//!
//! Contacts are neither smoothed nor relaxed, and nothing of the planner's collision kernel is used, so that a mistake
//! there shows here: contact points come from the facets and edges that touch, all of a flat contact, and the velocity
//! after a step is the nearest in kinetic energy that does not overlap, exactly. Everything is of first order in the time
//! step, and deterministic on any number of threads.
//!
//! | paper | here |
//! |---|---|
//! | `Eq. ts` (Moreau's time stepping), `Eq. ts3` | [`Rollout::play`], `dynamics::Stepper` |
//! | `Eq. impedancewrench` | `dynamics::Stepper` |
//! | zero level of `Eq. sdfopt` | `axis::separate` |
//! | `P_q^-1` of the start (Sec. ocp:ocp) | [`Rollout::play`] |
//! | `Fig. realworldresults` | [`Success`], [`wilson_interval`], [`offsets`] |

mod axis;
mod bump;
mod contact;
mod dynamics;
mod examiner;
mod grasp;
mod least_distance;
mod metric;
mod motion;
pub mod offsets;
mod parallel;
mod reference;
mod refinement;
mod rollout;
mod settings;
mod solid;
mod success;

pub use bump::Bump;
pub use examiner::{Examiner, Trial, Verdict};
pub use grasp::Grasp;
pub use parallel::in_parallel;
pub use reference::{Knot, Reference};
pub use refinement::Refinement;
pub use rollout::{Moment, Outcome, Rollout};
pub use settings::Settings;
pub use success::{Success, wilson_interval};

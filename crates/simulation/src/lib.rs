//! Rollouts of a plan under injected offsets with hard contacts, and success statistics.
//!
//! A plan is converged when Ipopt says so; it is good when a body that tracks it under the impedance law, with offsets
//! that were not planned for, ends at the goal. The body is that of the plan: constant inertia, no gravity, no gyroscopic
//! term. Contacts are neither smoothed nor relaxed, and nothing of the planner's collision kernel is used, so that a
//! mistake there shows here: contact points come from the facets and edges that touch, all of a flat contact, and the
//! velocity after a step is the nearest in kinetic energy that does not overlap, exactly.
//!
//! | paper | here |
//! |---|---|
//! | `Eq. ts` (Moreau's time stepping), `Eq. ts3` | [`Rollout::play`], `dynamics::Stepper` |
//! | `Eq. impedancewrench` | `dynamics::Stepper` |
//! | zero level of `Eq. sdfopt` | `axis::separate` |
//! | `P_q^-1` of the start (Sec. ocp:ocp) | [`Rollout::play`] |
//! | Anitescu's friction (future work) | [`Settings::friction`] |
//! | `Fig. realworldresults` | [`Success`], [`wilson_interval`], [`offsets`] |

mod axis;
mod contact;
mod dynamics;
mod least_distance;
mod metric;
pub mod offsets;
mod reference;
mod rollout;
mod settings;
mod solid;
mod success;

pub use reference::{Knot, Reference};
pub use rollout::{Moment, Outcome, Rollout};
pub use settings::Settings;
pub use success::{Success, wilson_interval};

//! A direct solver for the symmetric indefinite KKT matrices of optimal control problems.
//! C. Dietz et al., *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order
//! Derivatives* (Section VI-A of the preprint), solve these systems with MA27; this solver exploits their structure.
//!
//! A *stage* is a time step. Rows are coupled with those of their own and the neighbouring stages only. Every row
//! carries a [`Label`]: stage, trajectory, kind. [`StageSolver`] plans the elimination once and repeats it for every
//! matrix:
//!
//! 1. It eliminates contact forces, slacks and their multipliers, each pair by itself (`leaf`).
//! 2. It goes through the stages backward in time (`fronts`). In each it eliminates the poses with the kinematics that
//!    define them, without pivoting (`front::poses`), then factorises the rest as one dense front with Bunch-Kaufman
//!    pivots (`front::general`). The Schur complement is added to the stage before.
//!
//! The number of negative eigenvalues is exact: every pivot is compared with the terms that it is the sum of (`pivot`).
//! A general sparse solver takes over (`fallback`) where a sign is uncertain, where a residual stays large after
//! refinement, where Ipopt requests more accuracy, and where the pattern does not match the labels. The [`Report`]
//! counts these cases. A surplus of negative pivots ends a factorisation early.
//!
//! The time is linear in the numbers of stages and pairs and cubic in the number of scenarios.

mod error;
mod fallback;
mod front;
mod fronts;
mod grouping;
mod kernel;
mod label;
mod leaf;
mod matrix;
mod pivot;
mod report;
mod solver;
mod stages;
mod symbolic;

pub use error::StructureError;
pub use label::{Class, Label, Owner};
pub use report::{FallbackReason, Fallbacks, Report};
pub use solver::{Factorisation, StageSolver};

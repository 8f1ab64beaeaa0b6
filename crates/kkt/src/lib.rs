//! A solver for the symmetric indefinite matrices of optimal control (Sec. ocp:sparseimpl): it knows what every row is.
//!
//! An interior point method for a problem of many stages solves systems whose rows are coupled with their own and the
//! neighbouring stages only. Every row carries a [`Label`]: stage, scenario, kind. [`StageSolver`] plans the
//! elimination once and repeats it for every matrix:
//!
//! 1. contact forces, slacks and their multipliers, each pair by itself (`leaf`);
//! 2. stage by stage, backward in time: poses with the kinematics that define them, without pivoting
//!    (`front::poses`), then the rest of the stage as one dense front with Bunch and Kaufman's pivots (`front::general`),
//!    whose Schur complement goes to the stage before (`stages`).
//!
//! The number of negative eigenvalues is exact: every pivot's size is compared with the terms that it is the sum of
//! (`pivot`), and where its sign cannot be trusted, where a residual stays large after refinement, where more quality is
//! asked for, or where the pattern does not fit its labels, a general sparse solver takes over (`fallback`). The
//! [`Report`] counts these cases. A surplus of negative pivots ends a factorisation early.
//!
//! Time grows linearly in stages and pairs, and with the third power of the number of scenarios.

mod error;
mod fallback;
mod front;
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

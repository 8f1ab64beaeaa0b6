//! Robust contact-implicit optimal control: one reference trajectory for many offsets.
//!
//! A [`task::AssemblyTask`] is transcribed into a sparse nonlinear program ([`Transcription`]), whose smoothing a
//! [`Homotopy`] reduces from one homotopy step to the next; each ends in a [`task::Trajectory`].
//!
//! # Terms
//!
//! The constraints are a sum of terms ([`StepTerm`]): kinematics, dynamics, limits, contact. A term declares the
//! variables and rows that it adds to a stage ([`Block`]) and records its equations as a tape, which is evaluated at
//! all stages and scenarios at once. Indices, bounds, derivatives and the labels for the linear solver follow from
//! that. A term may add to the rows of another one. To add a term, write its file and add it to [`standard_terms`]; a
//! caller can also pass terms to [`Transcription::with_terms`].
//!
//! Distances stay off the tapes: a tape takes components of the contact information `W = (Phi_tau, n~_tau)` as inputs.
//! The adjoints of these inputs, summed over all terms, are the seed `s` with which the collision kernel returns
//! `<s, D2W>`.
//!
//! # Source
//!
//! C. Dietz et al., *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order
//! Derivatives*. Numbers are those of the preprint, labels those of its LaTeX source; comments in this crate cite
//! labels.
//!
//! | number | label | content | here |
//! |---|---|---|---|
//! | (17a) | `Eq. ts1` | `q+ = q + dt Q(q+) v+` | [`POSE_DYNAMICS`] |
//! | (17b) | `Eq. ts` | `v+ = v + dt M^-1 (U + sum n~ lambda_n+)` | [`VELOCITY_DYNAMICS`] |
//! | (17c) | `Eq. ts3` | `0 <= Phi + dt n~' v+  perp  lambda_n+ >= 0` | [`GAP`], [`PRODUCT`] |
//! | Section IV-B | `Sec. diffphys:dsctime` | Scholtes' relaxation and smoothing | [`task::Complementarity`] |
//! | (18) | `Eq. impedancewrench` | wrench of the impedance controller | [`task::Impedance::wrench`] |
//! | (19) | `Eq. discretizedOCP` | the optimal control problem | [`Transcription`] |
//! | Section V-B | `Sec. ocp:ocp` | `P_q^-1`, the start pose of a scenario | [`task::GraspError::actual`] |
//! | Section V-C | `Sec. ocp:cost` | running and terminal cost | `cost` |
//! | Section V-D | `Sec. ocp:homotopy` | homotopy | [`Homotopy`], [`task::HomotopySettings::schedule`] |
//!
//! [`Transcription::residuals`] says how far every constraint is from what it must be at a point, and what it is
//! ([`Member`]): that is where failures are explained from.
//!
//! Limits of velocities, accelerations, forces and wrenches ([`task::Limits`]) are an addition.

mod active_contacts;
mod block;
mod coarse_pieces;
mod cost;
mod distances;
mod formulation;
mod function;
mod grid;
mod homotopy;
mod homotopy_step;
mod layout;
mod least_squares;
mod merging;
mod pattern;
mod point;
mod residuals;
mod stage_solver;
mod stagnation;
mod term;
mod term_function;
mod terms;
mod transcription;

pub use active_contacts::ActiveContacts;
pub use block::{Block, Blocks, Owners, POSE_VARIABLES, TWIST_VARIABLES};
pub use distances::MissingDistance;
pub use formulation::Formulation;
pub use grid::coarsened;
pub use homotopy::{Event, Homotopy, IterationEnd, check_settings};
pub use homotopy_step::{HomotopyStep, IterationTiming};
pub use layout::{CONTACT, CONTACT_AND_POINT, Layout, Member};
pub use point::{Point, Points};
pub use residuals::{Activity, ConstraintIndex, Residual};
pub use stage_solver::TranscriptionSolver;
pub use term::{Source, StepTerm, blocks};
pub use terms::{
    ACCELERATION, CONTACT_FORCE, GAP, POSE_DYNAMICS, PRODUCT, REFERENCE_KINEMATICS, VELOCITY_DYNAMICS, WRENCH,
    standard_terms,
};
pub use transcription::Transcription;

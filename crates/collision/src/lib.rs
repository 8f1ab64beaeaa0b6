//! Smoothed signed distances and contact normals of convex polytopes, with exact first and second derivatives.
//!
//! The distance of two polytopes is the growth by which both must be enlarged to touch, a linear program in a point and
//! the growth. Solved only to the point `tau` of its central path, it is smooth in the pose. The kernel solves it for
//! several poses at once, one per vector lane, and differentiates the solution by the implicit function theorem. The
//! instruction set (AVX-512, AVX2, none) is chosen at run time and does not change a bit of the results.
//!
//! Derivatives are those of the contact information `W(q) = (Phi_tau, Q' n_tau)` in R^7, as functions of the raw pose
//! through its normalised quaternion: what the dynamics need, free of the choice of how a rotation matrix extends to
//! quaternions that are not of unit norm.
//!
//! | paper | here |
//! |---|---|
//! | `assumption_1` | [`Polytope`] |
//! | `Eq. sdfopt` | [`Pair::exact_distance`] |
//! | `Eq. KKTsystem` | `interior_point::solve` |
//! | `Eq. smoothdistfunc`, `Eq. contactvectordef` | [`Pair::distance`] |
//! | `Eq. contactinformation` | [`Pair::contacts`] |
//! | `Eq. firstderw`, `Eq. firstderF` | [`Pair::contact_jacobians`], `derivatives::first` |
//! | `Eq. secondderw`, `Eq. secondderadjeq`, `Eq. secondderfF` | [`Pair::contact_hessians`], `derivatives::second` |
//!
//! The random rescaling of Sec. colldet:rescaling is not needed: the interior-point method does not jam, and what fails
//! would be solved once more in the frame of the contact.

// Loops over the indices of small matrices read like the formulas they stand for.
#![allow(clippy::needless_range_loop)]

mod batch;
mod contact;
mod derivatives;
mod error;
mod frame;
mod hull;
mod interior;
mod interior_point;
mod lane;
mod newton;
mod pair;
mod polytope;
mod rows;
mod triangulation;

pub use batch::{Instructions, Request};
pub use error::DistanceError;
pub use pair::{Distance, Pair};
pub use polytope::{Polytope, PolytopeError};

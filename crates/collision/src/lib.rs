//! Smoothed signed distances and contact normals of convex polytopes, with exact first and second derivatives.
//!
//! The signed distance of two polytopes is twice the growth `alpha` by which both must be enlarged, or shrunk, to
//! touch: a linear program in `z = (p, alpha)`, a common point and the growth. Solved only to the point `tau` of its
//! central path, the distance is smooth in the pose. The kernel solves several poses at once, one per vector lane, and
//! differentiates the solution by the implicit function theorem. The instruction set (AVX-512, AVX2, none) is chosen at
//! run time and does not change a bit of the results.
//!
//! Derivatives are those of the contact information `W(q) = (Phi_tau, Q' n_tau)` in R^7, as a function of the raw pose
//! through its normalised quaternion. The dynamics need just this, and it does not depend on how a rotation matrix is
//! extended to quaternions that are not of unit norm. Friction also needs the contact point `p`, where the grown parts
//! meet: then `W(q) = (Phi_tau, Q' n_tau, p)` in R^10. For faces that touch, it is an analytic centre of the patch.
//!
//! The paper is *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives*
//! by Dietz et al., numbers as in the preprint:
//!
//! | paper | label | formula | here |
//! |---|---|---|---|
//! | Assumption 1 | `assumption_1` | bounded, unit rows, `h > 0` | [`Polytope`] |
//! | Eq. (1) | `Eq. sdfopt` | `Phi_0 = min 2 alpha` with `A z <= b` | [`Pair::exact_distance`] |
//! | Eq. (2) | `Eq. KKTsystem` | `c + A' dual = 0`, `dual slack = tau` in every row | `interior_point::solve` |
//! | Eq. (4) | `Eq. smoothdistfunc` | `Phi_tau = 2 alpha_tau`; the paper omits the 2 | [`Pair::distance`] |
//! | Eq. (6) | `Eq. contactvectordef` | `n_tau = (d_q g)' dual` with `g = A z - b` | [`Pair::distance`] |
//! | Eq. (7) | `Eq. barrierprob` | `n_tau = grad_q min_z B_tau(z, q)` | `derivatives` |
//! | Eq. (8) | `Eq. contactinformation` | `W = (Phi_tau, Q' n_tau)` | [`Pair::contacts`] |
//! | Eq. (9), (10) | `Eq. firstderw`, `Eq. firstderF` | `d_gamma F D gamma = -d_q F` | [`Pair::contact_jacobians`], `derivatives::first` |
//! | Eq. (11) to (13) | `Eq. secondderw`, `Eq. secondderadjeq`, `Eq. secondderfF` | `(d_gamma F)' r = -s_gamma` | [`Pair::contact_hessians`], `derivatives::second` |
//!
//! The random rescaling of the paper (Sec. III-D, `Sec. colldet:rescaling`) is not needed: the interior-point method
//! does not jam, and a problem that fails is solved again in its contact frame.

// Loops over the indices of small matrices read like the formulas.
#![allow(clippy::needless_range_loop)]

mod batch;
mod derivatives;
mod error;
mod facet;
mod frame;
mod hull;
mod interior;
mod interior_point;
mod lane;
mod measures;
mod newton;
mod pair;
mod polytope;
mod pose_chart;
mod rows;
mod solutions;
mod triangulation;

pub use batch::{Instructions, Request};
pub use error::DistanceError;
pub use pair::{Distance, Pair};
pub use polytope::{Polytope, PolytopeError};
pub use solutions::Solutions;

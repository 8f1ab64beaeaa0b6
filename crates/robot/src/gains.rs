//! Gains with which an arm executes a plan.
//!
//! **Dynamic similarity.** A plan obeys `M dv/dt = K e + D de/dt + f` with the inertia `M`, stiffness `K` and damping `D`
//! that it was made with and contact forces `f`. Times a factor `s` this reads
//! `(s M) dv/dt = (s K) e + (s D) de/dt + (s f)`: the same motion with forces times `s`, since hard contacts and Coulomb
//! friction allow any multiple of forces that they allow. So an arm that seems to have the inertia `s M` executes the plan
//! with the gains `s K` and `s D`.
//!
//! **Joint friction** holds the arm wherever `|J' K e| <= friction` in every joint. [`FrictionWrench`] is the largest
//! `K e` of this set, which divided by the stiffness is the deadband: errors that the controller cannot remove. Stiffness
//! makes it smaller and contact forces larger.
//!
//! **Choice.** A [`Demand`] on translations or rotations says how stiff an arm may and has to be;
//! [`Demand::stiffness`] stays as close to similarity as it allows.

mod friction;
mod stiffness;

pub use friction::{Deadband, FrictionWrench};
pub use stiffness::{Demand, Refusal};

//! Gains with which an arm executes a plan.
//!
//! **Dynamic similarity.** A plan obeys `M dv/dt = K e + D de/dt + f` with the inertia `M`, stiffness `K` and damping `D`
//! that it was made with and contact forces `f`. Times a factor `s` this reads
//! `(s M) dv/dt = (s K) e + (s D) de/dt + (s f)`: the same motion with forces times `s`, since hard contacts and Coulomb
//! friction allow any multiple of forces that they allow. So an arm that seems to have the inertia `s M` executes the plan
//! with the gains `s K` and `s D`. [`Similarity`] finds `s`.
//!
//! **Joint friction** holds the arm wherever `|J' K e| <= friction` in every joint. [`FrictionWrench`] is the largest
//! `K e` of this set, which divided by the stiffness is the deadband: errors that the controller cannot remove. Stiffness
//! makes it smaller and contact forces larger.
//!
//! **One factor.** [`execution_factor`] stays as close to similarity as [`Demand`]s on translation and rotation allow, with
//! one factor for all gains, so that translation and rotation keep their proportion.

mod friction;
mod similarity;
mod stiffness;

pub use friction::{Deadband, FrictionWrench};
pub use similarity::Similarity;
pub use stiffness::{Demand, Refusal, execution_factor};

//! Which errors a plan tolerates.
//!
//! [`Trials`] are rollouts of one plan with random errors. [`boundary()`] finds the largest value of one [`Quantity`] at which
//! a fraction of them succeeds, [`map()`] how that depends on another quantity, [`answer()`] both. [`clearance::widened`] changes the clearance of
//! a scene, [`Fit`] is a clearance by the name of an ISO 286 fit.

mod answer;
mod boundary;
pub mod clearance;
mod conditions;
mod fit;
mod map;
mod quantity;
mod record;
mod svg;
mod trials;

pub use answer::{Question, answer};
pub use boundary::{Boundary, boundary};
pub use conditions::Conditions;
pub use fit::{Fit, FitError};
pub use map::{MapQuestion, ToleranceMap, ToleranceMapRow, map};
pub use quantity::Quantity;
pub use record::{NeedRecord, TOLERANCE, ToleranceRecord};
pub use svg::svg;
pub use trials::{ToleranceRequest, Trials};

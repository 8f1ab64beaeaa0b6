//! Which errors a plan tolerates.
//!
//! [`Trials`] are rollouts of one plan with random errors. [`boundary()`] finds the largest value of one [`Quantity`] at which
//! a fraction of them succeeds, [`map()`] how that depends on another quantity. [`clearance::widened`] changes the clearance of
//! a scene, [`Fit`] is a clearance by the name of an ISO 286 fit.

mod boundary;
pub mod clearance;
mod conditions;
mod fit;
mod map;
mod quantity;
mod svg;
mod trials;

pub use boundary::{Boundary, boundary};
pub use conditions::Conditions;
pub use fit::{Fit, FitError};
pub use map::{ToleranceMap, ToleranceMapRow, map, rows_around};
pub use quantity::Quantity;
pub use svg::svg;
pub use trials::{ToleranceRequest, Trials};

//! Which errors a plan tolerates.
//!
//! [`Trials`] are rollouts of one plan with random errors. [`boundary()`] finds the largest value of one [`Quantity`] at which
//! a fraction of them succeeds, [`answer()`] that of several ones and how it depends on another quantity; [`Work`] keeps what is
//! finished of it. [`clearance::widened`] changes the clearance of a scene, [`chamfer::chamfered`] the mouth of its
//! hole; [`Fit`] is a clearance by the name of an ISO 286 fit.

mod answer;
mod boundary;
pub mod chamfer;
pub mod clearance;
mod conditions;
mod fit;
mod map;
mod mouth;
mod quantity;
mod record;
mod sensitivity;
mod svg;
mod trials;
mod work;

pub use answer::{Need, Question, ReferenceAt, answer, answer_one};
pub use boundary::{Boundary, boundary};
pub use conditions::Conditions;
pub use fit::{Fit, FitError};
pub use map::{MapQuestion, ToleranceMap, ToleranceMapRow};
pub use mouth::Mouth;
pub use quantity::Quantity;
pub use record::{NeedRecord, TOLERANCE, ToleranceRecord};
pub use sensitivity::Sensitivity;
pub use svg::svg;
pub use trials::{ToleranceRequest, Trials};
pub use work::{Keep, ResumeError, Work};

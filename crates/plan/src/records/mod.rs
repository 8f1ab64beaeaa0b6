//! Records of motions and errors in files: types with the units in the names of their fields.

mod admittance;
mod attempt;
mod grasp;
mod impedance;
mod loss;
mod motion;
mod motion_end;

pub use admittance::AdmittanceRecord;
pub use attempt::AttemptRecord;
pub use grasp::GraspRecord;
pub use impedance::ImpedanceRecord;
pub use loss::LossRecord;
pub use motion::{Extreme, MotionRecord};
pub use motion_end::{HoldRecord, MotionEnd};

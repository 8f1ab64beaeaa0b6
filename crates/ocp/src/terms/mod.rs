//! The terms of the transcription.

mod contacts;
mod dynamics;
mod friction;
mod limits;

pub use contacts::{CONTACT_FORCE, GAP, PRODUCT};
pub(crate) use dynamics::initial_states;
pub use dynamics::{POSE_DYNAMICS, REFERENCE_KINEMATICS, VELOCITY_DYNAMICS};
pub use limits::{ACCELERATION, WRENCH};

use task::{AssemblyTask, Complementarity};

use crate::term::StepTerm;
use contacts::Contacts;
use dynamics::{CompliantDynamics, ReferenceKinematics};
use friction::Friction;
use limits::{AccelerationLimits, WrenchLimits};

/// The terms of a task. Every term has a file and a line here. The order is that of their blocks and of accumulation.
pub fn standard_terms(task: &AssemblyTask, complementarity: Complementarity) -> Vec<Box<dyn StepTerm>> {
    let mut terms: Vec<Box<dyn StepTerm>> = vec![
        Box::new(ReferenceKinematics::new(task)),
        Box::new(CompliantDynamics::new(task)),
        Box::new(AccelerationLimits::new(task)),
        Box::new(WrenchLimits::new(task)),
        Box::new(Contacts::new(task, complementarity)),
    ];
    if task.frictions.iter().any(|&friction| friction > 0.0) {
        terms.push(Box::new(Friction::new(task)));
    }
    terms
}

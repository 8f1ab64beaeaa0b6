//! The simulated plant.

use nalgebra::Isometry3;
use task::Wrench;

use crate::admittance_dynamics::AdmittanceStepper;
use crate::arm_dynamics::ArmStepper;
use crate::body::Body;
use crate::contact::ContactFinder;
use crate::dynamics::Stepper;
use crate::reference::Knot;
use crate::step_length::Substeps;

/// A free body, or an arm or a robot that is commanded by position that holds one.
#[derive(Debug, Clone)]
pub enum Plant<'arm> {
    Body(Box<Stepper>),
    Arm(Box<ArmStepper<'arm>>),
    Admittance(Box<AdmittanceStepper>),
}

impl Plant<'_> {
    /// Moves the body by one step; as [`Stepper::step`].
    pub fn step(
        &mut self,
        body: &mut Body,
        substeps: Substeps,
        target: impl Fn(f64) -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> (usize, f64) {
        match self {
            Self::Body(stepper) => stepper.step(body, substeps, target, finder, impulses),
            Self::Arm(stepper) => stepper.step(body, substeps, target, finder, impulses),
            Self::Admittance(stepper) => stepper.step(body, substeps, target, finder, impulses),
        }
    }

    /// The flange of a robot that is commanded by position or force.
    pub fn flange(&self) -> Option<&Isometry3<f64>> {
        match self {
            Self::Body(_) | Self::Arm(_) => None,
            Self::Admittance(stepper) => Some(stepper.flange()),
        }
    }

    /// Wrench on the body, where it is not that of the impedance law.
    pub fn wrench(&self) -> Option<Wrench> {
        match self {
            Self::Body(_) | Self::Arm(_) => None,
            Self::Admittance(stepper) => Some(*stepper.wrench()),
        }
    }
}

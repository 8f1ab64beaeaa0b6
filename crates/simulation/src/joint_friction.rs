//! Dry friction of joints.

use robot::{JointMatrix, JointVector};

/// Coulomb friction: in a step, each joint gets an impulse up to its largest one, which stops it or, if that is not
/// enough, brakes it. A joint at rest sticks. These are the impulses that leave the least of kinetic energy and friction
/// work, found by projected Gauss-Seidel sweeps from those of the step before.
#[derive(Debug, Clone)]
pub struct JointFriction {
    /// Largest torque of each joint (Nm or N).
    largest: JointVector,
    /// Mean torque of each joint in a step (Nm or N).
    torques: JointVector,
    joints: usize,
}

/// Sweeps end when no joint's torque changes by more than this part of its largest one. At rest, sweeps of later steps
/// remove the rest.
const TOLERANCE: f64 = 1e-4;
/// Mobility (1/(kg m^2) or 1/kg) of a joint that contacts hold.
const HELD: f64 = 1e-9;
/// Largest number of sweeps in a step. The rest is small, and the next step continues from there.
const SWEEPS: usize = 50;

impl JointFriction {
    /// For the friction torque of each joint (Nm or N).
    pub fn new(torques: impl ExactSizeIterator<Item = f64>) -> Self {
        let joints = torques.len();
        let mut largest = JointVector::zeros();
        largest.iter_mut().zip(torques).for_each(|(largest, torque)| *largest = torque);
        Self { largest, torques: JointVector::zeros(), joints }
    }

    /// Whether there is any.
    pub fn is_zero(&self) -> bool {
        self.largest == JointVector::zeros()
    }

    /// The impulses (Nms or Ns) in a step (s).
    pub fn impulses(&self, time_step: f64) -> JointVector {
        self.torques * time_step
    }

    /// Updates the impulses in a step (s) for the joint speeds `velocity` (rad/s or m/s), which contain those so far,
    /// and the speeds with them. `mobility` is the inverse of the mass matrix, or what contacts leave of it. Returns
    /// whether they had to change.
    pub fn brake(&mut self, mobility: &JointMatrix, velocity: &mut JointVector, time_step: f64) -> bool {
        // What stops a joint per speed; nothing stops one that is held.
        let stopping = mobility.diagonal().map(|own| if own < HELD { 0.0 } else { 1.0 / (own * time_step) });
        for sweep in 0..SWEEPS {
            let mut is_done = true;
            for joint in 0..self.joints {
                let (before, largest) = (self.torques[joint], self.largest[joint]);
                let stopping = before - velocity[joint] * stopping[joint];
                let torque = stopping.max(-largest).min(largest);
                let change = torque - before;
                is_done &= change.abs() <= TOLERANCE * largest;
                self.torques[joint] = torque;
                velocity.axpy(change * time_step, &mobility.column(joint), 1.0);
            }
            if is_done {
                return sweep > 0;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use robot::MOST_JOINTS;

    use super::*;

    proptest! {
        /// Coulomb's law: a moving joint is braked by all of its friction, a resting one by less.
        #[test]
        fn impulses_are_those_of_coulomb(
            entries in proptest::collection::vec(-1.0..1.0_f64, MOST_JOINTS * MOST_JOINTS),
            free in proptest::collection::vec(-1.0..1.0_f64, MOST_JOINTS),
            torques in proptest::collection::vec(0.0..300.0_f64, MOST_JOINTS),
        ) {
            let factor = JointMatrix::from_column_slice(&entries);
            let mobility = factor * factor.transpose() + JointMatrix::identity() * 0.5;
            let free = JointVector::from_column_slice(&free);
            let mut friction = JointFriction::new(torques.iter().copied());
            let mut velocity = free;
            for _ in 0..1000 {
                friction.brake(&mobility, &mut velocity, 1e-3);
            }
            prop_assert!((free + mobility * friction.impulses(1e-3) - velocity).amax() < 1e-12);
            for joint in 0..MOST_JOINTS {
                let (impulse, largest, speed) = (friction.impulses(1e-3)[joint], 1e-3 * torques[joint], velocity[joint]);
                prop_assert!(impulse.abs() <= largest);
                prop_assert!(speed.abs() < 1e-5 || impulse == -largest.copysign(speed), "{impulse} at {speed}");
            }
        }
    }
}

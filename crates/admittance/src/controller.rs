//! The admittance law in discrete time.

use nalgebra::{Isometry3, Vector3};
use task::pose::moved;

use crate::gains::Gains;
use crate::motion::Motion;
use crate::robot::Limits;

/// The law and the pose that it commands.
#[derive(Debug, Clone)]
pub struct Controller {
    gains: Gains,
    limits: Limits,
    period: f64,
    commanded: Motion,
    /// The reference at the sample before.
    before: Isometry3<f64>,
}

impl Controller {
    /// At rest at a pose; `period` in seconds.
    pub fn new(gains: Gains, limits: Limits, period: f64, start: Isometry3<f64>) -> Self {
        Self { gains, limits, period, commanded: Motion::at_rest(start), before: start }
    }

    /// The pose that is commanded.
    pub fn commanded(&self) -> Isometry3<f64> {
        self.commanded.pose
    }

    /// One sample of the law: `M a + D (v - v_r) + K (x - x_r) = F`, implicit in damping and stiffness, with the contact force
    /// (N, world frame) and torque (Nm, body frame) on the part. The reference moved from its pose at the last sample to this one.
    /// Speeds and accelerations stay within the limits.
    pub fn sample(&mut self, reference: &Isometry3<f64>, [force, torque]: [Vector3<f64>; 2]) -> Isometry3<f64> {
        let Self { commanded, period, before, .. } = self;
        let shift = before.translation.vector - commanded.pose.translation.vector;
        let error = commanded.pose.rotation.inverse() * before.rotation;
        let rotation = error.imag() * (2.0 * error.w);
        let velocity_of_reference = (reference.translation.vector - before.translation.vector) / *period;
        let rotated = (before.rotation.inverse() * reference.rotation).scaled_axis() / *period;
        *before = *reference;
        let velocity = self.gains.answer(0, *period, commanded.velocity, velocity_of_reference, shift, force);
        let angular = self.gains.answer(1, *period, commanded.angular_velocity, rotated, rotation, torque);
        let within = |part: usize, before: Vector3<f64>, after: Vector3<f64>| {
            let change = (after - before).cap_magnitude(self.limits.acceleration[part] * *period);
            (before + change).cap_magnitude(self.limits.speed[part])
        };
        commanded.velocity = within(0, commanded.velocity, velocity);
        commanded.angular_velocity = within(1, commanded.angular_velocity, angular);
        commanded.pose =
            moved(&commanded.pose, &(commanded.velocity * *period), &(commanded.angular_velocity * *period));
        commanded.pose
    }
}

impl Gains {
    /// Velocity of translations (0) or rotations (1) a period (s) later.
    fn answer(
        &self,
        part: usize,
        period: f64,
        velocity: Vector3<f64>,
        reference: Vector3<f64>,
        error: Vector3<f64>,
        load: Vector3<f64>,
    ) -> Vector3<f64> {
        let (mass, damping, stiffness) = (self.mass[part], self.damping[part], self.stiffness[part]);
        // The error is that after the period, in which the reference moves too.
        let error = error + reference * period;
        let momentum = velocity * mass + (reference * damping + error * stiffness + load) * period;
        momentum / (mass + damping * period + stiffness * period * period)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAINS: Gains = Gains { mass: [4.0, 0.1], damping: [400.0, 2.0], stiffness: [1000.0, 5.0] };
    const FREE: Limits = Limits { speed: [f64::INFINITY; 2], acceleration: [f64::INFINITY; 2] };

    fn controller(limits: Limits) -> Controller {
        Controller::new(GAINS, limits, 0.002, Isometry3::identity())
    }

    #[test]
    fn it_rests_where_stiffness_balances_the_wrench() {
        let mut controller = controller(FREE);
        let reference = Isometry3::translation(0.01, 0.0, 0.0);
        let wrench = [Vector3::new(0.0, 20.0, 0.0), Vector3::new(0.0, 0.0, 0.5)];
        (0..10_000).for_each(|_| _ = controller.sample(&reference, wrench));
        let Isometry3 { translation, rotation } = controller.commanded();
        assert!((translation.vector - Vector3::new(0.01, 0.02, 0.0)).norm() < 1e-9, "{translation}");
        // 2 sin(angle / 2) cos(angle / 2) K = torque.
        assert!((rotation.scaled_axis() - Vector3::new(0.0, 0.0, 0.1_f64.asin())).norm() < 1e-9);
    }

    #[test]
    fn it_follows_a_moving_reference_without_an_error() {
        let mut controller = controller(FREE);
        let velocity = Vector3::new(0.02, 0.0, 0.0);
        for index in 1..=2000 {
            let position = velocity * (0.002 * f64::from(index));
            controller.sample(&Isometry3::translation(position.x, 0.0, 0.0), [Vector3::zeros(); 2]);
        }
        // It starts late by the time in which its mass follows.
        assert!((controller.commanded().translation.x - 0.08).abs() < 5e-5);
    }

    #[test]
    fn speeds_and_accelerations_are_limited() {
        let limits = Limits { speed: [0.05, 0.1], acceleration: [0.5, 1.0] };
        let mut controller = controller(limits);
        let mut before = controller.commanded;
        for _ in 0..500 {
            controller.sample(&Isometry3::translation(1.0, 1.0, 0.0), [Vector3::zeros(); 2]);
            let after = controller.commanded;
            assert!(after.velocity.norm() <= 0.05 + 1e-12);
            assert!((after.velocity - before.velocity).norm() <= 0.5 * 0.002 + 1e-12);
            before = after;
        }
        assert!((before.velocity.norm() - 0.05).abs() < 1e-9);
    }
}

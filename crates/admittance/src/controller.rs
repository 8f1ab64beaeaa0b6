//! The admittance law in discrete time.

use nalgebra::{Isometry3, Vector3};
use task::pose::moved;

use crate::gains::Gains;
use crate::motion::Motion;
use crate::robot::{Feedback, Limits};

/// The law and the pose that it commands.
#[derive(Debug, Clone)]
pub struct Controller {
    feedback: Feedback,
    gains: Gains,
    limits: Limits,
    period: f64,
    commanded: Motion,
    /// The reference at the sample before.
    before: Isometry3<f64>,
}

impl Controller {
    /// At rest at a pose, which is its reference; `period` in seconds.
    pub fn new(gains: Gains, limits: Limits, period: f64, start: Isometry3<f64>) -> Self {
        let commanded = Motion::at_rest(start);
        Self { feedback: Feedback::Commanded, gains, limits, period, commanded, before: start }
    }

    /// With other feedback than that of commanded poses.
    pub fn with_feedback(self, feedback: Feedback) -> Self {
        Self { feedback, ..self }
    }

    /// At rest beside its reference, which is this one.
    pub fn beside(self, reference: Isometry3<f64>) -> Self {
        Self { before: reference, ..self }
    }

    /// The pose that is commanded.
    pub fn commanded(&self) -> Isometry3<f64> {
        self.commanded.pose
    }

    /// One sample of the law, with the contact force (N, world frame) and torque (Nm, body frame) on the part, and the motion of
    /// the robot as it is measured. Returns the pose that is commanded from now on.
    pub fn sample(&mut self, reference: &Motion, measured: &Motion, load: [Vector3<f64>; 2]) -> Isometry3<f64> {
        match self.feedback {
            Feedback::Commanded => self.follow(&reference.pose, load),
            Feedback::MeasuredPose => self.deviate(&reference.pose, &measured.pose, load),
            Feedback::ForceMode { damping } => self.apply(reference, &measured.pose, damping, load),
        }
        self.before = reference.pose;
        self.commanded.pose
    }

    /// `M a + D (v - v_r) + K (x - x_r) = F`, implicit in damping and stiffness. The reference moved from its pose at the last
    /// sample to this one. Speeds and accelerations stay within the limits.
    fn follow(&mut self, reference: &Isometry3<f64>, [force, torque]: [Vector3<f64>; 2]) {
        let Self { commanded, period, before, .. } = self;
        let shift = before.translation.vector - commanded.pose.translation.vector;
        let error = commanded.pose.rotation.inverse() * before.rotation;
        let rotation = error.imag() * (2.0 * error.w);
        let velocity_of_reference = (reference.translation.vector - before.translation.vector) / *period;
        let rotated = (before.rotation.inverse() * reference.rotation).scaled_axis() / *period;
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
    }

    /// `M u' + D u + K (x_m - x_r) = F` for the rate `u` at which the commanded pose deviates from the reference, under the
    /// measured pose `x_m`; explicit, as that controller is. The velocity of the command is here `u`.
    fn deviate(&mut self, reference: &Isometry3<f64>, measured: &Isometry3<f64>, load: [Vector3<f64>; 2]) {
        let Self { gains, commanded, period, before, .. } = self;
        let pull = gains.springs(reference, measured);
        let rate = |part: usize, before: Vector3<f64>| {
            before + (pull[part] + load[part] - before * gains.damping[part]) * (*period / gains.mass[part])
        };
        commanded.velocity = rate(0, commanded.velocity);
        commanded.angular_velocity = rate(1, commanded.angular_velocity);
        let carried = Isometry3::from_parts(
            (reference.translation.vector + commanded.pose.translation.vector - before.translation.vector).into(),
            commanded.pose.rotation * before.rotation.inverse() * reference.rotation,
        );
        commanded.pose = moved(&carried, &(commanded.velocity * *period), &(commanded.angular_velocity * *period));
    }

    /// `M a + D v = K (x_r - x_m) + D_w v_r + F`: a force mode of damping `D` that is commanded the spring of an impedance law,
    /// and the force that moves it with the reference by the damping `D_w` of that law. Speeds stay within the limits.
    fn apply(&mut self, reference: &Motion, measured: &Isometry3<f64>, damping: [f64; 2], load: [Vector3<f64>; 2]) {
        let Self { gains, limits, commanded, period, .. } = self;
        let [force, torque] = gains.springs(&reference.pose, measured);
        let force = force + reference.velocity * damping[0];
        let torque = torque + reference.angular_velocity * damping[1];
        let velocity = gains.braked(0, *period, commanded.velocity, force + load[0]);
        let angular_velocity = gains.braked(1, *period, commanded.angular_velocity, torque + load[1]);
        commanded.velocity = velocity.cap_magnitude(limits.speed[0]);
        commanded.angular_velocity = angular_velocity.cap_magnitude(limits.speed[1]);
        commanded.pose =
            moved(&commanded.pose, &(commanded.velocity * *period), &(commanded.angular_velocity * *period));
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

    /// Velocity of translations (0) or rotations (1) a period (s) later, under a force that damping brakes.
    fn braked(&self, part: usize, period: f64, velocity: Vector3<f64>, load: Vector3<f64>) -> Vector3<f64> {
        (velocity * self.mass[part] + load * period) / (self.mass[part] + self.damping[part] * period)
    }

    /// Force (N, world frame) and torque (Nm, body frame) of the springs between a reference and a pose.
    fn springs(&self, reference: &Isometry3<f64>, pose: &Isometry3<f64>) -> [Vector3<f64>; 2] {
        let shift = reference.translation.vector - pose.translation.vector;
        let turn = pose.rotation.inverse() * reference.rotation;
        [shift * self.stiffness[0], turn.imag() * (2.0 * turn.w * self.stiffness[1])]
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

    /// A sample with a robot that goes at once where it is told.
    fn sample(controller: &mut Controller, reference: &Isometry3<f64>, load: [Vector3<f64>; 2]) {
        let measured = controller.commanded;
        controller.sample(&Motion::at_rest(*reference), &measured, load);
    }

    #[test]
    fn it_rests_where_stiffness_balances_the_wrench() {
        let reference = Isometry3::translation(0.01, 0.0, 0.0);
        let wrench = [Vector3::new(0.0, 20.0, 0.0), Vector3::new(0.0, 0.0, 0.5)];
        for feedback in [Feedback::Commanded, Feedback::MeasuredPose, Feedback::ForceMode { damping: [300.0, 3.0] }] {
            let mut controller = controller(FREE).with_feedback(feedback);
            (0..10_000).for_each(|_| sample(&mut controller, &reference, wrench));
            let Isometry3 { translation, rotation } = controller.commanded();
            assert!((translation.vector - Vector3::new(0.01, 0.02, 0.0)).norm() < 1e-9, "{feedback:?} {translation}");
            // 2 sin(angle / 2) cos(angle / 2) K = torque.
            assert!((rotation.scaled_axis() - Vector3::new(0.0, 0.0, 0.1_f64.asin())).norm() < 1e-9, "{feedback:?}");
        }
    }

    #[test]
    fn a_deviation_is_added_to_the_reference_and_decays_by_the_law() {
        let mut controller = controller(FREE).with_feedback(Feedback::MeasuredPose).beside(Isometry3::identity());
        controller.commanded = Motion::at_rest(Isometry3::translation(0.0, 0.001, 0.0));
        for index in 1..=400 {
            let at = Isometry3::translation(1e-5 * f64::from(index), 0.0, 0.0);
            sample(&mut controller, &at, [Vector3::zeros(); 2]);
            let deviation = controller.commanded().translation.vector - at.translation.vector;
            // The slow root of M s^2 + D s + K, for which the fast one has made way.
            let expected = 0.001 * 1.027 * (-2.566 * 0.002 * f64::from(index)).exp();
            // Along x, the measured pose is a period late.
            assert!(
                deviation.x.abs() < 2e-5 && (index < 50 || (deviation.y / expected - 1.0).abs() < 0.03),
                "{deviation}"
            );
        }
    }

    #[test]
    fn a_force_mode_with_the_damping_of_its_law_follows_at_the_speed_of_its_reference() {
        let feedback = Feedback::ForceMode { damping: GAINS.damping };
        let mut controller = controller(FREE).with_feedback(feedback);
        let velocity = Vector3::new(0.02, 0.0, 0.0);
        for index in 1..=25 {
            let pose = Isometry3::translation(velocity.x * 0.002 * f64::from(index), 0.0, 0.0);
            let measured = controller.commanded;
            let reference = Motion { velocity, ..Motion::at_rest(pose) };
            controller.sample(&reference, &measured, [Vector3::zeros(); 2]);
        }
        assert!((controller.commanded.velocity.x - 0.02).abs() < 2e-3, "{:?}", controller.commanded);
    }

    #[test]
    fn it_follows_a_moving_reference_without_an_error() {
        let mut controller = controller(FREE);
        let velocity = Vector3::new(0.02, 0.0, 0.0);
        for index in 1..=2000 {
            let position = velocity * (0.002 * f64::from(index));
            sample(&mut controller, &Isometry3::translation(position.x, 0.0, 0.0), [Vector3::zeros(); 2]);
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
            sample(&mut controller, &Isometry3::translation(1.0, 1.0, 0.0), [Vector3::zeros(); 2]);
            let after = controller.commanded;
            assert!(after.velocity.norm() <= 0.05 + 1e-12);
            assert!((after.velocity - before.velocity).norm() <= 0.5 * 0.002 + 1e-12);
            before = after;
        }
        assert!((before.velocity.norm() - 0.05).abs() < 1e-9);
    }
}

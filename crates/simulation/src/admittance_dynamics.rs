//! One time step of a body in the gripper of a robot that is commanded by position or force.

use admittance::{Controller, Measurement, Motion, PositionRobot, Servo};
use nalgebra::{Isometry3, Vector3};
use task::{Impedance, Pose, Wrench};

use crate::body::Body;
use crate::contact::ContactFinder;
use crate::contact_solver::ContactSolver;
use crate::disturbance::Disturbance;
use crate::dynamics::Stepper;
use crate::reference::Knot;
use crate::step_length::{Steps, Substeps};
use crate::timed_state::TimedState;

/// Events that are this much (s) later than a time happen at it: rounding.
const ROUNDING: f64 = 1e-9;

/// Steps of a body that a spring of the contact stiffness, critically damped, holds at the flange. The flange follows commanded
/// poses however hard it is pushed; the sensor measures the wrench of the spring; the law samples it and commands the next
/// pose. Poses of flange and law are those of the believed part, with the rotation of the part.
#[derive(Debug, Clone)]
pub struct AdmittanceStepper {
    body: Stepper,
    spring: Impedance,
    /// Where the controller believes the body's origin (m, body frame).
    offset: Vector3<f64>,
    controller: Controller,
    servo: Servo,
    measurement: Measurement,
    period: f64,
    time_step: f64,
    /// Steps so far, and time (s) of the next sample.
    steps: usize,
    next_sample: f64,
    /// Wrench of the flange on the body after the last step.
    wrench: Wrench,
}

impl AdmittanceStepper {
    /// At rest at the pose of the body, with an offset that the controller does not know (m, body frame). `None` unless the
    /// inertia is positive definite and finite.
    pub fn new(
        robot: &PositionRobot,
        start: &Isometry3<f64>,
        offset: Vector3<f64>,
        disturbance: &Disturbance,
        shortest: &Steps,
        solver: ContactSolver,
    ) -> Option<Self> {
        let inertia = disturbance.inertia(&robot.carried);
        let stiffness = robot.contact_stiffness * (1.0 + disturbance.stiffness);
        let spring = Impedance::critically_damped(stiffness, stiffness * robot.lever * robot.lever, &inertia);
        let believed = Isometry3::from_parts((start * nalgebra::Point3::from(offset)).coords.into(), start.rotation);
        let [force, torque] = [0, 3].map(|first| Vector3::from_fn(|axis, _| disturbance.bias[first + axis]));
        let deadband = robot.force_mode.map_or([0.0; 2], |mode| mode.deadband);
        Some(Self {
            body: Stepper::new(&Steps { most: 1, ..*shortest }, &inertia, &spring, offset, solver)?,
            spring,
            offset,
            controller: Controller::new(robot.gains, robot.limits, robot.period, believed)
                .with_feedback(robot.feedback),
            servo: Servo::new(robot.bandwidth, robot.delay + disturbance.delay, believed),
            measurement: Measurement::new(robot.sensor, [force, torque], deadband),
            period: robot.period,
            time_step: shortest.time_step,
            steps: 0,
            next_sample: 0.0,
            wrench: Wrench::ZERO,
        })
    }

    /// At rest beside its reference, which is this one.
    pub fn beside(self, reference: Isometry3<f64>) -> Self {
        Self { controller: self.controller.beside(reference), ..self }
    }

    /// Moves the body by one of the shortest steps; otherwise as [`Stepper::step`].
    pub fn step(
        &mut self,
        body: &mut Body,
        substeps: Substeps,
        target: impl Fn(f64) -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> (usize, f64) {
        let (time, step) = (self.steps as f64 * self.time_step, self.time_step);
        if self.next_sample <= time + ROUNDING {
            self.next_sample += self.period;
            let reference = Motion::from(target(substeps.done as f64));
            let command = self.controller.sample(&reference, self.servo.motion(), self.measurement.sample());
            self.servo.send(time, command);
        }
        self.servo.advance(time, step);
        let flange = *self.servo.motion();
        let once = Substeps { done: 0, count: 1 };
        let (_, penetration) = self.body.step(body, once, |_| flange.into(), finder, impulses);
        let measured = self.measure(body, &flange);
        self.measurement.filter(measured, step);
        self.steps += 1;
        (1, penetration)
    }

    /// The pose of the flange: the position of the believed part, and the rotation that the part has where it is believed.
    pub fn flange(&self) -> &Isometry3<f64> {
        &self.servo.motion().pose
    }

    /// Wrench of the flange on the body after the last step: force (N, world frame) and torque (Nm, body frame).
    pub fn wrench(&self) -> &Wrench {
        &self.wrench
    }

    /// Contact force (N, world frame) and torque (Nm, body frame) about the believed origin that the spring passes on.
    fn measure(&mut self, body: &Body, flange: &Motion) -> [Vector3<f64>; 2] {
        let held = Pose::new(self.offset.into(), [1.0, 0.0, 0.0, 0.0]);
        let reference = Knot::from(*flange).state();
        self.wrench = self.spring.wrench(&reference, &TimedState::new(0.0, body).state(), &held);
        let [force, torque] = [0, 3].map(|first| -Vector3::from_fn(|axis, _| self.wrench[first + axis]));
        [force, torque - self.offset.cross(&(body.pose.rotation.inverse() * force))]
    }
}

impl From<Knot> for Motion {
    fn from(Knot { pose, velocity, angular_velocity }: Knot) -> Self {
        Self { pose, velocity, angular_velocity }
    }
}

impl From<Motion> for Knot {
    fn from(Motion { pose, velocity, angular_velocity }: Motion) -> Self {
        Self { pose, velocity, angular_velocity }
    }
}

//! One time step of an arm that holds the body: control at samples, joint friction, contacts, motion.

use nalgebra::{Isometry3, Vector3};
use robot::{Arm, JointVector};
use task::{GraspError, Impedance};

use crate::arm_model::ArmModel;
use crate::arm_posture::ArmPosture;
use crate::body::{Body, moved};
use crate::contact::{Contact, ContactFinder};
use crate::contact_solver::ContactSolver;
use crate::disturbance::Disturbance;
use crate::joint_friction::JointFriction;
use crate::least_distance::Vector6;
use crate::reference::{Knot, coordinates};
use crate::sampled_controller::SampledController;

/// Steps of an arm, semi-implicit Euler in joint space: `M (v+ - v) = h (torques - bias) + friction + J' contacts` with
/// joint speeds `v` and impulses of joint friction and contacts, then positions move with `v+`. As torques hold between
/// samples, the controller is explicit and may be unstable, as it would be on the arm.
///
/// Contacts see the velocity of the part only. Among all joint speeds with the same velocity of the part, the nearest in
/// kinetic energy are those that an impulse on the part gives; so contacts are resolved as those of a free body with the
/// apparent inertia. Impulses of contacts and joint friction follow each other until they agree: both minimise the same
/// convex function, one block after the other.
#[derive(Debug)]
pub struct ArmStepper<'arm> {
    arm: &'arm Arm,
    time_step: f64,
    impedance: Impedance,
    /// The believed part in the frame of the part.
    grasp: Isometry3<f64>,
    /// Factor of the mass matrix, and with it of all inertia.
    heaviness: f64,
    controller: SampledController,
    friction: JointFriction,
    solver: ContactSolver,
    steps: usize,
    /// Joint positions (rad or m).
    configuration: JointVector,
    /// Joint speeds (rad/s or m/s).
    velocity: JointVector,
    /// Of joint positions nearby.
    posture: ArmPosture,
}

/// Speed of a joint (rad/s or m/s): a posture serves until a joint has moved as far as it would with this speed in one step.
const SLOW: f64 = 1.0;
/// Largest number of steps that a posture serves, so that it is exact at rest.
const SERVED: usize = 50;
/// Largest number of times that contacts and joint friction follow each other in a step.
const ROUNDS: usize = 20;
/// In the first of these, joint friction takes the contacts that push for ones that go on to.
const HOPEFUL: usize = 5;

impl<'arm> ArmStepper<'arm> {
    /// At rest, for steps of `time_step` seconds: `body` is where the part really is, `grasp` the believed part in its
    /// frame, and `near` names the branch. `None` if the arm does not reach that pose, or a number is none.
    pub fn new(
        model: &'arm ArmModel,
        near: &JointVector,
        (body, grasp): (&Isometry3<f64>, Isometry3<f64>),
        (impedance, disturbance): (Impedance, &Disturbance),
        time_step: f64,
        friction: f64,
    ) -> Option<Self> {
        let arm = &model.arm;
        let configuration = arm.inverse_kinematics(&(body * grasp), near).ok()?;
        let heaviness = 1.0 + disturbance.inertia;
        let torques = model.joint_friction.iter().map(|torque| torque * (1.0 + disturbance.joint_friction));
        Some(Self {
            posture: ArmPosture::new(arm, (&configuration, &JointVector::zeros()), &grasp, heaviness)?,
            arm,
            time_step,
            impedance,
            grasp,
            heaviness,
            controller: SampledController::new(model.control_period, model.delay + disturbance.delay),
            friction: JointFriction::new(torques, time_step),
            solver: ContactSolver::new(friction),
            steps: 0,
            configuration,
            velocity: JointVector::zeros(),
        })
    }

    /// Moves the body by one step, with `target` the reference at its begin. Adds the normal impulse (Ns) of every pair to
    /// `impulses`. Returns the overlap (m) that the previous step has left. Where the arm is singular, the velocity of the
    /// body is no number any more.
    pub fn step(
        &mut self,
        body: &mut Body,
        target: impl FnOnce() -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> f64 {
        let time = self.steps as f64 * self.time_step;
        self.steps += 1;
        let Self { posture, velocity, impedance, grasp, .. } = self;
        let torque = self.controller.torque(time, self.time_step, || {
            // Rotations of reference and impedance are those of the part.
            let believed = body.pose.rotation * grasp.translation.vector + body.pose.translation.vector;
            let believed = Isometry3::from_parts(believed.into(), body.pose.rotation);
            within_limits(self.arm, posture, command(posture, (&believed, velocity), impedance, &target()))
        });
        let acceleration = posture.mobility * (torque - posture.bias * self.heaviness);
        let free = *velocity + acceleration * self.time_step;
        // Contacts and friction only dissipate: with or without them, no point of the body moves further than this.
        let norm = free.dot(&(posture.mass * free)).max(0.0).sqrt();
        let reach = self.time_step * posture.metric.fastest(norm, finder.radius());
        let before = body.pose;
        let overlap = self.solver.correct(&posture.metric, &mut body.pose, finder, reach);
        if overlap > 0.0 {
            self.configuration += posture.correction(&before, &body.pose);
        }
        self.resolve(&free, body, &finder.contacts);
        for (pair, impulse) in self.solver.impulses() {
            impulses[pair] += impulse;
        }
        self.configuration += self.velocity * self.time_step;
        self.follow(body);
        overlap
    }

    /// Moves the body with the joints.
    fn follow(&mut self, body: &mut Body) {
        let is_near = !self.steps.is_multiple_of(SERVED)
            && (self.configuration - self.posture.configuration).amax() < SLOW * self.time_step;
        if !is_near {
            let state = (&self.configuration, &self.velocity);
            let Some(posture) = ArmPosture::new(self.arm, state, &self.grasp, self.heaviness) else {
                body.velocity = Vector3::repeat(f64::NAN);
                return;
            };
            self.posture = posture;
        }
        let twist = self.posture.jacobian * self.velocity;
        (body.velocity, body.angular_velocity) = (twist.fixed_rows::<3>(0).into(), twist.fixed_rows::<3>(3).into());
        body.pose = if is_near {
            moved(&body.pose, &(body.velocity * self.time_step), &(body.angular_velocity * self.time_step))
        } else {
            self.posture.pose
        };
    }

    /// Joint speeds after the step of the body from those without contacts and joint friction.
    fn resolve(&mut self, free: &JointVector, body: &Body, contacts: &[Contact]) {
        let Self { posture, solver, friction, .. } = self;
        if contacts.is_empty() {
            solver.release();
            self.velocity = free + posture.mobility * friction.impulses();
            friction.brake(&posture.mobility, &mut self.velocity);
            return;
        }
        for round in 1..=ROUNDS {
            let without = free + posture.mobility * friction.impulses();
            let scaled = posture.scaled(&without);
            if round == 1 {
                solver.set(&posture.metric, body, self.time_step, &scaled, contacts);
            }
            let resolved = solver.resolve(&scaled);
            self.velocity = without;
            if solver.pushes() {
                self.velocity += posture.change(&(resolved - scaled));
            }
            if round == ROUNDS || friction.is_zero() {
                break;
            }
            // Contacts that push go on to hold, mostly; where they do not, blocks follow each other.
            let held = if round <= HOPEFUL { solver.held() } else { &[] };
            if !friction.brake(&posture.mobility_held(held), &mut self.velocity) {
                break;
            }
        }
    }
}

/// What of the commanded torques (Nm or N) the joints can give while they also carry the arm, without what carries it.
fn within_limits(arm: &Arm, posture: &ArmPosture, torque: JointVector) -> JointVector {
    let (mut given, weight) = (torque, &posture.weight);
    for (index, joint) in arm.joints().iter().enumerate() {
        given[index] = (torque[index] + weight[index]).clamp(-joint.effort, joint.effort) - weight[index];
    }
    given
}

/// Torques (Nm or N) of the impedance law and for the bias, with the part `believed` at a pose and the joints at speeds `velocity`
/// (rad/s or m/s).
fn command(
    posture: &ArmPosture,
    (believed, velocity): (&Isometry3<f64>, &JointVector),
    impedance: &Impedance,
    target: &Knot,
) -> JointVector {
    let mut state = [0.0; 13];
    state[..7].copy_from_slice(&coordinates(believed));
    state[7..].copy_from_slice((posture.tracked * velocity).as_slice());
    let wrench = impedance.wrench(&target.state(), &state, &GraspError::default().pose());
    posture.tracked.tr_mul(&Vector6::from(wrench)) + posture.bias
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn motors_give_no_more_than_they_can_with_the_weight_of_the_arm() {
        let urdf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robot/tests/arms/six.urdf");
        let arm = Arm::read(&urdf, "tip").unwrap();
        let mut configuration = JointVector::zeros();
        [0.1, 0.7, 0.9, -0.3, 0.5, 0.2].iter().enumerate().for_each(|(joint, angle)| configuration[joint] = *angle);
        let still = JointVector::zeros();
        let posture = ArmPosture::new(&arm, (&configuration, &still), &Isometry3::identity(), 1.0).unwrap();
        let weight = posture.weight;
        assert!(weight.amax() > 1.0, "it is heavy: {weight}");
        for wanted in [1e4, -1e4] {
            let given = within_limits(&arm, &posture, JointVector::repeat(wanted)) + weight;
            for (index, joint) in arm.joints().iter().enumerate() {
                assert!((given[index] - joint.effort * wanted.signum()).abs() < 1e-9, "{}", joint.name);
            }
        }
        let small = JointVector::repeat(0.1);
        assert!((within_limits(&arm, &posture, small) - small).amax() < 1e-12);
    }
}

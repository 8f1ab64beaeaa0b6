//! One time step of an arm that holds the body: control at samples, joint friction, contacts, motion.

use nalgebra::{Isometry3, Matrix3, UnitQuaternion, Vector3};
use robot::{Arm, JointMatrix, JointVector};
use task::Impedance;
use task::pose::moved;

use crate::arm_mobility::ArmMobility;
use crate::arm_model::ArmModel;
use crate::arm_terms::ArmTerms;
use crate::body::Body;
use crate::contact::{Contact, ContactFinder};
use crate::contact_solver::ContactSolver;
use crate::disturbance::Injection;
use crate::dynamics::LARGEST_PENETRATION;
use crate::joint_friction::JointFriction;
use crate::latency::{DOUBLINGS, doublings, effective_mass, late};
use crate::metric::added_inertia;
use crate::reference::Knot;
use crate::sampled_controller::SampledController;
use crate::step_length::{StepLength, Steps, Substeps};

/// Steps of an arm, semi-implicit Euler in joint space: `M (v+ - v) = h (torques - bias) + friction + J' contacts` with
/// joint speeds `v` and impulses of joint friction and contacts; then positions move with `v+`. Torques hold between
/// samples, so the controller is explicit and may be unstable, as it would be on the arm.
///
/// Longer steps ([`StepLength`]) follow the midpoint rule, with the contacts of a predicted middle pose. They are
/// implicit in stiffness and damping. They model the torque latency `w` (half a control period plus the delay) to first
/// order, and are used only where that is accurate enough: with `x(t - w) = x - w v` and `v(t - w) = v - w a`, the
/// damping `D` becomes `D - w K` and the mass matrix `M - w J' D J`.
///
/// Contacts see only the velocity of the part. Among all joint speeds that give the part the same velocity, the nearest
/// in kinetic energy are those that an impulse on the part gives, so contacts are resolved as those of a free body with
/// the apparent inertia. Contacts and joint friction are resolved alternately until they agree: both minimise the same
/// convex function, one block after the other.
#[derive(Debug, Clone)]
pub struct ArmStepper<'arm> {
    arm: &'arm Arm,
    time_step: f64,
    impedance: Impedance,
    /// Mean time from a measurement to its torques (s), and the impedance with it to first order.
    latency: f64,
    late: Impedance,
    /// Where a player's controller sets the gains: the orientation of the part for which it sets the damping of
    /// rotations, and that damping (Nms/rad).
    set_for: Option<(UnitQuaternion<f64>, Matrix3<f64>)>,
    /// The believed part in the frame of the part.
    grasp: Isometry3<f64>,
    /// Factor of the mass matrix, and with it of all inertia.
    inertia_scale: f64,
    controller: SampledController,
    /// Whether the controller has samples; longer steps have none.
    is_sampled: bool,
    solver: ContactSolver,
    length: StepLength,
    /// The shortest steps so far.
    steps: usize,
    state: State,
    /// Terms of the equations of motion at a nearby configuration.
    terms: ArmTerms,
    /// The mass matrix minus what the latency of damping takes from it.
    effective_mass: JointMatrix,
    /// Mobility for steps of two to the power of 1, 2, ... of the shortest ones; `None` until it is needed.
    longer: [Option<ArmMobility>; DOUBLINGS],
}

/// The state of arm and part.
#[derive(Debug, Clone)]
struct State {
    /// Joint positions (rad or m).
    configuration: JointVector,
    /// Joint speeds (rad/s or m/s).
    velocity: JointVector,
    friction: JointFriction,
    body: Body,
}

/// Speed of a joint (rad/s or m/s): terms are computed again once a joint has moved as far as it would with this speed
/// in one step.
const SLOW: f64 = 1.0;
/// Largest number of steps between two computations of the terms, so that they are exact at rest.
const SERVED: usize = 50;
/// Largest number of rounds of contacts and joint friction in a step.
const ROUNDS: usize = 20;
/// During the first rounds, joint friction assumes that active contacts stay active.
const STAYING: usize = 5;
/// Smaller differences of torques (Nm or N) are rounding errors.
const ROUNDING: f64 = 1e-9;

impl<'arm> ArmStepper<'arm> {
    /// At rest, with `body` where the part really is; `near` names the IK branch. `None` if the arm does not reach that pose, or a value is not finite.
    pub fn new(
        model: &'arm ArmModel,
        near: &JointVector,
        body: &Isometry3<f64>,
        injection: &Injection,
        impedance: Impedance,
        steps: &Steps,
        solver: ContactSolver,
    ) -> Option<Self> {
        let (arm, disturbance, grasp) = (&model.arm, &injection.disturbance, injection.grasp.believed());
        let configuration = arm.inverse_kinematics(&(body * grasp), near).ok()?;
        let inertia_scale = 1.0 + disturbance.inertia;
        let torques = model.joint_friction.iter().map(|torque| torque * (1.0 + disturbance.joint_friction));
        let velocity = JointVector::zeros();
        let terms = ArmTerms::new(arm, &configuration, &velocity, &grasp, inertia_scale)?;
        let delay = model.delay + disturbance.delay;
        let latency = delay + 0.5 * model.control_period;
        let Steps { time_step, most, .. } = *steps;
        let doublings = doublings(&terms, &impedance, latency, time_step).min(most.ilog2() as usize);
        let body = Body { pose: *body, velocity: Vector3::zeros(), angular_velocity: Vector3::zeros() };
        Some(Self {
            arm,
            time_step,
            late: late(&impedance, latency),
            latency,
            set_for: None,
            grasp,
            inertia_scale,
            controller: SampledController::new(model.control_period, delay),
            is_sampled: true,
            solver,
            length: StepLength::new(steps, doublings),
            steps: 0,
            state: State { configuration, velocity, friction: JointFriction::new(torques), body },
            effective_mass: effective_mass(&terms, &impedance, latency),
            terms,
            impedance,
            longer: [const { None }; DOUBLINGS],
        })
    }

    /// With the controller of a player ([`Rollout::with_gains_set_for`](crate::Rollout::with_gains_set_for)), if there
    /// is one: an orientation of the part, and damping of rotations (Nms/rad) along its axes there.
    pub fn with_damping_set_for(mut self, set: Option<(UnitQuaternion<f64>, Matrix3<f64>)>) -> Self {
        self.set_for = set;
        self.rotate_damping();
        self
    }

    /// Damping with axes that are fixed in the world, in the present frame of the part.
    fn rotate_damping(&mut self) {
        let Some((orientation, damping)) = &self.set_for else { return };
        let rotation = (self.terms.pose.rotation.inverse() * orientation).to_rotation_matrix();
        self.impedance.rotational_damping = rotation * damping * rotation.inverse();
        self.late = late(&self.impedance, self.latency);
        self.effective_mass = effective_mass(&self.terms, &self.impedance, self.latency);
    }

    /// Share of Coriolis and centrifugal forces that the controller balances.
    fn balance(&self) -> f64 {
        if self.set_for.is_some() { 0.0 } else { 1.0 }
    }

    /// Moves the body by one step, after some of the shortest steps of an interval. `target` is the reference after a
    /// number of them. Adds the normal impulse (Ns) of every pair to `impulses`. Returns how many of the
    /// shortest steps this one replaces, and the penetration that the previous step has left. Where the arm is
    /// singular, the velocity of the body becomes NaN.
    pub fn step(
        &mut self,
        body: &mut Body,
        substeps: Substeps,
        target: impl Fn(f64) -> Knot,
        finder: &mut ContactFinder,
        impulses: &mut [f64],
    ) -> (usize, f64) {
        let (mut state, mut length) = (self.state.clone(), self.length);
        let (taken, penetration) = length.step(&mut state, substeps, |state, doublings| {
            if doublings == 0 {
                self.advance(state, &target(substeps.done as f64), finder)
            } else {
                let middle = substeps.done as f64 + 0.5 * f64::from(1_u32 << doublings) - self.latency / self.time_step;
                self.advance_far(state, doublings, &target(middle.max(0.0)), finder)
            }
        });
        self.is_sampled = taken == 1;
        self.steps += taken;
        (self.state, self.length) = (state, length);
        self.solver.add_impulses(impulses);
        self.renew_terms(taken);
        *body = self.state.body;
        (taken, penetration)
    }

    /// The shortest step. Returns the penetration (m) before it, and the largest change of velocity (m/s) of any point.
    fn advance(&mut self, state: &mut State, target: &Knot, finder: &mut ContactFinder) -> (f64, f64) {
        let balance = self.balance();
        let Self { terms, impedance, .. } = self;
        let (time, time_step) = ((self.steps) as f64 * self.time_step, self.time_step);
        let command = || {
            let wanted =
                terms.torque(impedance, &state.believed(&self.grasp), &state.velocity, target) + terms.bias * balance;
            within_limits(self.arm, terms, wanted)
        };
        if !self.is_sampled {
            self.controller.restart(time, command());
        }
        let torque = self.controller.torque(time, time_step, command);
        let mobility = &terms.mobility;
        let acceleration = mobility.inverse * (torque - terms.bias * self.inertia_scale);
        let free = state.velocity + acceleration * time_step;
        // Contacts and friction only dissipate: with or without them, no point of the body moves further than this.
        let norm = free.dot(&(mobility.mass * free)).max(0.0).sqrt();
        let reach = time_step * mobility.metric.fastest(norm, finder.radius());
        let before = state.body;
        let penetration = state.part_from(mobility, &mut self.solver, finder, reach);
        let velocity = resolve(mobility, &mut self.solver, state, &free, &finder.contacts, time_step);
        state.velocity = velocity;
        state.follow(terms, &velocity, time_step);
        (penetration, state.body.change(&before, finder.radius()))
    }

    /// A longer step, with the same results; the change is infinite if the step should be shorter.
    fn advance_far(
        &mut self,
        state: &mut State,
        doublings: usize,
        target: &Knot,
        finder: &mut ContactFinder,
    ) -> (f64, f64) {
        const TOO_LONG: (f64, f64) = (0.0, f64::INFINITY);
        let time_step = self.time_step * f64::from(1_u32 << doublings);
        let half = 0.5 * time_step;
        let balance = self.balance();
        let Self { terms, impedance, .. } = self;
        let longer = &mut self.longer[doublings - 1];
        if longer.is_none() {
            let mass = self.effective_mass + terms.of_joints(&added_inertia(half, &self.late));
            *longer = ArmMobility::new(mass, &terms.jacobian);
        }
        let Some(mobility) = longer else { return TOO_LONG };
        let (believed, still) = (state.believed(&self.grasp), JointVector::zeros());
        let wanted = terms.torque(impedance, &believed, &state.velocity, target) + terms.bias * balance;
        if (within_limits(self.arm, terms, wanted) - wanted).amax() > ROUNDING {
            return TOO_LONG;
        }
        // The mass matrix contains the torques of damping and of the change of positions.
        let torque = terms.torque(impedance, &believed, &still, target) + terms.bias * (balance - self.inertia_scale);
        let carried: JointMatrix = self.effective_mass * 2.0 - mobility.mass;
        let free = mobility.inverse * (carried * state.velocity + torque * time_step);
        let (before, radius) = (state.body, finder.radius());
        let reach = time_step * (before.fastest(radius) + self.length.largest_change());
        let penetration = state.part_from(&terms.mobility, &mut self.solver, finder, reach);
        let start = state.body.pose;
        if !finder.contacts.is_empty() {
            // Contacts slide and rotate within the step: forces are those of its middle.
            state.body.pose = moved(&start, &(before.velocity * half), &(before.angular_velocity * half));
            finder.find(&state.body.pose, reach);
        }
        let velocity = resolve(mobility, &mut self.solver, state, &free, &finder.contacts, time_step);
        let mean = (state.velocity + velocity) * 0.5;
        state.body.pose = start;
        state.velocity = velocity;
        state.follow(terms, &mean, time_step);
        let change = state.body.change(&before, radius);
        if change <= self.length.largest_change() && -finder.find(&state.body.pose, reach) > LARGEST_PENETRATION {
            return TOO_LONG;
        }
        (penetration, change)
    }

    /// Computes the terms again if the arm has moved too far from their configuration in the last steps.
    fn renew_terms(&mut self, taken: usize) {
        let State { configuration, velocity, body, .. } = &mut self.state;
        let is_old = self.steps / SERVED != (self.steps - taken) / SERVED;
        let is_near = (*configuration - self.terms.configuration).amax() < SLOW * self.time_step;
        if is_near && !is_old {
            return;
        }
        match ArmTerms::new(self.arm, configuration, velocity, &self.grasp, self.inertia_scale) {
            Some(terms) => {
                body.pose = terms.pose;
                body.set_twist(&(terms.jacobian * *velocity));
                self.effective_mass = effective_mass(&terms, &self.impedance, self.latency);
                self.terms = terms;
                self.rotate_damping();
                self.longer.fill(None);
            }
            None => body.velocity = Vector3::repeat(f64::NAN),
        }
    }
}

impl State {
    /// Where the controller believes the part's origin, with the rotation of the part; it is what reference and
    /// impedance refer to.
    fn believed(&self, grasp: &Isometry3<f64>) -> Isometry3<f64> {
        let Isometry3 { rotation, translation } = self.body.pose;
        Isometry3::from_parts((translation.vector + rotation * grasp.translation.vector).into(), rotation)
    }

    /// Finds the contacts within `reach` (m), and moves part and joints out of a penetration. Returns the penetration
    /// (m).
    fn part_from(
        &mut self,
        mobility: &ArmMobility,
        solver: &mut ContactSolver,
        finder: &mut ContactFinder,
        reach: f64,
    ) -> f64 {
        let before = self.body.pose;
        let penetration = solver.correct(&mobility.metric, &mut self.body.pose, finder, reach);
        if penetration > 0.0 {
            self.configuration += mobility.correction(&before, &self.body.pose);
        }
        penetration
    }

    /// Moves joints and part for a time (s) with mean joint speeds (rad/s or m/s).
    fn follow(&mut self, terms: &ArmTerms, mean: &JointVector, time_step: f64) {
        self.configuration += mean * time_step;
        self.body.set_twist(&(terms.jacobian * mean));
        let Body { pose, velocity, angular_velocity } = self.body;
        self.body.pose = moved(&pose, &(velocity * time_step), &(angular_velocity * time_step));
        self.body.set_twist(&(terms.jacobian * self.velocity));
    }
}

/// Joint speeds after a step (s) of the state, from those without contacts and joint friction.
fn resolve(
    mobility: &ArmMobility,
    solver: &mut ContactSolver,
    state: &mut State,
    free: &JointVector,
    contacts: &[Contact],
    time_step: f64,
) -> JointVector {
    let State { friction, body, .. } = state;
    if contacts.is_empty() {
        solver.release();
        let mut velocity = free + mobility.inverse * friction.impulses(time_step);
        friction.brake(&mobility.inverse, &mut velocity, time_step);
        return velocity;
    }
    let mut round = 1;
    loop {
        let mut velocity = free + mobility.inverse * friction.impulses(time_step);
        let scaled = mobility.scaled(&velocity);
        if round == 1 {
            solver.set(&mobility.metric, body, time_step, &scaled, contacts);
        }
        let resolved = solver.resolve_next(&scaled);
        if solver.pushes() {
            velocity += mobility.change(&(resolved - scaled));
        }
        if round == ROUNDS || friction.is_zero() {
            return velocity;
        }
        // Active contacts mostly stay active; where they do not, the blocks alternate.
        let held = if round <= STAYING { solver.held() } else { &[] };
        if !friction.brake(&mobility.held(held), &mut velocity, time_step) {
            return velocity;
        }
        round += 1;
    }
}

/// The part of the commanded torques (Nm or N) that the joints can give while they also support the arm's weight,
/// without the torques of the weight.
fn within_limits(arm: &Arm, terms: &ArmTerms, torque: JointVector) -> JointVector {
    let (mut given, weight) = (torque, &terms.weight);
    for (index, joint) in arm.joints().iter().enumerate() {
        given[index] = (torque[index] + weight[index]).clamp(-joint.effort, joint.effort) - weight[index];
    }
    given
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
        let terms = ArmTerms::new(&arm, &configuration, &still, &Isometry3::identity(), 1.0).unwrap();
        let weight = terms.weight;
        assert!(weight.amax() > 1.0, "the weight loads the joint: {weight}");
        for wanted in [1e4, -1e4] {
            let given = within_limits(&arm, &terms, JointVector::repeat(wanted)) + weight;
            for (index, joint) in arm.joints().iter().enumerate() {
                assert!((given[index] - joint.effort * wanted.signum()).abs() < 1e-9, "{}", joint.name);
            }
        }
        let small = JointVector::repeat(0.1);
        assert!((within_limits(&arm, &terms, small) - small).amax() < 1e-12);
    }
}

//! Regularised Coulomb friction: at the contact point `p` of a pair, the force
//! `f = -mu lambda_n |n| v_t / sqrt(|v_t|^2 + eps^2)` acts against the tangential velocity `v_t` of the body. It needs
//! neither variables nor rows of its own. Where Coulomb's friction would hold the body, it creeps with less than `eps`.

use autodiff::{Expression, Tape};
use task::algebra::{cross, dot, rotation};
use task::{AssemblyTask, Inertia, POSE, State, TWIST};

use super::contacts::CONTACT_FORCE;
use super::dynamics::{VELOCITY_DYNAMICS, accelerate, initial_states};
use crate::layout::{CONTACT, Layout};
use crate::point::{Point, Points};
use crate::term::{Source, StepTerm};

/// The speed `eps` of creeping per smoothing `tau` of the distances (m/s per N m): about 0.1 m/s in the first homotopy
/// iteration.
const CREEP_PER_SMOOTHING: f64 = 33.0;
/// The speed of creeping without smoothing (m/s).
const LEAST_CREEP: f64 = 1e-3;

/// First components of the normal, as a force, and of the contact point in the contact information.
const NORMAL: usize = 1;
const POINT: usize = CONTACT;

/// Where each kind of input ends, in the order of the tape.
const TWIST_END: usize = TWIST;
const POSE_END: usize = TWIST_END + POSE;
const FORCE_END: usize = POSE_END + 1;
const NORMAL_END: usize = FORCE_END + 3;
const POINT_END: usize = NORMAL_END + 3;

/// Friction of every pair.
pub struct Friction {
    /// One per scenario.
    coefficients: Vec<f64>,
    time_step: f64,
    /// In the unit of force.
    inertia: Inertia,
    /// Compliant states at the start.
    initial: Vec<State>,
}

impl Friction {
    /// The friction of a task.
    pub fn new(task: &AssemblyTask) -> Self {
        Self {
            coefficients: task.scenarios().iter().map(|scenario| scenario.friction).collect(),
            time_step: task.horizon.time_step,
            inertia: task.inertia.in_units_of(task.impedance.force_unit()),
            initial: initial_states(task),
        }
    }

    /// Force (world frame) on a body whose contact point moves with a velocity.
    fn force<'tape>(
        coefficient: Expression<'tape>,
        velocity: &[Expression<'tape>; 3],
        normal_force: Expression<'tape>,
        normal: &[Expression<'tape>],
        tau: Expression<'tape>,
    ) -> [Expression<'tape>; 3] {
        let squared_norm = dot(normal, normal);
        let along = dot(normal, velocity) / squared_norm;
        let tangential: [Expression; 3] = std::array::from_fn(|axis| velocity[axis] - normal[axis] * along);
        let creep = tau * CREEP_PER_SMOOTHING;
        let speed = (dot(&tangential, &tangential) + creep * creep + LEAST_CREEP * LEAST_CREEP).sqrt();
        let scale = -coefficient * normal_force * squared_norm.sqrt() / speed;
        tangential.map(|component| component * scale)
    }
}

impl StepTerm for Friction {
    fn points(&self) -> Points {
        Points::Pairs
    }

    /// Inputs twist (6), pose before the step (7), contact force, normal (3) and contact point (3) at that pose, `tau` and
    /// `mu`. Outputs what the pair adds to the velocity defect, `-dt M^-1 (f, R' (r x f))` (6), where `r` leads from
    /// the body's origin to the contact point.
    fn tape(&self) -> Tape {
        Tape::record(POINT_END + 2, |inputs| {
            let (twist, pose) = (&inputs[..TWIST_END], &inputs[TWIST_END..POSE_END]);
            let (normal_force, normal) = (inputs[POSE_END], &inputs[FORCE_END..NORMAL_END]);
            let (point, tau, coefficient) = (&inputs[NORMAL_END..POINT_END], inputs[POINT_END], inputs[POINT_END + 1]);
            let squared_norm = dot(&pose[3..], &pose[3..]);
            let to_world = rotation(&pose[3..]).map(|row| row.map(|entry| entry / squared_norm));
            let to_body: [[Expression; 3]; 3] = std::array::from_fn(|row| to_world.map(|column| column[row]));
            let lever: [Expression; 3] = std::array::from_fn(|axis| point[axis] - pose[axis]);
            let lever = to_body.map(|row| dot(&row, &lever));
            let turning = cross(&twist[3..], &lever);
            let velocity = std::array::from_fn(|axis| twist[axis] + dot(&to_world[axis], &turning));
            let force = Self::force(coefficient, &velocity, normal_force, normal, tau);
            let torque = cross(&lever, &to_body.map(|row| dot(&row, &force)));
            let wrench = [force[0], force[1], force[2], torque[0], torque[1], torque[2]];
            accelerate(&self.inertia, &wrench).map(|component| component * -self.time_step).to_vec()
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        let &Point { stage, owner, slot, .. } = point;
        match input {
            ..TWIST_END => Source::Variable(layout.state(stage, owner) + POSE + input),
            TWIST_END..POSE_END if stage == 1 => Source::Constant(self.initial[point.scenario()][input - TWIST_END]),
            TWIST_END..POSE_END => Source::Variable(layout.state(stage - 1, owner) + input - TWIST_END),
            POSE_END..FORCE_END => Source::Variable(layout.variable(CONTACT_FORCE, stage, owner) + slot),
            FORCE_END..NORMAL_END => Source::Contact(NORMAL + input - FORCE_END),
            NORMAL_END..POINT_END => Source::Contact(POINT + input - NORMAL_END),
            POINT_END => Source::Smoothing,
            _ => Source::Constant(self.coefficients[point.scenario()]),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(VELOCITY_DYNAMICS, point.stage, point.owner) + output
    }
}

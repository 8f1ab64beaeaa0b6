//! States, kinematics of the reference, and dynamics of the scenarios without contact.

use autodiff::{Expression, Tape};
use kkt::{Class, Owner};
use nlp::Bounds;
use task::algebra::apply;
use task::{AssemblyTask, Impedance, Inertia, Limits, POSE, Pose, STATE, State, TWIST};

use crate::block::{Block, Owners, POSE_VARIABLES, TWIST_VARIABLES};
use crate::layout::Layout;
use crate::point::{Point, Points};
use crate::term::{Source, StepTerm};

/// Rows: kinematic defect of the reference (7, Eq. discretizedOCP), `q - q_prev - dt Q(q_prev) v`.
pub const REFERENCE_KINEMATICS: &str = "reference kinematics";
/// Rows: pose defect of a scenario (7, Eq. ts1), `q - q_prev - dt Q(q) v`.
pub const POSE_DYNAMICS: &str = "pose dynamics";
/// Rows: velocity defect of a scenario (6, Eq. ts), `v - v_prev - dt M^-1 w`, with the sum `w` of the wrenches of all
/// terms.
pub const VELOCITY_DYNAMICS: &str = "velocity dynamics";

/// States and kinematics of the reference.
pub struct ReferenceKinematics {
    time_step: f64,
    start: State,
    limits: Limits,
}

impl ReferenceKinematics {
    /// The kinematics of a task.
    pub fn new(task: &AssemblyTask) -> Self {
        Self { time_step: task.horizon.time_step, start: task.start.at_rest(), limits: task.limits }
    }
}

impl StepTerm for ReferenceKinematics {
    fn variables(&self) -> Vec<Block> {
        state_variables(Owners::Reference, &self.limits)
    }

    fn rows(&self) -> Vec<Block> {
        vec![defects(REFERENCE_KINEMATICS, Owners::Reference, Class::PoseMultiplier, POSE)]
    }

    fn points(&self) -> Points {
        Points::Stages(Owners::Reference)
    }

    /// Inputs previous pose (7), pose (7) and twist (6); outputs `q - q_prev - dt Q(q_prev) v` (7, Eq. discretizedOCP).
    fn tape(&self) -> Tape {
        Tape::record(POSE + STATE, |inputs| {
            let (previous, rest) = inputs.split_at(POSE);
            let (pose, twist) = rest.split_at(POSE);
            kinematic_defect(previous, pose, previous, twist, self.time_step)
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        match input {
            0..POSE if point.stage == 1 => Source::Constant(self.start[input]),
            0..POSE => Source::Variable(layout.state(point.stage - 1, point.owner) + input),
            _ => Source::Variable(layout.state(point.stage, point.owner) + input - POSE),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(REFERENCE_KINEMATICS, point.stage, point.owner) + output
    }
}

/// States and dynamics of the scenarios, without contact.
pub struct CompliantDynamics {
    time_step: f64,
    inertia: Inertia,
    impedance: Impedance,
    /// Where the body sits in the gripper, one pose per scenario.
    grasps: Vec<Pose>,
    /// Compliant states at the start.
    initial: Vec<State>,
    limits: Limits,
}

impl CompliantDynamics {
    /// The dynamics of a task.
    pub fn new(task: &AssemblyTask) -> Self {
        Self {
            time_step: task.horizon.time_step,
            inertia: task.inertia.clone(),
            impedance: task.impedance.clone(),
            grasps: grasps(task),
            initial: initial_states(task),
            limits: task.limits,
        }
    }
}

impl StepTerm for CompliantDynamics {
    fn variables(&self) -> Vec<Block> {
        state_variables(Owners::Scenarios, &self.limits)
    }

    fn rows(&self) -> Vec<Block> {
        vec![
            defects(POSE_DYNAMICS, Owners::Scenarios, Class::PoseMultiplier, POSE),
            defects(VELOCITY_DYNAMICS, Owners::Scenarios, Class::VelocityMultiplier, TWIST),
        ]
    }

    fn points(&self) -> Points {
        Points::Stages(Owners::Scenarios)
    }

    /// Inputs previous state, state and reference state (13 each) and grasp error (7). Outputs the pose defect
    /// `q - q_prev - dt Q(q) v` (7) and the velocity defect `v - v_prev - dt M^-1 J` (6) with the impedance wrench `J`
    /// (Eq. impedancewrench). At the pose `(rho, xi) = P_q(q, grasp)` that wrench has the force
    /// `K_t (rho_r - rho) + D_t (nu_r - nu)` and the torque `2 eta K_r eps + D_r (omega_r - omega)`, where
    /// `(eta, eps) = xi^-1 (x) xi_r`.
    fn tape(&self) -> Tape {
        Tape::record(3 * STATE + POSE, |inputs| {
            let (previous, rest) = inputs.split_at(STATE);
            let (state, rest) = rest.split_at(STATE);
            let (reference, grasp) = rest.split_at(STATE);
            let (pose, twist) = state.split_at(POSE);
            let mut defects = kinematic_defect(&previous[..POSE], pose, pose, twist, self.time_step);
            let wrench = self.impedance.law(reference, state, grasp);
            let acceleration = accelerate(&self.inertia, &wrench);
            for axis in 0..TWIST {
                defects.push(twist[axis] - previous[POSE + axis] - acceleration[axis] * self.time_step);
            }
            defects
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        let &Point { stage, owner, .. } = point;
        match (input / STATE, input % STATE) {
            (0, component) if stage == 1 => Source::Constant(self.initial[point.scenario()][component]),
            (0, component) => Source::Variable(layout.state(stage - 1, owner) + component),
            (1, component) => Source::Variable(layout.state(stage, owner) + component),
            (2, component) => Source::Variable(layout.state(stage, Owner::Reference) + component),
            (_, component) => Source::Constant(self.grasps[point.scenario()][component]),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        match output {
            0..POSE => layout.row(POSE_DYNAMICS, point.stage, point.owner) + output,
            _ => layout.row(VELOCITY_DYNAMICS, point.stage, point.owner) + output - POSE,
        }
    }
}

/// Compliant states at the start, one per scenario: at rest at the pose `P_q^-1(start, grasp)`.
pub fn initial_states(task: &AssemblyTask) -> Vec<State> {
    task.scenarios().iter().map(|scenario| scenario.grasp.actual(&task.start).at_rest()).collect()
}

/// Where the body sits in the gripper, one pose per scenario.
pub fn grasps(task: &AssemblyTask) -> Vec<Pose> {
    task.scenarios().iter().map(|scenario| scenario.grasp.pose()).collect()
}

/// `M^-1` times a wrench: the acceleration (6).
pub fn accelerate<'tape>(inertia: &Inertia, wrench: &[Expression<'tape>; TWIST]) -> [Expression<'tape>; TWIST] {
    apply(&inertia.inverse().expect("a validated inertia is positive definite"), wrench)
}

/// `q - q_prev - dt Q(q_at) v` with `Q = blkdiag(I, E(xi) / 2)`: 7 expressions.
fn kinematic_defect<'tape>(
    previous: &[Expression<'tape>],
    pose: &[Expression<'tape>],
    kinematics_at: &[Expression<'tape>],
    twist: &[Expression<'tape>],
    time_step: f64,
) -> Vec<Expression<'tape>> {
    let mut defects: Vec<_> = (0..3).map(|axis| pose[axis] - previous[axis] - twist[axis] * time_step).collect();
    let [w, x, y, z] = [kinematics_at[3], kinematics_at[4], kinematics_at[5], kinematics_at[6]];
    let [p, q, r] = [twist[3], twist[4], twist[5]];
    let rates = [-(x * p) - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p];
    for (component, rate) in rates.into_iter().enumerate() {
        defects.push(pose[3 + component] - previous[3 + component] - rate * (0.5 * time_step));
    }
    defects
}

/// Pose and twist; limits of velocities are bounds on the twist.
fn state_variables(owners: Owners, limits: &Limits) -> Vec<Block> {
    let mut largest = [f64::INFINITY; TWIST];
    for (axis, limit) in limits.velocities() {
        largest[axis] = limit;
    }
    let block = |name, class, bounds| Block { name, owners, class, per_pair: false, bounds };
    vec![
        block(POSE_VARIABLES, Class::Pose, Bounds::symmetric([f64::INFINITY; POSE])),
        block(TWIST_VARIABLES, Class::Velocity, Bounds::symmetric(largest)),
    ]
}

/// Rows of equalities with the value zero.
fn defects(name: &'static str, owners: Owners, class: Class, count: usize) -> Block {
    Block { name, owners, class, per_pair: false, bounds: Bounds::uniform(count, 0.0, 0.0) }
}

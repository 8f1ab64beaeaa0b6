//! Limits of accelerations and wrenches. Limits of velocities and contact forces are bounds on variables.

use autodiff::Tape;
use kkt::Class;
use nlp::Bounds;
use task::{AssemblyTask, Impedance, POSE, Pose, STATE, TWIST};

use crate::block::{Block, Owners};
use crate::layout::Layout;
use crate::point::{Point, Points};
use crate::term::{Source, StepTerm};
use crate::terms::dynamics::grasps;

/// Rows: limited axes of the acceleration of a step.
pub const ACCELERATION: &str = "acceleration";
/// Rows: limited axes of the impedance wrench at the end of a step.
pub const WRENCH: &str = "wrench";

/// Limited accelerations of all trajectories.
pub struct AccelerationLimits {
    time_step: f64,
    /// Limited axes of the twist, each with its largest absolute value.
    limits: Vec<(usize, f64)>,
}

impl AccelerationLimits {
    /// The limits of a task.
    pub fn new(task: &AssemblyTask) -> Self {
        Self { time_step: task.horizon.time_step, limits: task.limits.accelerations() }
    }
}

impl StepTerm for AccelerationLimits {
    fn rows(&self) -> Vec<Block> {
        vec![block(ACCELERATION, Owners::All, &self.limits)]
    }

    fn points(&self) -> Points {
        Points::Stages(Owners::All)
    }

    /// Inputs previous twist (6) and twist (6); outputs `(v - v_prev) / dt` of the limited axes.
    fn tape(&self) -> Tape {
        Tape::record(2 * TWIST, |inputs| {
            let (previous, twist) = inputs.split_at(TWIST);
            let axes = self.limits.iter().map(|&(axis, _)| axis);
            axes.map(|axis| (twist[axis] - previous[axis]) * (1.0 / self.time_step)).collect()
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        match input {
            // All trajectories start at rest.
            0..TWIST if point.stage == 1 => Source::Constant(0.0),
            0..TWIST => Source::Variable(layout.state(point.stage - 1, point.owner) + POSE + input),
            _ => Source::Variable(layout.state(point.stage, point.owner) + POSE + input - TWIST),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(ACCELERATION, point.stage, point.owner) + output
    }
}

/// Limited wrenches of the impedance controller in all scenarios.
pub struct WrenchLimits {
    impedance: Impedance,
    /// Where the body sits in the gripper, one pose per scenario.
    grasps: Vec<Pose>,
    /// Limited axes of the wrench, each with its largest absolute value.
    limits: Vec<(usize, f64)>,
}

impl WrenchLimits {
    /// The limits of a task.
    pub fn new(task: &AssemblyTask) -> Self {
        Self { impedance: task.impedance.clone(), grasps: grasps(task), limits: task.limits.wrenches() }
    }
}

impl StepTerm for WrenchLimits {
    fn rows(&self) -> Vec<Block> {
        vec![block(WRENCH, Owners::Scenarios, &self.limits)]
    }

    fn points(&self) -> Points {
        Points::Stages(Owners::Scenarios)
    }

    /// Inputs reference state (13), compliant state (13) and grasp error (7); outputs the limited axes of the impedance
    /// wrench (Eq. impedancewrench): force (axes 0 to 2, world frame, N) and torque (3 to 5, body frame, Nm).
    fn tape(&self) -> Tape {
        Tape::record(2 * STATE + POSE, |inputs| {
            let (reference, rest) = inputs.split_at(STATE);
            let (state, grasp) = rest.split_at(STATE);
            let wrench = self.impedance.law(reference, state, grasp);
            self.limits.iter().map(|&(axis, _)| wrench[axis]).collect()
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        match (input / STATE, input % STATE) {
            (0, component) => Source::Variable(layout.state(point.stage, kkt::Owner::Reference) + component),
            (1, component) => Source::Variable(layout.state(point.stage, point.owner) + component),
            (_, component) => Source::Constant(self.grasps[point.scenario()][component]),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(WRENCH, point.stage, point.owner) + output
    }
}

/// A row between `-limit` and `limit` for every limited axis.
fn block(name: &'static str, owners: Owners, limits: &[(usize, f64)]) -> Block {
    let bounds = Bounds::symmetric(limits.iter().map(|&(_, limit)| limit));
    Block { name, owners, class: Class::InequalityMultiplier, per_pair: false, bounds }
}

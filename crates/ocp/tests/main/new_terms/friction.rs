//! Regularised Coulomb friction: the force `f = -mu lambda |n| v_t / sqrt(|v_t|^2 + eps^2)` is added to the velocity
//! dynamics; the term has neither rows nor variables. It is nonlinear in the contact information and also depends on
//! the pose before the step directly. Simplified: parts touch at the origin of the world, rotations of the body are
//! small.

use autodiff::{Expression, Tape};
use ocp::{CONTACT, CONTACT_FORCE, Layout, Point, Points, Source, StepTerm, VELOCITY_DYNAMICS};
use task::algebra::dot;
use task::{AssemblyTask, POSE, Pose, TWIST};

pub struct RegularisedCoulomb {
    time_step: f64,
    mass: f64,
    /// Diagonal of the rotational inertia (kg m^2).
    rotational: [f64; 3],
    starts: Vec<Pose>,
    coefficient: f64,
    regularisation: f64,
}

impl RegularisedCoulomb {
    /// With a coefficient of friction `mu` and a speed `eps` (m/s) below which a part creeps instead of sticking.
    pub fn new(task: &AssemblyTask, coefficient: f64, regularisation: f64) -> Self {
        Self {
            time_step: task.horizon.time_step,
            mass: task.inertia.mass().unwrap(),
            rotational: std::array::from_fn(|axis| task.inertia.rotational()[(axis, axis)]),
            starts: task.grasps.iter().map(|grasp| grasp.actual(&task.start)).collect(),
            coefficient,
            regularisation,
        }
    }
}

impl StepTerm for RegularisedCoulomb {
    fn points(&self) -> Points {
        Points::Pairs
    }

    /// Inputs twist (6), position before the step (3), normal force and contact information (7).
    fn tape(&self) -> Tape {
        Tape::record(TWIST + 4 + CONTACT, |inputs| {
            let (twist, rest) = inputs.split_at(TWIST);
            let (position, rest) = rest.split_at(3);
            let (normal_force, normal) = (rest[0], &rest[2..5]);
            let lever: [Expression; 3] = std::array::from_fn(|axis| -position[axis]);
            let turning = cross(&twist[3..], &lever);
            let velocity: [Expression; 3] = std::array::from_fn(|axis| twist[axis] + turning[axis]);
            let squared_norm = dot(normal, normal);
            let along = dot(normal, &velocity) / squared_norm;
            let tangential: [Expression; 3] = std::array::from_fn(|axis| velocity[axis] - normal[axis] * along);
            let speed = (dot(&tangential, &tangential) + self.regularisation.powi(2)).sqrt();
            let scale = normal_force * squared_norm.sqrt() * self.coefficient / speed;
            let force: [Expression; 3] = std::array::from_fn(|axis| -(tangential[axis] * scale));
            let torque = cross(&lever, &force);
            let defect = |axis: usize| match axis {
                0..3 => force[axis] * (-self.time_step / self.mass),
                _ => torque[axis - 3] * (-self.time_step / self.rotational[axis - 3]),
            };
            (0..TWIST).map(defect).collect()
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        const POSITION_END: usize = TWIST + 3;
        let &Point { stage, owner, slot, .. } = point;
        match input {
            0..TWIST => Source::Variable(layout.state(stage, owner) + POSE + input),
            TWIST..POSITION_END if stage == 1 => Source::Constant(self.starts[point.scenario()][input - TWIST]),
            TWIST..POSITION_END => Source::Variable(layout.state(stage - 1, owner) + input - TWIST),
            POSITION_END => Source::Variable(layout.variable(CONTACT_FORCE, stage, owner) + slot),
            _ => Source::Contact(input - POSITION_END - 1),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        layout.row(VELOCITY_DYNAMICS, point.stage, point.owner) + output
    }
}

fn cross<'tape>(left: &[Expression<'tape>], right: &[Expression<'tape>]) -> [Expression<'tape>; 3] {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        left[next] * right[last] - left[last] * right[next]
    })
}

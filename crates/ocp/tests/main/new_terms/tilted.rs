//! Two more contacts per pair, with the same gap and with normals tilted to both sides. The term has variables and
//! rows, two of each kind per pair, and adds to the velocity dynamics.

use autodiff::{Expression, Tape};
use kkt::Class;
use nlp::Bounds;
use ocp::{Block, CONTACT, Layout, Owners, Point, Points, Source, StepTerm, VELOCITY_DYNAMICS};
use task::algebra::dot;
use task::{AssemblyTask, POSE, TWIST};

pub const FORCE: &str = "tilted force";
const GAP: &str = "tilted gap";
const PRODUCT: &str = "tilted product";
/// Contacts of a pair.
const SIDES: usize = 2;
/// A direction of the world that no part is aligned with.
const DIRECTION: [f64; 3] = [0.36, 0.48, 0.8];

pub struct TiltedContacts {
    time_step: f64,
    mass: f64,
    coefficient: f64,
    sigma: f64,
}

impl TiltedContacts {
    /// With a coefficient of friction.
    pub fn new(task: &AssemblyTask, coefficient: f64) -> Self {
        let (time_step, mass) = (task.horizon.time_step, task.inertia.mass().unwrap());
        Self { time_step, mass, coefficient, sigma: f64::NAN }
    }

    fn block(&self, name: &'static str, class: Class, lower: f64, upper: f64) -> Block {
        let bounds = Bounds::uniform(SIDES, lower, upper);
        Block { name, owners: Owners::Scenarios, class, per_pair: true, bounds }
    }
}

impl StepTerm for TiltedContacts {
    fn variables(&self) -> Vec<Block> {
        vec![self.block(FORCE, Class::ContactForce, 0.0, f64::INFINITY)]
    }

    fn rows(&self) -> Vec<Block> {
        vec![
            self.block(GAP, Class::InequalityMultiplier, 0.0, f64::INFINITY),
            self.block(PRODUCT, Class::InequalityMultiplier, f64::NEG_INFINITY, self.sigma),
        ]
    }

    fn set_sigma(&mut self, sigma: f64) {
        self.sigma = sigma;
    }

    fn points(&self) -> Points {
        Points::Pairs
    }

    /// Inputs twist (6), two forces and contact information (7).
    fn tape(&self) -> Tape {
        Tape::record(TWIST + SIDES + CONTACT, |inputs| {
            let (twist, rest) = inputs.split_at(TWIST);
            let (forces, rest) = rest.split_at(SIDES);
            let (distance, normal) = (rest[0], &rest[1..]);
            let along = (normal[0] * DIRECTION[0] + normal[1] * DIRECTION[1] + normal[2] * DIRECTION[2])
                / dot(&normal[..3], &normal[..3]);
            let tangent: [Expression; 3] = std::array::from_fn(|axis| -(normal[axis] * along) + DIRECTION[axis]);
            let tilted = |side: usize| -> [Expression; 3] {
                let coefficient = if side == 0 { self.coefficient } else { -self.coefficient };
                std::array::from_fn(|axis| normal[axis] + tangent[axis] * coefficient)
            };
            let normals = [tilted(0), tilted(1)];
            let share = |axis: usize| normals[0][axis] * forces[0] + normals[1][axis] * forces[1];
            let mut outputs: Vec<Expression> = (0..3).map(|axis| share(axis) * (-self.time_step / self.mass)).collect();
            let gaps = normals.map(|normal| distance + dot(&normal, &twist[..3]) * self.time_step);
            outputs.extend(gaps);
            outputs.extend((0..SIDES).map(|side| gaps[side] * forces[side]));
            outputs
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        const FORCES_END: usize = TWIST + SIDES;
        let &Point { stage, owner, slot, .. } = point;
        match input {
            0..TWIST => Source::Variable(layout.state(stage, owner) + POSE + input),
            TWIST..FORCES_END => Source::Variable(layout.variable(FORCE, stage, owner) + SIDES * slot + input - TWIST),
            _ => Source::Contact(input - FORCES_END),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        let &Point { stage, owner, slot, .. } = point;
        match output {
            0..3 => layout.row(VELOCITY_DYNAMICS, stage, owner) + output,
            3 | 4 => layout.row(GAP, stage, owner) + SIDES * slot + output - 3,
            _ => layout.row(PRODUCT, stage, owner) + SIDES * slot + output - 5,
        }
    }
}

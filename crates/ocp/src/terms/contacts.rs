//! Frictionless contact (Eq. ts, Eq. ts3): with the gap `a = Phi + dt n~' v` of a pair, `a >= 0`, `lambda_n >= 0` and
//! `a lambda_n <= sigma` (Scholtes' relaxation) or `a lambda_n = sigma` (smoothing).

use autodiff::{Expression, Tape};
use kkt::Class;
use nlp::Bounds;
use task::algebra::dot;
use task::{AssemblyTask, Complementarity, Inertia, POSE, TWIST};

use super::dynamics::{VELOCITY_DYNAMICS, accelerate};
use crate::block::{Block, Owners};
use crate::layout::{CONTACT, Layout};
use crate::point::{Point, Points};
use crate::term::{Source, StepTerm};

/// Variables: normal force `lambda_n` of every pair in the step that leads to a stage, in [`task::Impedance::force_unit`].
pub const CONTACT_FORCE: &str = "contact force";
/// Rows: linearised gap `a` of every pair.
pub const GAP: &str = "gap";
/// Rows: product `a lambda_n` of every pair (m times the unit of force).
pub const PRODUCT: &str = "complementarity product";

/// Normal force, gap and complementarity of every pair.
pub struct Contacts {
    time_step: f64,
    /// In the unit of force.
    inertia: Inertia,
    /// In the unit of force.
    largest_force: f64,
    complementarity: Complementarity,
    sigma: f64,
}

impl Contacts {
    /// The contacts of all pairs of a task.
    pub fn new(task: &AssemblyTask, complementarity: Complementarity) -> Self {
        let unit = task.impedance.force_unit();
        Self {
            time_step: task.horizon.time_step,
            inertia: task.inertia.in_units_of(unit),
            largest_force: task.limits.contact_force / unit,
            complementarity,
            sigma: f64::NAN,
        }
    }

    fn block(&self, name: &'static str, class: Class, lower: f64, upper: f64) -> Block {
        let bounds = Bounds::uniform(1, lower, upper);
        Block { name, owners: Owners::Scenarios, class, per_pair: true, bounds }
    }
}

impl StepTerm for Contacts {
    fn variables(&self) -> Vec<Block> {
        vec![self.block(CONTACT_FORCE, Class::ContactForce, 0.0, self.largest_force)]
    }

    fn rows(&self) -> Vec<Block> {
        let (class, least_product) = match self.complementarity {
            Complementarity::Relaxation => (Class::InequalityMultiplier, f64::NEG_INFINITY),
            Complementarity::Smoothing => (Class::ComplementarityMultiplier, self.sigma),
        };
        vec![
            self.block(GAP, Class::InequalityMultiplier, 0.0, f64::INFINITY),
            self.block(PRODUCT, class, least_product, self.sigma),
        ]
    }

    fn set_sigma(&mut self, sigma: f64) {
        self.sigma = sigma;
    }

    fn points(&self) -> Points {
        Points::Pairs
    }

    /// Inputs twist (6), contact force and contact information `(Phi, n~)` (7) at the pose before the step. Outputs
    /// what the pair adds to the velocity defect, `-dt M^-1 n~ lambda_n` (6), the gap `a = Phi + dt n~' v` and the
    /// product
    /// `a lambda_n`.
    fn tape(&self) -> Tape {
        Tape::record(TWIST + 1 + CONTACT, |inputs| {
            let (twist, rest) = inputs.split_at(TWIST);
            let (force, distance, normal) = (rest[0], rest[1], &rest[2..]);
            let wrench: [Expression; TWIST] = std::array::from_fn(|axis| normal[axis] * force);
            let acceleration = accelerate(&self.inertia, &wrench);
            let mut outputs: Vec<Expression> = acceleration.iter().map(|&value| value * -self.time_step).collect();
            let gap = distance + dot(normal, twist) * self.time_step;
            outputs.push(gap);
            outputs.push(gap * force);
            outputs
        })
    }

    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source {
        let &Point { stage, owner, slot, .. } = point;
        match input {
            0..TWIST => Source::Variable(layout.state(stage, owner) + POSE + input),
            TWIST => Source::Variable(layout.variable(CONTACT_FORCE, stage, owner) + slot),
            _ => Source::Contact(input - TWIST - 1),
        }
    }

    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize {
        let &Point { stage, owner, slot, .. } = point;
        match output {
            0..TWIST => layout.row(VELOCITY_DYNAMICS, stage, owner) + output,
            TWIST => layout.row(GAP, stage, owner) + slot,
            _ => layout.row(PRODUCT, stage, owner) + slot,
        }
    }
}

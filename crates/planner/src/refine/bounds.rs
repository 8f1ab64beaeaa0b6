//! How far refinement may lead a reference.

use nalgebra::Vector3;
use simulation::{Evaluator, Reference};

use crate::problem::Problem;

/// A refined reference leaves the box of plan and straight way by at most so many times the sum of delta-hat and tolerance.
const MARGIN: f64 = 2.0;
/// It is at most so many times as fast as they are, where no limit says how fast it may be.
const HASTE: f64 = 4.0;

/// With references that stay near a plan and the straight way: a part that is thrown may arrive as well.
pub fn near(evaluator: Evaluator, problem: &Problem, reference: &Reference) -> Evaluator {
    let task = problem.task();
    let straight = Reference::straight(&task.start, &task.goal, task.horizon);
    let margin = MARGIN * (problem.delta() + problem.success().position);
    evaluator.near(&[reference, &straight], margin, HASTE, radius(problem))
}

/// Distance of the body's origin from its farthest corner (m).
fn radius(problem: &Problem) -> f64 {
    let corners = problem.scene().body.iter().flat_map(|part| part.shape.vertices());
    corners.map(|corner| Vector3::from(*corner).norm()).fold(0.0, f64::max)
}

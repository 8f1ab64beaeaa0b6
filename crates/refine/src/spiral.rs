//! A spiral search for the hole as the reference to refine.

use nalgebra::Vector3;
use plan::Variant;
use simulation::{Reference, SpiralSearch};

use crate::candidate::Candidate;
use crate::origin::{Origin, Solved};
use crate::schedule::Deadline;
use crate::search::Search;

/// The spiral search, where more test cases pass with it than with a candidate; otherwise the candidate.
pub fn or_spiral<'run>(search: &Search<'run>, own: Candidate<'run>, until: Deadline) -> Candidate<'run> {
    let Some(reference) = spiral(search) else { return own };
    let horizon = reference.horizon();
    let Some(best) = search.training.best_of(&[reference], &|| search.schedule.is_over(until)) else { return own };
    let mut variant = Variant::of_scene(search.setting.problem);
    variant.task.horizon = horizon;
    let solved = Solved::new(Origin::Spiral, variant, own.solved.iterations.clone());
    let found = search.training.candidate(best, solved);
    if found.refinement.failing_fraction() < own.refinement.failing_fraction() { found } else { own }
}

/// The search of the problem: for a free body that is guided across the insertion in all directions.
fn spiral(search: &Search) -> Option<Reference> {
    let (problem, target) = (search.setting.problem, search.setting.target);
    let (engagement, parameters) = (problem.engagement(), target.parameters.spiral);
    if problem.arm().is_some() || !engagement.free.is_empty() {
        return None;
    }
    let reference = SpiralSearch {
        out: Vector3::from(engagement.out),
        depth: engagement.depth_m?,
        offset: problem.offset_magnitude(),
        pitch: parameters.pitch * engagement.clearance_m?,
        friction: target.largest_friction(),
        longest: parameters.longest,
    }
    .reference(problem.task())?;
    search.setting.evaluator.bounds().allow(&reference).then_some(reference)
}

//! Motions that solve nothing as references to refine: that of an earlier plan, a straight push, a spiral search for the hole.

use nalgebra::Vector3;
use plan::{Problem, Variant};
use simulation::{Reference, SpiralSearch};

use crate::candidate::Candidate;
use crate::origin::{Origin, Solved};
use crate::schedule::Deadline;
use crate::search::Search;

/// The simple motion in which the fewest test cases fail, where those are fewer than with a candidate; otherwise the
/// candidate. Not a push: where it fails, its refinement gets stuck more often than that of a plan, and comes later.
pub fn or_simple<'run>(search: &Search<'run>, own: Candidate<'run>, until: Deadline) -> Candidate<'run> {
    let mut best = own;
    for (origin, reference) in simple_motions(search).into_iter().filter(|(origin, _)| *origin != Origin::Push) {
        let mut variant = Variant::of_scene(search.setting.problem);
        variant.task.horizon = reference.horizon();
        let Some(found) = search.training.best_of(&[reference], &|| search.schedule.is_over(until)) else { break };
        let solved = Solved::new(origin, variant, best.solved.iterations.clone());
        let found = search.training.candidate(found, solved);
        if found.refinement.failing_fraction() < best.refinement.failing_fraction() {
            best = found;
        }
    }
    best
}

/// The simple motions that keep all limits. With an arm, only that of an earlier plan: no other has ever become robust.
pub fn simple_motions(search: &Search) -> Vec<(Origin, Reference)> {
    let problem = search.setting.problem;
    let mut motions: Vec<_> = problem.earlier().map(|earlier| (Origin::Earlier, earlier.clone())).into_iter().collect();
    if problem.arm().is_none() && search.setting.target.parameters.training.simple {
        motions.push((Origin::Push, straight_push(problem)));
        motions.extend(spiral(search).map(|reference| (Origin::Spiral, reference)));
    }
    motions.retain(|(_, reference)| search.setting.evaluator.bounds().allow(reference));
    motions
}

/// The straight push from start to goal.
pub fn straight_push(problem: &Problem) -> Reference {
    let task = problem.task();
    Reference::straight(&task.start, &task.goal, task.horizon)
}

/// The search of the problem, where the body is guided across the insertion in all directions.
fn spiral(search: &Search) -> Option<Reference> {
    let (problem, target) = (search.setting.problem, search.setting.target);
    let (engagement, parameters) = (problem.engagement(), target.parameters.spiral);
    if !engagement.free.is_empty() {
        return None;
    }
    SpiralSearch {
        out: Vector3::from(engagement.out),
        depth: engagement.depth_m?,
        offset: problem.offset_magnitude(),
        pitch: parameters.pitch * engagement.clearance_m?,
        friction: target.largest_friction(),
        longest: parameters.longest,
    }
    .reference(problem.task())
}

//! Motions that solve nothing as references to refine: that of an earlier plan, a straight push, a spiral search for the hole.

use nalgebra::Vector3;
use plan::{PlanIteration, Problem, Variant};
use simulation::{Reference, SpiralSearch};

use crate::candidate::Candidate;
use crate::origin::{Origin, Solved};
use crate::schedule::Deadline;
use crate::search::Search;
use crate::setting::Setting;

/// The simple motion that passes most of the training set, where that is more than a candidate does; otherwise the
/// candidate. Not a push: where it fails, its refinement gets stuck more often than that of a plan, and comes later.
pub fn or_simple<'run>(search: &Search<'run>, own: Candidate<'run>, until: Deadline) -> Candidate<'run> {
    let mut motions = simple_motions(search);
    motions.retain(|(origin, _)| *origin != Origin::Push);
    match best_simple(search, motions, &own.solved.iterations, until) {
        Some(found) if found.refinement.failing_fraction() < own.refinement.failing_fraction() => found,
        _ => own,
    }
}

/// The one of some simple motions that passes most of the training set; the homotopy is the one that is shown. `None`
/// without motions or time.
pub fn best_simple<'run>(
    search: &Search<'run>,
    motions: Vec<(Origin, Reference)>,
    homotopy: &[PlanIteration],
    until: Deadline,
) -> Option<Candidate<'run>> {
    let (origins, references): (Vec<Origin>, Vec<Reference>) = motions.into_iter().unzip();
    let best = search.training.best_of(&references, &|| search.schedule.is_over(until))?;
    let index = best.winner.index;
    let mut variant = Variant::of_scene(search.setting.problem);
    variant.task.horizon = references[index].horizon();
    Some(search.training.candidate(best, Solved::new(origins[index], variant, homotopy.to_vec())))
}

/// The simple motions that keep all limits, the preferred last, as it wins a tie. With an arm, only that of an earlier plan: no
/// other has ever become robust.
pub fn simple_motions(search: &Search) -> Vec<(Origin, Reference)> {
    let problem = search.setting.problem;
    let mut motions = Vec::new();
    if problem.arm().is_none() && search.setting.target.parameters.training.simple {
        motions.extend(spiral(search).map(|reference| (Origin::Spiral, reference)));
        motions.push((Origin::Push, straight_push(problem)));
    }
    motions.retain(|(_, reference)| search.setting.evaluator.bounds().allow(reference));
    motions.extend(earlier(search).map(|earlier| (Origin::Earlier, earlier)));
    motions
}

/// The motion of the earlier plan, where there is one and it keeps all limits.
pub fn earlier(search: &Search) -> Option<Reference> {
    let Setting { problem, evaluator, .. } = search.setting;
    problem.earlier().filter(|earlier| evaluator.bounds().allow(earlier)).cloned()
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

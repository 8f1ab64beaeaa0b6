//! Motions that solve nothing as references to refine: that of an earlier plan, a straight push, a spiral search for the hole.

use nalgebra::Vector3;
use plan::{PlanIteration, PlannerError, Problem, Variant};
use simulation::{Reference, SpiralSearch};

use crate::candidate::Candidate;
use crate::first::judge_first;
use crate::origin::{Origin, Solved};
use crate::schedule::Deadline;
use crate::search::Search;
use crate::setting::Setting;

/// How holes are searched for.
#[derive(Clone, Copy)]
struct Manner {
    /// Whether the search turns the other way.
    is_mirrored: bool,
    /// How many pitches friction may hold the body back.
    lag: f64,
}

const USUAL: Manner = Manner { is_mirrored: false, lag: 4.0 };
/// The lag of a search that presses a quarter as hard as the usual one.
const LIGHT: f64 = 1.0;

/// A motion and where it is from.
pub type Motion = (Origin, Reference);

/// A clearance that is this many times another one needs fewer turns of a spiral.
const WIDER: f64 = 1.25;

/// The simple motion that passes most of the training set, where that is more than a candidate does; otherwise the
/// candidate. Not a push: where it fails, its refinement gets stuck more often than that of a plan, and comes later.
pub fn or_simple<'run>(search: &Search<'run>, own: Candidate<'run>, until: Deadline) -> Candidate<'run> {
    let mut motions = simple_motions(search);
    motions.retain(|(origin, _)| *origin != Origin::Push);
    motions.extend(earlier(search));
    match best_simple(search, &motions, &own.solved.iterations, until) {
        Some((_, found)) if found.refinement.failing_fraction() < own.refinement.failing_fraction() => found,
        _ => own,
    }
}

/// Evaluates the earlier plan, simple motions, and searches of another manner, each time the one that passes most of the
/// training set, until one is good enough or none passes more than the last one did. The failures of each join the training
/// set. Returns the last one; `None` without motions or time.
pub fn judge_simple<'run>(
    search: &mut Search<'run>,
    homotopy: &[PlanIteration],
    until: Deadline,
) -> Result<Option<Candidate<'run>>, PlannerError> {
    let (mut motions, mut best): (Vec<Motion>, Option<Candidate>) = (Vec::new(), None);
    let stages: [fn(&Search) -> Vec<Motion>; 3] =
        [|search| Vec::from_iter(earlier(search)), simple_motions, other_searches];
    for stage in stages {
        let new = stage(search);
        if new.is_empty() {
            continue;
        }
        motions.extend(new);
        while let Some((index, next)) = best_simple(search, &motions, homotopy, until) {
            let failing = next.refinement.failing_fraction();
            if best.as_ref().is_some_and(|best| best.refinement.failing_fraction() <= failing) {
                break;
            }
            let failures = judge_first(search, next.solved.clone(), next.refinement.reference().clone())?;
            search.training.cases.extend(failures.iter().map(|(case, _)| *case));
            motions.remove(index);
            best.insert(next).refinement.add(failures);
            if !search.goes_on(until) {
                return Ok(best);
            }
        }
    }
    Ok(best)
}

/// The one of some simple motions that passes most of the training set, and its index; the homotopy is the one that is shown.
/// `None` without motions or time.
fn best_simple<'run>(
    search: &Search<'run>,
    motions: &[Motion],
    homotopy: &[PlanIteration],
    until: Deadline,
) -> Option<(usize, Candidate<'run>)> {
    let references: Vec<Reference> = motions.iter().map(|(_, reference)| reference.clone()).collect();
    let best = search.training.best_of(&references, &|| search.schedule.is_over(until))?;
    let index = best.winner.index;
    let mut variant = Variant::of_scene(search.setting.problem);
    variant.task.horizon = references[index].horizon();
    let solved = Solved::new(motions[index].0, variant, homotopy.to_vec());
    Some((index, search.training.candidate(best, solved)))
}

/// Searches for the hole and a straight push, the preferred last, as it wins a tie; those that keep all limits. None with an arm:
/// they have never become robust there.
pub fn simple_motions(search: &Search) -> Vec<Motion> {
    let push = (Origin::Push, straight_push(search.setting.problem));
    tried(search, || searches(search, USUAL).into_iter().chain([push]).collect())
}

/// Searches for the hole that press less, and searches that turn the other way.
fn other_searches(search: &Search) -> Vec<Motion> {
    let other = [Manner { lag: LIGHT, ..USUAL }, Manner { is_mirrored: true, ..USUAL }];
    tried(search, || other.into_iter().flat_map(|manner| searches(search, manner)).collect())
}

/// Those of some motions that keep all limits, where motions are tried that solve nothing.
fn tried(search: &Search, motions: impl FnOnce() -> Vec<Motion>) -> Vec<Motion> {
    let Setting { problem, target, evaluator, .. } = search.setting;
    let are_tried = problem.arm().is_none() && target.parameters.training.simple;
    let mut motions = if are_tried { motions() } else { Vec::new() };
    motions.retain(|(_, reference)| evaluator.bounds().allow(reference));
    motions
}

/// The motion of the earlier plan, where there is one and it keeps all limits.
pub fn earlier(search: &Search) -> Option<Motion> {
    let Setting { problem, evaluator, .. } = search.setting;
    let earlier = problem.earlier().filter(|earlier| evaluator.bounds().allow(earlier));
    earlier.map(|earlier| (Origin::Earlier, earlier.clone()))
}

/// The straight push from start to goal.
pub fn straight_push(problem: &Problem) -> Reference {
    let task = problem.task();
    Reference::straight(&task.start, &task.goal, task.horizon)
}

/// The searches for the hole, from where offset bodies meet it: with the clearance at the goal and, where that is wider because the
/// hole narrows, with the one at the entrance.
fn searches(search: &Search, Manner { is_mirrored, lag }: Manner) -> Vec<Motion> {
    let (problem, target) = (search.setting.problem, search.setting.target);
    let (engagement, parameters) = (problem.engagement(), target.parameters.spiral);
    let Some((entrance, tightest)) = engagement.entrance.zip(engagement.clearance_m) else { return Vec::new() };
    let out = Vector3::from(engagement.out);
    let guided = engagement.free.first().map(|free| out.cross(&Vector3::from(*free)).normalize());
    let mut clearances = vec![tightest];
    clearances.extend(Some(entrance.clearance_m).filter(|clearance| *clearance > WIDER * tightest));
    let reference = |clearance: f64| {
        let spiral = SpiralSearch {
            out,
            guided,
            is_mirrored,
            lag,
            depth: entrance.distance_m,
            offset: problem.offset_magnitude(),
            pitch: parameters.pitch * clearance,
            friction: target.largest_friction(),
            longest: parameters.longest,
        };
        Some((Origin::Spiral, spiral.reference(problem.task())?))
    };
    clearances.into_iter().filter_map(reference).collect()
}

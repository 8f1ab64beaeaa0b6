//! Many drafts instead of one plan.
//!
//! A rollout of an arm takes several times as long as one of a free body, so that refinement tries few perturbations, and it
//! matters where it begins. How many test cases plans pass before they are refined differs tenfold with weights and offsets,
//! and which of them are good differs from scene to scene: so several are made, each by one thread, and compared.

use std::time::Duration;

use fastrand::Rng;
use plan::{Event, HomotopyRun, PlannerError, RobustParameters, Variant};
use simulation::Reference;
use workers::Workers;

use crate::again::refine_best;
use crate::candidate::Candidate;
use crate::draft::Draft;
use crate::origin::{Origin, Solved};
use crate::refining::refine;
use crate::schedule::Deadline;
use crate::search::Search;
use crate::setting::Setting;

/// Drafts that were not refined; at least one of their homotopy steps has all time steps.
#[derive(Default)]
struct Drafts(Vec<Solved>);

/// Refines the plan of the scene, which took `solving`, or the best of drafts where that fails in fewer test cases.
pub fn refine_better<'run>(
    search: &mut Search<'run>,
    own: Candidate<'run>,
    solving: Duration,
) -> Result<(), PlannerError> {
    let mut drafts = Drafts::default();
    let is_lost = own.refinement.failing_fraction() > search.setting.target.parameters.drafts.lost;
    let until = search.schedule.drafts(solving).filter(|_| search.setting.problem.arm().is_some() && is_lost);
    if let Some(until) = until {
        search.setting.session.tell(Event::Variant { name: "drafts", number: 1, count: 1 });
        drafts = Drafts::solve(search, until)?;
        search.setting.session.tell(Event::VariantSolved { status: &format!("{} drafts", drafts.0.len()) });
    }
    match drafts.take_best(search) {
        Some(draft) if draft.refinement.failing_fraction() < own.refinement.failing_fraction() => {
            search.found.rounds.push(own.round);
            refine_promising(search, draft, &mut None, &mut drafts)
        }
        mut second @ Some(_) => {
            refine_promising(search, own, &mut second, &mut drafts)?;
            search.found.rounds.extend(second.map(|draft| draft.round));
            Ok(())
        }
        None => refine(search, own, search.schedule.own(), 0.0),
    }
}

/// Refines `first`. If its first evaluation is not promising, refines `second`, then the other drafts, the best first;
/// if none is, continues with the best so far. An unused `second` is left in place.
fn refine_promising<'run>(
    search: &mut Search<'run>,
    first: Candidate<'run>,
    second: &mut Option<Candidate<'run>>,
    drafts: &mut Drafts,
) -> Result<(), PlannerError> {
    let (trying, promising) = (search.schedule.other_drafts(), search.setting.target.parameters.drafts.promising);
    let mut next = Some(first);
    while let Some(candidate) = next {
        refine(search, candidate, search.schedule.own(), promising)?;
        if search.found.best.is_some() && search.found.rate() >= promising {
            return Ok(());
        }
        next = if search.goes_on(trying) { second.take().or_else(|| drafts.take_best(search)) } else { None };
    }
    refine_best(search, search.schedule.own())
}

impl Drafts {
    /// Solves drafts until a time, each with one thread. An interrupted draft keeps its finished homotopy steps; drafts
    /// without a step on all time steps are dropped.
    fn solve(search: &Search, until: Deadline) -> Result<Self, PlannerError> {
        let Setting { problem, target, session, .. } = search.setting;
        let scene = Variant::of_scene(problem);
        let RobustParameters { drafts: parameters, seeds, .. } = &target.parameters;
        let mut random = Rng::with_seed(seeds.first);
        let friction = target.largest_friction();
        let drafts = (0..parameters.most).map(|_| Draft::random(&mut random, friction, parameters));
        let solve = |draft: Draft| {
            let variant = draft.variant(&scene, parameters);
            let is_over = || search.schedule.is_over(until);
            let iterations = match is_over() {
                true => Vec::new(),
                false => HomotopyRun::new(&variant).finished(session, is_over)?,
            };
            Ok(Solved::new(Origin::Draft(draft), variant, iterations))
        };
        let solved = Workers::new(session.threads).map(drafts.into_iter(), solve);
        let solved: Result<Vec<Solved>, PlannerError> = solved.into_iter().collect();
        Ok(Self(solved?.into_iter().filter(|draft| !draft.with_all_steps().is_empty()).collect()))
    }

    /// Takes out the draft with the best reference. `None` without drafts or time.
    fn take_best<'run>(&mut self, search: &Search<'run>) -> Option<Candidate<'run>> {
        let mut places = Vec::new();
        let mut references: Vec<Reference> = Vec::new();
        for (draft, solved) in self.0.iter().enumerate() {
            let fine = solved.with_all_steps();
            let last = &fine[fine.len().saturating_sub(search.setting.target.parameters.drafts.last)..];
            places.extend(last.iter().map(|&index| (draft, index)));
            references.extend(last.iter().map(|&index| Reference::from(&solved.iterations[index].trajectory)));
        }
        let best = search.training.best_of(&references, &|| search.schedule.is_over(search.schedule.end()))?;
        let (draft, index) = places[best.winner.index];
        let solved = Solved { chosen: index + 1, ..self.0.swap_remove(draft) };
        let candidate = search.training.candidate(best, solved);
        search.setting.session.tell(Event::VariantTried {
            failing: candidate.round.training_failures,
            cases: candidate.round.training_cases,
        });
        Some(candidate)
    }
}

#[cfg(test)]
mod tests {
    use plan::parameters::DraftParameters;
    use task::Horizon;

    use super::*;
    use crate::tests::{in_corner, of_scene};

    #[test]
    fn of_a_draft_only_what_has_all_steps_is_played() {
        in_corner(Duration::from_secs(1000), |search| {
            let mut draft = Variant::of_scene(search.setting.problem);
            let Horizon { steps, time_step } = draft.task.horizon;
            draft.task.horizon = Horizon { steps: 60, time_step: time_step * steps as f64 / 60.0 };
            draft.settings.coarse_iterations = 3;
            let iterations = HomotopyRun::new(&draft).finished(search.setting.session, || false).unwrap();
            let solved = |count: usize| Solved::new(Origin::Scene, draft.clone(), iterations[..count].to_vec());
            assert!(Drafts(vec![solved(3)]).take_best(search).is_none(), "all have half of the steps");
            assert_eq!(Drafts(vec![solved(4)]).take_best(search).unwrap().round.chosen_stage, 4);
        });
    }

    #[test]
    fn where_the_first_evaluation_is_poor_a_draft_takes_the_place_of_the_plan() {
        in_corner(Duration::from_secs(1000), |search| {
            let scene = Variant::of_scene(search.setting.problem);
            let solved = HomotopyRun::new(&scene).finished(search.setting.session, || false).unwrap();
            let draft = Draft::random(&mut Rng::with_seed(1), 0.0, &DraftParameters::default());
            let mut drafts = Drafts(vec![Solved::new(Origin::Draft(draft), scene.clone(), solved)]);
            let resting = Reference::new(0.1, &[search.setting.problem.task().start.at_rest(); 3]);
            let best = search.training.best_of(&[resting], &|| false).unwrap();
            let own = search.training.candidate(best, of_scene(search));
            refine_promising(search, own, &mut None, &mut drafts).unwrap();
            let rounds: Vec<(&str, Option<f64>)> =
                search.found.rounds.iter().map(|round| (round.planned.as_str(), round.rate)).collect();
            assert_eq!(rounds[0], ("the scene as it is", Some(0.0)));
            assert!(
                rounds[1].0.starts_with("draft with") && rounds[1].1 > Some(DraftParameters::default().promising),
                "{rounds:?}"
            );
            assert_eq!(search.found.best.as_ref().unwrap().round, 2);
        });
    }
}

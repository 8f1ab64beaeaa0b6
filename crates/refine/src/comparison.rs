//! The final comparison of the latest references in the same test cases.
//!
//! An evaluation ends as soon as it is decided, mostly after few test cases of its own. Its rate shows whether a
//! reference is good enough, but hardly which of two is better.

use plan::PlannerError;
use simulation::Reference;

use crate::candidate::Evaluated;
use crate::evaluation::{Judgement, Wanted};
use crate::keep::keep;
use crate::race::{Heats, race};
use crate::search::Search;
use crate::setting::Setting;

/// Keeps the best of the latest and the best so far, unless that is robust or the time is over.
pub fn compare_latest(search: &mut Search) -> Result<(), PlannerError> {
    let Setting { target, evaluator, .. } = search.setting;
    let parameters = target.parameters.comparison;
    let Some(best) = search.found.best.clone().filter(|best| !best.reached) else { return Ok(()) };
    let mut compared = Vec::from(std::mem::take(&mut search.found.latest));
    if !compared.iter().any(|latest| (latest.round, latest.perturbations) == (best.round, best.perturbations)) {
        compared.insert(0, best);
    }
    if compared.len() < 2 {
        return Ok(());
    }
    let references: Vec<Reference> = compared.iter().map(|latest| latest.reference.clone()).collect();
    let evaluation = search.judge.new_evaluation(parameters.random);
    let stop = || search.schedule.is_over(search.schedule.limit());
    let heats = Heats { cases: evaluation.cases(), first: parameters.first };
    let Some(winner) = race(evaluator, &references, heats, &stop) else { return Ok(()) };
    let judgement = evaluation.judgement(&winner.results, Wanted::target(target));
    let winner = compared.swap_remove(winner.index);
    search.tell_refined(&judgement);
    let best = if judgement.reached { decided(search, winner, judgement) } else { winner.judged(&judgement) };
    keep(search, best, search.found.rounds.clone())
}

/// The winner after a whole evaluation: the few test cases of the comparison decide against a reference, not for it. If
/// the time ends before that is decided, with the evaluation of more rollouts.
fn decided(search: &mut Search, winner: Evaluated, few: Judgement) -> Evaluated {
    let whole = search.judge(&winner.reference, search.schedule.limit());
    let played = whole.rates.rollouts();
    if whole.unplayed == 0 || played > few.rates.rollouts().max(winner.rates.rollouts()) {
        winner.judged(&whole)
    } else if winner.unplayed > 0 {
        winner
    } else {
        winner.judged(&Judgement { reached: false, unplayed: whole.unplayed, ..few })
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::parameters::ComparisonParameters;
    use plan::{OffsetRegion, SuccessRate, SuccessRates};

    use super::*;
    use crate::evaluation::Drawn;
    use crate::origin::Solved;
    use crate::tests::{in_corner, of_scene};

    /// The result of a comparison of a motion that stays at the start with a push to the goal.
    fn kept_in(time_limit: Duration) -> Evaluated {
        in_corner(time_limit, |search| {
            let task = search.setting.problem.task();
            let solved = Solved { chosen: 1, ..of_scene(search) };
            let lucky = |reference: Reference, perturbations: usize, successes: usize| Evaluated {
                solved: solved.clone(),
                reference,
                rates: SuccessRates(vec![SuccessRate {
                    rollouts: 2,
                    successes,
                    ..SuccessRate::unplayed(0.0, 0.0, OffsetRegion::Hull, false)
                }]),
                reached: false,
                evaluation: Drawn::default(),
                unplayed: 0,
                failing: Vec::new(),
                round: 1,
                perturbations,
            };
            let resting = lucky(Reference::new(0.1, &[task.start.at_rest(); 3]), 1, 2);
            search.found.best = Some(resting.clone());
            let latest = search.setting.target.parameters.comparison.latest;
            let push = Reference::straight(&task.start, &task.goal, task.horizon);
            search.found.remember(lucky(push, 2, 0), latest);
            for perturbations in 3..latest + 2 {
                search.found.remember(Evaluated { perturbations, ..resting.clone() }, latest);
            }
            compare_latest(search).unwrap();
            search.found.take_best().unwrap()
        })
    }

    #[test]
    fn what_does_best_in_the_same_trials_is_kept_whatever_its_own_evaluation_said() {
        let kept = kept_in(Duration::from_secs(100));
        assert_eq!(kept.perturbations, 2);
        assert!(
            kept.rates.rollouts() > ComparisonParameters::default().first,
            "all cases of the evaluation: {}",
            kept.rates.rollouts()
        );
        assert!(kept.rates.overall() > 0.5, "{}", kept.rates.overall());
    }

    #[test]
    fn without_time_the_best_so_far_is_kept() {
        let kept = kept_in(Duration::ZERO);
        assert_eq!((kept.perturbations, kept.rates.rollouts()), (1, 2));
    }
}

//! Robust plans with margins beyond the requirements.
//!
//! Simulators disagree with one another and with reality: a plan that barely succeeds in one may fail in another. A robust plan for an
//! arm is therefore refined in a hardened environment while there is time: with more friction, the largest rotation
//! errors only, and upper estimates of contact forces for compliant contacts.

use plan::{PlannerError, Round, Session};
use simulation::Evaluator;

use crate::again::refine_best;
use crate::candidate::Evaluated;
use crate::comparison::compare_latest;
use crate::keep::keep;
use crate::schedule::Deadline;
use crate::search::Search;
use crate::setting::Setting;

/// Refines a robust plan for an arm in the hardened environment, for at most as long as it has taken so far.
pub fn add_margins(search: &mut Search) -> Result<(), PlannerError> {
    let Setting { problem, target, evaluator, trainer, .. } = search.setting;
    let is_wanted = |best: &Evaluated| best.reached && !best.solved.marks.has_margins;
    let Some(robust) = search.found.best.clone().filter(is_wanted) else { return Ok(()) };
    if problem.arm().is_none() || !search.training.may_perturb() {
        return Ok(());
    }
    let worlds = [evaluator, trainer].map(|world| world.clone().hardened(target.parameters.margins.friction));
    refine_in(search, &worlds, robust, search.schedule.margins())
}

/// Refines a robust plan with other evaluations and another training set, until a time. The result is kept if it is
/// robust in these, too.
fn refine_in(
    search: &mut Search,
    [evaluator, trainer]: &[Evaluator; 2],
    robust: Evaluated,
    until: Deadline,
) -> Result<(), PlannerError> {
    // What is kept on disk is of this world.
    let session = Session { folder: None, ..*search.setting.session };
    let mut other = Search::new(Setting { evaluator, trainer, session: &session, ..search.setting });
    other.training.cases.extend_from_slice(&search.training.cases[other.training.cases.len()..]);
    other.schedule = search.schedule.until(until, &session);
    (other.judge.evaluations, other.training.tried) = (search.judge.evaluations, search.training.tried);
    let refined = refine_robust(&mut other, robust)?;
    (search.judge.evaluations, search.training.tried) = (other.judge.evaluations, other.training.tried);
    let Some((refined, round)) = refined else { return Ok(()) };
    let judgement = search.judge(&refined.reference, search.schedule.end());
    search.tell_refined(&judgement);
    if !judgement.reached {
        return Ok(());
    }
    search.found.rounds.push(Round { rate: Some(judgement.rates.overall()), ..round });
    let round = search.found.rounds.len();
    keep(search, Evaluated { round, ..refined.judged(&judgement) }, search.found.rounds.clone())
}

/// Refines a plan until it is robust in this environment or the time is over. The best, with its round; `None` if
/// nothing is better than the plan as it is.
fn refine_robust(search: &mut Search, mut plan: Evaluated) -> Result<Option<(Evaluated, Round)>, PlannerError> {
    plan.solved.marks.has_margins = true;
    let until = search.schedule.end();
    let judgement = search.judge(&plan.reference, until);
    search.found.best = Some(Evaluated { round: 0, ..plan.judged(&judgement) });
    while search.goes_on(until) {
        refine_best(search, until)?;
    }
    compare_latest(search)?;
    let best = search.found.take_best()?;
    let round = best.round.checked_sub(1).map(|index| search.found.rounds.swap_remove(index));
    Ok(round.map(|round| (best, round)))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::RobustnessTarget;
    use simulation::{Reference, Success};

    use super::*;
    use crate::first::judge_first;
    use crate::tests::{in_corner_for, of_scene};

    /// A push of the corner scene, which is robust there, after a number of perturbations with the requirement to end
    /// within a distance (m) of the goal: the kept plan, and its rounds.
    fn kept_after(max_perturbations: usize, position: f64) -> (Evaluated, Vec<Round>) {
        let (max_perturbations, time_limit) = (Some(max_perturbations), Duration::from_secs(100_000));
        in_corner_for(RobustnessTarget { max_perturbations, time_limit, ..RobustnessTarget::default() }, |search| {
            let task = search.setting.problem.task();
            let push = Reference::straight(&task.start, &task.goal, task.horizon);
            judge_first(search, of_scene(search), push).unwrap();
            let robust = search.found.best.clone().unwrap();
            assert!(robust.reached, "{}", robust.rates.overall());
            let accurate =
                Evaluator::new(&search.setting.problem.world(), &[0.0], Success { position, ..Success::default() });
            let worlds = [accurate.clone(), accurate];
            refine_in(search, &worlds, robust, search.schedule.end()).unwrap();
            (search.found.take_best().unwrap(), search.found.rounds.clone())
        })
    }

    #[test]
    fn what_becomes_better_in_a_harder_world_and_stays_robust_is_kept() {
        let (kept, rounds) = kept_after(200, 1e-3);
        assert!(kept.reached && kept.perturbations > 0 && kept.solved.marks.has_margins, "{}", kept.solved.planned());
        let round = &rounds[kept.round - 1];
        assert_eq!((round.planned.as_str(), round.rate), (kept.solved.planned().as_str(), Some(kept.rates.overall())));
    }

    #[test]
    fn a_plan_that_is_robust_in_a_harder_world_too_stays() {
        let (kept, rounds) = kept_after(200, 0.1);
        assert_eq!((kept.reached, kept.perturbations, kept.round, rounds.len()), (true, 0, 1, 1));
    }

    #[test]
    fn a_plan_stays_where_no_change_is_tried() {
        let (kept, rounds) = kept_after(0, 1e-9);
        assert_eq!((kept.reached, kept.perturbations, kept.round, rounds.len()), (true, 0, 1, 1));
    }
}

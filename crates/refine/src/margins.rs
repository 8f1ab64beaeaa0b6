//! Robust plans that tolerate more than they must.
//!
//! Simulators differ, and reality differs from them: what succeeds by a hair in one fails in another. So a robust plan for
//! an arm is refined in a harder world while there is time: with more friction, the largest turns only, and contact forces of
//! contacts that yield a little.

use plan::{Event, PlannerError, Round, Session};
use simulation::Evaluator;

use crate::Refiner;
use crate::candidate::Kept;
use crate::schedule::Deadline;

impl Refiner<'_> {
    /// Refines a robust plan for an arm in the harder world, in at most as much time as it has taken so far.
    pub(super) fn add_margins(&mut self) -> Result<(), PlannerError> {
        let is_wanted = |best: &Kept| best.reached && !best.solved.marks.has_margins;
        let Some(robust) = self.best.clone().filter(is_wanted) else { return Ok(()) };
        if self.problem.arm().is_none() || !self.may_change() {
            return Ok(());
        }
        let worlds =
            [self.evaluator, self.trainer].map(|world| world.clone().hardened(self.target.parameters.margins.friction));
        self.refine_in(&worlds, robust, self.schedule.margins())
    }

    /// Refines a robust plan in another world, of evaluations and of training, until a time. What comes of it is kept if it is
    /// robust in this world, too.
    fn refine_in(
        &mut self,
        [evaluator, trainer]: &[Evaluator; 2],
        robust: Kept,
        until: Deadline,
    ) -> Result<(), PlannerError> {
        // What is kept on disk is of this world.
        let session = Session { folder: None, ..*self.session };
        let mut other = Refiner::new(self.problem, self.target, (evaluator, trainer), &session);
        other.training.extend_from_slice(&self.training[other.training.len()..]);
        other.schedule = self.schedule.until(until, &session);
        (other.evaluations, other.tried) = (self.evaluations, self.tried);
        let refined = other.refine_robust(robust)?;
        (self.evaluations, self.tried) = (other.evaluations, other.tried);
        let Some((refined, round)) = refined else { return Ok(()) };
        let judgement = self.judge(&refined.reference, self.schedule.end());
        if judgement.rates.rollouts() > 0 {
            self.session.tell(Event::Refined { rate: judgement.rates.overall() });
        }
        if !judgement.reached {
            return Ok(());
        }
        self.rounds.push(Round { rate: Some(judgement.rates.overall()), ..round });
        let round = self.rounds.len();
        self.keep(Kept { round, ..refined.judged(judgement) }, self.rounds.clone())
    }

    /// Refines a plan that is robust in another world, until it is robust in this one or the time is over. The best, with its
    /// round; `None` if nothing is better than the plan as it is.
    fn refine_robust(&mut self, mut plan: Kept) -> Result<Option<(Kept, Round)>, PlannerError> {
        plan.solved.marks.has_margins = true;
        let until = self.schedule.end();
        let judgement = self.judge(&plan.reference, until);
        self.best = Some(Kept { round: 0, ..plan.judged(judgement) });
        while self.goes_on(until) {
            self.refine_best(until)?;
        }
        self.compare_latest()?;
        let best = self.take_best()?;
        let round = best.round.checked_sub(1).map(|index| self.rounds.swap_remove(index));
        Ok(round.map(|round| (best, round)))
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::RobustnessTarget;
    use simulation::{Reference, Success};

    use super::*;
    use crate::tests::in_corner_for;

    /// A push of the corner scene, which is robust there, after so many changes in a world where it has to end within a
    /// distance (m) of the goal: what is kept, and its rounds.
    fn kept_after(max_perturbations: usize, position: f64) -> (Kept, Vec<Round>) {
        let (max_perturbations, time_limit) = (Some(max_perturbations), Duration::from_secs(100_000));
        in_corner_for(RobustnessTarget { max_perturbations, time_limit, ..RobustnessTarget::default() }, |refiner| {
            let task = refiner.problem.task();
            let push = Reference::straight(&task.start, &task.goal, task.horizon);
            refiner.judge_first(refiner.of_scene(), push).unwrap();
            let robust = refiner.best.clone().unwrap();
            assert!(robust.reached, "{}", robust.rates.overall());
            let accurate = Evaluator::new(&refiner.problem.world(), &[0.0], Success { position, ..Success::default() });
            let worlds = [accurate.clone(), accurate];
            refiner.refine_in(&worlds, robust, refiner.schedule.end()).unwrap();
            (refiner.take_best().unwrap(), refiner.rounds.clone())
        })
    }

    #[test]
    fn what_becomes_better_in_a_harder_world_and_stays_robust_is_kept() {
        let (kept, rounds) = kept_after(200, 1e-3);
        assert!(kept.reached && kept.changes > 0 && kept.solved.marks.has_margins, "{}", kept.solved.planned());
        let round = &rounds[kept.round - 1];
        assert_eq!((round.planned.as_str(), round.rate), (kept.solved.planned().as_str(), Some(kept.rates.overall())));
    }

    #[test]
    fn a_plan_that_is_robust_in_a_harder_world_too_stays() {
        let (kept, rounds) = kept_after(200, 0.1);
        assert_eq!((kept.reached, kept.changes, kept.round, rounds.len()), (true, 0, 1, 1));
    }

    #[test]
    fn a_plan_stays_where_no_change_is_tried() {
        let (kept, rounds) = kept_after(0, 1e-9);
        assert_eq!((kept.reached, kept.changes, kept.round, rounds.len()), (true, 0, 1, 1));
    }
}

//! Many drafts instead of one plan.
//!
//! A rollout of an arm takes several times as long as one of a free body, so that refinement tries few changes, and it
//! matters where it begins. How many test cases plans pass before they are refined differs tenfold with weights and offsets,
//! and which of them are good differs from scene to scene: so several are made, each by one thread, and compared.

use std::time::Duration;

use fastrand::Rng;
use plan::{Event, HomotopyRun, PlannerError, RobustParameters, Variant};
use simulation::Reference;
use workers::Workers;

use crate::Refiner;
use crate::candidate::Candidate;
use crate::draft::Draft;
use crate::origin::{Origin, Solved};
use crate::schedule::Deadline;

impl<'run> Refiner<'run> {
    /// Refines the plan of the scene, which took `solving`, or the best of drafts where that fails in fewer test cases.
    pub(super) fn refine_better(&mut self, own: Candidate<'run>, solving: Duration) -> Result<(), PlannerError> {
        let is_lost = own.refinement.failing_fraction() > self.target.parameters.drafts.lost;
        let until = self.schedule.drafts(solving).filter(|_| self.problem.arm().is_some() && is_lost);
        if let Some(until) = until {
            self.session.tell(Event::Variant { name: "drafts", number: 1, count: 1 });
            self.drafts = self.solve_drafts(until)?;
            self.session.tell(Event::VariantSolved { status: &format!("{} drafts", self.drafts.len()) });
        }
        match self.best_draft() {
            Some(draft) if draft.refinement.failing_fraction() < own.refinement.failing_fraction() => {
                self.rounds.push(own.round);
                self.refine_promising(draft, &mut None)
            }
            mut second @ Some(_) => {
                self.refine_promising(own, &mut second)?;
                self.rounds.extend(second.map(|draft| draft.round));
                Ok(())
            }
            None => self.refine(own, self.schedule.own(), 0.0),
        }
    }

    /// Refines a plan, or the `second` instead if its first evaluation says that it will get stuck, then the best of the other
    /// drafts, and so on; where all of them do, the best goes on. Leaves a second one that was not needed.
    fn refine_promising(
        &mut self,
        first: Candidate<'run>,
        second: &mut Option<Candidate<'run>>,
    ) -> Result<(), PlannerError> {
        let (trying, promising) = (self.schedule.other_drafts(), self.target.parameters.drafts.promising);
        let mut next = Some(first);
        while let Some(candidate) = next {
            self.refine(candidate, self.schedule.own(), promising)?;
            let is_promising = self.best.as_ref().is_some_and(|best| best.rates.overall() >= promising);
            if is_promising {
                return Ok(());
            }
            next = if self.goes_on(trying) { second.take().or_else(|| self.best_draft()) } else { None };
        }
        self.refine_best(self.schedule.own())
    }

    /// Takes out the draft with the best reference. `None` without drafts or time.
    fn best_draft(&mut self) -> Option<Candidate<'run>> {
        let mut places = Vec::new();
        let mut references: Vec<Reference> = Vec::new();
        for (draft, solved) in self.drafts.iter().enumerate() {
            let fine = solved.with_all_steps();
            let last = &fine[fine.len().saturating_sub(self.target.parameters.drafts.last)..];
            places.extend(last.iter().map(|&index| (draft, index)));
            references.extend(last.iter().map(|&index| Reference::from(&solved.iterations[index].trajectory)));
        }
        let best = self.best_of(&references, self.schedule.end())?;
        let (draft, index) = places[best.winner.index];
        let solved = Solved { chosen: index + 1, ..self.drafts.swap_remove(draft) };
        let candidate = self.candidate_of(best, solved);
        let (failing, cases) = (candidate.round.training_failures, candidate.round.training_cases);
        self.session.tell(Event::VariantTried { failing, cases });
        Some(candidate)
    }

    /// Solves drafts until a time, each with one thread. Of one that is interrupted, the homotopy steps count that it
    /// has finished; those that have none with all steps are left out.
    fn solve_drafts(&self, until: Deadline) -> Result<Vec<Solved>, PlannerError> {
        let scene = Variant::of_scene(self.problem);
        let RobustParameters { drafts: parameters, seeds, .. } = &self.target.parameters;
        let mut random = Rng::with_seed(seeds.first);
        let friction = self.target.largest_friction();
        let drafts = (0..parameters.most).map(|_| Draft::random(&mut random, friction, parameters));
        let solve = |draft: Draft| {
            let variant = draft.variant(&scene, parameters);
            let is_over = || self.schedule.is_over(until);
            let iterations = match is_over() {
                true => Vec::new(),
                false => HomotopyRun::new(&variant).finished(self.session, is_over)?,
            };
            Ok(Solved::new(Origin::Draft(draft), variant, iterations))
        };
        let solved = Workers::new(self.session.threads).map(drafts.into_iter(), solve);
        let solved: Result<Vec<Solved>, PlannerError> = solved.into_iter().collect();
        Ok(solved?.into_iter().filter(|draft| !draft.with_all_steps().is_empty()).collect())
    }
}

#[cfg(test)]
mod tests {
    use plan::parameters::DraftParameters;
    use task::{Horizon, at_rest};

    use super::*;
    use crate::tests::in_corner;

    #[test]
    fn of_a_draft_only_what_has_all_steps_is_played() {
        in_corner(Duration::from_secs(1000), |refiner| {
            let mut draft = Variant::of_scene(refiner.problem);
            let Horizon { steps, time_step } = draft.task.horizon;
            draft.task.horizon = Horizon { steps: 60, time_step: time_step * steps as f64 / 60.0 };
            draft.settings.coarse_iterations = 3;
            let iterations = HomotopyRun::new(&draft).finished(refiner.session, || false).unwrap();
            let solved = |count: usize| Solved::new(Origin::Scene, draft.clone(), iterations[..count].to_vec());
            refiner.drafts = vec![solved(3)];
            assert!(refiner.best_draft().is_none(), "all have half of the steps");
            refiner.drafts = vec![solved(4)];
            assert_eq!(refiner.best_draft().unwrap().round.chosen_stage, 4);
        });
    }

    #[test]
    fn where_the_first_evaluation_is_poor_a_draft_takes_the_place_of_the_plan() {
        in_corner(Duration::from_secs(1000), |refiner| {
            let scene = Variant::of_scene(refiner.problem);
            let solved = HomotopyRun::new(&scene).finished(refiner.session, || false).unwrap();
            let draft = Draft::random(&mut Rng::with_seed(1), 0.0, &DraftParameters::default());
            refiner.drafts = vec![Solved::new(Origin::Draft(draft), scene.clone(), solved)];
            let resting = Reference::new(0.1, &[at_rest(&refiner.problem.task().start); 3]);
            let best = refiner.best_of(&[resting], refiner.schedule.end()).unwrap();
            let own = refiner.candidate_of(best, refiner.of_scene());
            refiner.refine_promising(own, &mut None).unwrap();
            let rounds: Vec<(&str, Option<f64>)> =
                refiner.rounds.iter().map(|round| (round.planned.as_str(), round.rate)).collect();
            assert_eq!(rounds[0], ("the scene as it is", Some(0.0)));
            assert!(
                rounds[1].0.starts_with("draft with") && rounds[1].1 > Some(DraftParameters::default().promising),
                "{rounds:?}"
            );
            assert_eq!(refiner.best.as_ref().unwrap().round, 2);
        });
    }
}

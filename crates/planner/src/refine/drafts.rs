//! Many drafts instead of one plan.
//!
//! A rollout of an arm takes several times as long as one of a free body, so that refinement tries few changes, and it
//! matters where it begins. How many trials plans pass before they are refined differs tenfold with weights and offsets,
//! and which of them are good differs from scene to scene: so several are made, each by one thread, and compared.

use std::time::Duration;

use fastrand::Rng;
use nlp::{Control, SolveStatus};
use simulation::Reference;
use workers::Workers;

use crate::error::PlannerError;
use crate::iteration::PlanIteration;
use crate::refine::candidate::{self, Candidate};
use crate::refine::clock::Deadline;
use crate::refine::draft::Draft;
use crate::refine::{OWN_SHARE, Refiner, SEED};
use crate::session::Event;
use crate::solve::run_homotopy;
use crate::variant::Variant;

/// Fraction of the training trials in which the plan of the scene must fail.
const LOST: f64 = 0.5;
/// Share of the time that is left for drafts.
const SHARE: f64 = 0.3;
/// So many of the last homotopy iterations of a draft are tried: earlier ones hardly ever win.
const LAST: usize = 2;
/// Largest number of drafts: more would take more time to compare than to make.
const MOST: usize = 24;

impl<'run> Refiner<'run> {
    /// Refines the plan of the scene, which took `solving`, or the best of drafts where that fails in fewer trials.
    pub(super) fn refine_better(&mut self, own: Candidate<'run>, solving: Duration) -> Result<(), PlannerError> {
        let is_wanted = self.problem.arm().is_some()
            && own.refinement.failing_fraction() > LOST
            && solving < self.clock.left().mul_f64(SHARE);
        if is_wanted {
            self.session.tell(Event::Variant { name: "drafts", number: 1, count: 1 });
            self.drafts = self.solve_drafts(self.clock.share(self.clock.end(), SHARE))?;
            self.session.tell(Event::VariantSolved { status: &format!("{} drafts", self.drafts.len()) });
        }
        let draft = self.best_draft();
        let until = self.clock.share(self.clock.end(), OWN_SHARE);
        match draft {
            Some(draft) if draft.refinement.failing_fraction() < own.refinement.failing_fraction() => {
                self.rounds.push(own.round);
                self.refine(draft, until)
            }
            Some(draft) => {
                self.refine(own, until)?;
                self.rounds.push(draft.round);
                Ok(())
            }
            None => self.refine(own, until),
        }
    }

    /// Refines the best of the other drafts, if the best plan so far fails too often to be refined further. Where refinement ends
    /// is a matter of luck, but one that gets stuck does so early.
    pub(super) fn refine_other_draft(&mut self) -> Result<(), PlannerError> {
        let end = self.clock.end();
        if self.is_nearly_robust() || !self.goes_on(end) {
            return Ok(());
        }
        let Some(draft) = self.best_draft() else { return Ok(()) };
        self.refine(draft, self.clock.share(end, OWN_SHARE))
    }

    /// Takes out the draft with the best reference. `None` without drafts or time.
    fn best_draft(&mut self) -> Option<Candidate<'run>> {
        let mut places = Vec::new();
        let mut references: Vec<Reference> = Vec::new();
        for (draft, (_, iterations)) in self.drafts.iter().enumerate() {
            let first = iterations.len().saturating_sub(LAST);
            places.extend((first..iterations.len()).map(|index| (draft, index)));
            references.extend(iterations[first..].iter().map(|iteration| candidate::reference(&iteration.trajectory)));
        }
        let best = self.best_of(&references, self.clock.end())?;
        let (draft, index) = places[best.winner.index];
        let (variant, iterations) = self.drafts.swap_remove(draft);
        let candidate = self.candidate_of(best, variant, (iterations, index + 1), false);
        let (failing, trials) = (candidate.round.training_failures, candidate.round.training_trials);
        self.session.tell(Event::VariantTried { failing, trials });
        Some(candidate)
    }

    /// Solves drafts until a time, each with one thread. Of one that is interrupted, the homotopy iterations count that it
    /// has finished; those that have none are left out.
    fn solve_drafts(&self, until: Deadline) -> Result<Vec<(Variant, Vec<PlanIteration>)>, PlannerError> {
        let scene = Variant::of_scene(self.problem);
        let mut random = Rng::with_seed(SEED);
        let friction = self.target.largest_friction();
        let drafts = (0..MOST).map(|_| Draft::random(&mut random, friction).variant(&scene));
        let solve = |variant: Variant| {
            let is_over = || self.clock.is_over(until);
            let observe = |_: &ocp::Event| if is_over() { Control::Stop } else { Control::Continue };
            let iterations = match is_over() {
                true => Vec::new(),
                false => run_homotopy(&variant, 1, &[], None, observe, |_, _| Control::Continue)?,
            };
            let finished = iterations.iter().filter(|iteration| iteration.status != SolveStatus::Interrupted);
            Ok((variant, finished.map(PlanIteration::from).collect()))
        };
        let solved = Workers::new(self.session.threads).map(drafts.into_iter(), solve);
        let solved: Result<Vec<(Variant, Vec<PlanIteration>)>, PlannerError> = solved.into_iter().collect();
        Ok(solved?.into_iter().filter(|(_, iterations)| !iterations.is_empty()).collect())
    }
}

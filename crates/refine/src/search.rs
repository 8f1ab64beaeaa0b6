//! The state of a refinement: its parts, and questions that all of its stages ask.

use plan::Event;
use simulation::Reference;

use crate::candidate::Candidate;
use crate::evaluation::{Judgement, Wanted};
use crate::found::Found;
use crate::judge::Judge;
use crate::origin::Solved;
use crate::schedule::{Deadline, Schedule};
use crate::setting::Setting;
use crate::training::Training;

/// The state of a refinement.
pub struct Search<'run> {
    pub setting: Setting<'run>,
    pub schedule: Schedule<'run>,
    pub judge: Judge<'run>,
    pub training: Training<'run>,
    pub found: Found,
}

impl<'run> Search<'run> {
    /// Before its first reference.
    pub fn new(setting: Setting<'run>) -> Self {
        let Setting { target, session, .. } = setting;
        Self {
            setting,
            schedule: Schedule::new(session, target.time_limit, target.parameters.time),
            judge: Judge::new(setting),
            training: Training::new(setting),
            found: Found::nothing(),
        }
    }

    /// Whether there is something to do and time to do it.
    pub fn goes_on(&self, until: Deadline) -> bool {
        !self.found.is_robust() && self.training.may_perturb() && !self.schedule.is_over(until)
    }

    /// Whether the best plan so far fails seldom.
    pub fn is_nearly_robust(&self) -> bool {
        self.found.best.is_some() && self.found.rate() >= self.setting.target.parameters.training.nearly_robust
    }

    /// Evaluates a reference at new grasp errors.
    pub fn judge(&mut self, reference: &Reference, until: Deadline) -> Judgement {
        self.judge_as(reference, Wanted::target(self.setting.target), until)
    }

    /// The same with other rates than the target.
    pub fn judge_as(&mut self, reference: &Reference, wanted: Wanted, until: Deadline) -> Judgement {
        self.judge.judge(reference, wanted, &|| self.schedule.is_over(until))
    }

    /// Tells the success rate of a refined reference, if any rollout has shown it.
    pub fn tell_refined(&self, judgement: &Judgement) {
        if judgement.rates.rollouts() > 0 {
            self.setting.session.tell(Event::Refined { rate: judgement.rates.overall() });
        }
    }

    /// The candidate of a solved problem: the homotopy step whose reference passes most of the training set, among those with
    /// all time steps, or all steps if none has. A tie goes to the later step, which is smoothed less. `None` if no step or no time
    /// is left.
    pub fn candidate(&self, solved: Solved, until: Deadline) -> Option<Candidate<'run>> {
        let refinable = solved.refinable();
        let references: Vec<Reference> = refinable.iter().map(|&index| solved.reference(index)).collect();
        let best = self.training.best_of(&references, &|| self.schedule.is_over(until))?;
        let chosen = refinable[best.winner.index] + 1;
        Some(self.training.candidate(best, Solved { chosen, ..solved }))
    }
}

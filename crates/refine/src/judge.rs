//! Evaluations, each with test cases of its own.

use simulation::Reference;

use crate::evaluation::{Drawn, ErrorRange, Evaluation, Judgement, Wanted};
use crate::setting::Setting;

/// Draws evaluations and judges references by them.
pub struct Judge<'run> {
    setting: Setting<'run>,
    range: ErrorRange,
    /// Evaluations so far: the next one has other random numbers.
    pub evaluations: u64,
}

impl<'run> Judge<'run> {
    /// Before the first evaluation.
    pub fn new(setting: Setting<'run>) -> Self {
        let range = ErrorRange::new(setting.problem, setting.target);
        Self { setting, range, evaluations: 0 }
    }

    /// Evaluates a reference at new grasp errors, until that is decided or `stop` returns true.
    pub fn judge(&mut self, reference: &Reference, wanted: Wanted, stop: &(dyn Fn() -> bool + Sync)) -> Judgement {
        let Setting { target, evaluator, .. } = self.setting;
        let evaluation = self.new_evaluation(target.parameters.evaluation.random);
        evaluation.judge(evaluator, reference, wanted, stop)
    }

    /// At most `count` random grasp errors per friction and magnitude, not played yet.
    pub fn new_evaluation(&mut self, count: usize) -> Evaluation {
        self.evaluations += 1;
        self.evaluation(Drawn { random: count, seed: self.seed() })
    }

    /// An evaluation that was drawn before, once more.
    pub fn evaluation(&self, Drawn { random, seed }: Drawn) -> Evaluation {
        Evaluation::new(self.setting.problem.task(), &self.range, &self.setting.target.frictions, random, seed)
    }

    /// Seed of the latest evaluation.
    pub fn seed(&self) -> u64 {
        let seeds = self.setting.target.parameters.seeds;
        seeds.first + seeds.stride * self.evaluations
    }
}

//! Refinement of a reference by rollouts: random smooth changes, of which those stay that let more trials pass.
//!
//! A contact that holds in the planner's smoothed and relaxed physics may slip when it is hard, and the derivatives of the
//! plan do not know it. A rollout takes milliseconds, and a few of them show that a change is of no use.

use fastrand::Rng;

use crate::bump::Bump;
use crate::examiner::{Examiner, Trial, Verdict};
use crate::reference::Reference;

/// A reference that is being refined.
pub struct Refinement<'examiner> {
    examiner: &'examiner Examiner,
    random: Rng,
    reference: Reference,
    trials: Vec<Trial>,
    verdicts: Vec<Verdict>,
}

/// Trials played side by side, whatever the number of threads, so that this number changes nothing. When a change brings
/// none of the first ones closer, it is dropped.
const BATCH: usize = 6;

impl<'examiner> Refinement<'examiner> {
    /// Judges a reference in its trials, on `jobs` threads.
    pub fn new(
        examiner: &'examiner Examiner,
        reference: Reference,
        trials: Vec<Trial>,
        seed: u64,
        jobs: usize,
    ) -> Self {
        let verdicts = examiner.judge_all(&reference, &trials, jobs);
        Self { examiner, random: Rng::with_seed(seed), reference, trials, verdicts }
    }

    /// The best reference so far.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// All trials.
    pub fn trials(&self) -> &[Trial] {
        &self.trials
    }

    /// Adds trials.
    pub fn add(&mut self, trials: &[Trial]) {
        self.trials.extend(trials);
        self.verdicts.extend(trials.iter().map(|trial| self.examiner.judge(&self.reference, trial)));
    }

    /// Tries a random change on `jobs` threads and keeps it if it is an improvement; whether it is one. Failing trials
    /// come first, then those that must not be lost, both in random order, and only as many as it takes to see that the
    /// change is no improvement. When `stop` says so, or when it breaks a limit, it counts as none.
    pub fn improve(&mut self, jobs: usize, stop: &dyn Fn() -> bool) -> bool {
        let reference = self.reference.bent(&Bump::random(&mut self.random, self.examiner.success()));
        if !self.examiner.allows(&reference) {
            return false;
        }
        let mut verdicts = self.verdicts.clone();
        let (failing, passing) = self.shuffled();
        // Change of the sum of misses, and of the number of failing trials.
        let (mut miss, mut count) = (0.0, 0_isize);
        let batches = failing.chunks(BATCH).chain(passing.chunks(BATCH));
        let only_losses_follow = failing.len().div_ceil(BATCH);
        for (played, batch) in (1..).zip(batches) {
            if stop() {
                return false;
            }
            let trials: Vec<Trial> = batch.iter().map(|&index| self.trials[index]).collect();
            for (&index, new) in batch.iter().zip(self.examiner.judge_all(&reference, &trials, jobs)) {
                let old = std::mem::replace(&mut verdicts[index], new);
                miss += new.miss - old.miss;
                count += isize::from(old.passed) - isize::from(new.passed);
            }
            let is_vain = played == 1 && miss >= 0.0;
            if is_vain || played >= only_losses_follow && (count > 0 || count == 0 && miss >= 0.0) {
                return false;
            }
        }
        (self.reference, self.verdicts) = (reference, verdicts);
        true
    }

    /// Indices of failing and of passing trials, in random order.
    fn shuffled(&mut self) -> (Vec<usize>, Vec<usize>) {
        let (mut failing, mut passing): (Vec<usize>, Vec<usize>) =
            (0..self.trials.len()).partition(|&index| !self.verdicts[index].passed);
        self.random.shuffle(&mut failing);
        self.random.shuffle(&mut passing);
        (failing, passing)
    }

    /// Number of failing trials and the sum of their misses: less is better, the number first.
    pub fn score(&self) -> (usize, f64) {
        let failing = self.verdicts.iter().filter(|verdict| !verdict.passed);
        (failing.clone().count(), failing.map(|verdict| verdict.miss).sum())
    }
}

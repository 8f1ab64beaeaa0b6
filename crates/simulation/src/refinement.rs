//! Refinement of a reference by rollouts: random smooth changes, of which those stay that let more trials pass.
//!
//! Between two smoothings of the planner lie contacts that hold there and slip with hard contact. No derivative knows of
//! them, but a rollout takes milliseconds, and most changes of the reference that are of no use are found out after a few.

use fastrand::Rng;

use crate::bump::Bump;
use crate::examiner::{Examiner, Trial, Verdict, in_parallel};
use crate::reference::Reference;

/// A reference that is being refined.
pub struct Refinement<'examiner> {
    examiner: &'examiner Examiner,
    random: Rng,
    reference: Reference,
    trials: Vec<Trial>,
    verdicts: Vec<Verdict>,
}

/// Changes that are tried side by side, whatever the number of threads, so that this number changes nothing.
const CANDIDATES: usize = 4;
/// Failing trials after which a change that has brought none of them closer is dropped.
const PROBE: usize = 6;

/// A changed reference and how it does in all trials.
struct Candidate {
    reference: Reference,
    verdicts: Vec<Verdict>,
}

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

    /// Number of failing trials and the sum of their misses: less is better, the number first.
    pub fn score(&self) -> (usize, f64) {
        score(&self.verdicts)
    }

    /// Adds trials.
    pub fn add(&mut self, trials: &[Trial]) {
        self.trials.extend(trials);
        self.verdicts.extend(trials.iter().map(|trial| self.examiner.judge(&self.reference, trial)));
    }

    /// Tries several random changes on `jobs` threads and keeps the best one that is an improvement; whether there is
    /// one. Ends early, without one, when `stop` says so.
    pub fn improve(&mut self, jobs: usize, stop: &(dyn Fn() -> bool + Sync)) -> bool {
        let success = *self.examiner.success();
        let tries: Vec<(Bump, u64)> =
            (0..CANDIDATES).map(|_| (Bump::random(&mut self.random, &success), self.random.u64(..))).collect();
        let candidates = in_parallel(CANDIDATES, jobs, |index| {
            let (bump, seed) = &tries[index];
            self.attempt(bump, Rng::with_seed(*seed), stop)
        });
        let best = candidates.into_iter().flatten().min_by(|one, other| {
            let ((count, miss), (other_count, other_miss)) = (score(&one.verdicts), score(&other.verdicts));
            count.cmp(&other_count).then(miss.total_cmp(&other_miss))
        });
        let Some(Candidate { reference, verdicts }) = best else { return false };
        (self.reference, self.verdicts) = (reference, verdicts);
        true
    }

    /// The changed reference if it is better. Failing trials come first, then those that must not be lost, both in random
    /// order, and only as many as it takes to see that it is no better.
    fn attempt(&self, bump: &Bump, mut random: Rng, stop: &(dyn Fn() -> bool + Sync)) -> Option<Candidate> {
        let reference = self.reference.bent(bump);
        let mut verdicts = self.verdicts.clone();
        let (mut failing, mut passing): (Vec<usize>, Vec<usize>) =
            (0..self.trials.len()).partition(|&index| !self.verdicts[index].passed);
        random.shuffle(&mut failing);
        random.shuffle(&mut passing);
        // Change of the sum of misses, and of the number of failing trials.
        let (mut miss, mut count) = (0.0, 0_isize);
        for (played, index) in failing.iter().chain(&passing).copied().enumerate() {
            if stop() {
                return None;
            }
            let (old, new) = (self.verdicts[index], self.examiner.judge(&reference, &self.trials[index]));
            verdicts[index] = new;
            miss += new.miss - old.miss;
            count += isize::from(old.passed) - isize::from(new.passed);
            let probed = played + 1 == PROBE.min(failing.len());
            let only_losses_follow = played + 1 >= failing.len();
            if probed && miss >= 0.0 || only_losses_follow && (count > 0 || count == 0 && miss >= 0.0) {
                return None;
            }
        }
        Some(Candidate { reference, verdicts })
    }
}

fn score(verdicts: &[Verdict]) -> (usize, f64) {
    let failing = verdicts.iter().filter(|verdict| !verdict.passed);
    (failing.clone().count(), failing.map(|verdict| verdict.miss).sum())
}

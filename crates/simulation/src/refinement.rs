//! Refinement of a reference by rollouts: random smooth perturbations are tried, and those with which more test cases
//! pass are kept. Some lead back from where a failing test case pushes too hard, some lead towards its goal, some
//! resemble perturbations that have helped before.
//!
//! A contact that holds in the planner's smoothed and relaxed physics may slip when it is hard, and the derivatives of
//! the planner do not show it. A rollout takes milliseconds, and a few rollouts tell whether a perturbation is useless.

mod simplify;

use std::cmp::Reverse;

use fastrand::Rng;

use crate::bounds::Bounds;
use crate::evaluator::{Evaluator, Record, TestCase, TestResult};
use crate::perturbation::Perturbation;
use crate::reference::Reference;

/// A reference that is being refined.
pub struct Refinement<'evaluator> {
    evaluator: &'evaluator Evaluator,
    bounds: Bounds,
    /// Range of an arm's joints (rad or m) that perturbations must leave; `None` if the first reference leaves none.
    room: Option<f64>,
    random: Rng,
    reference: Reference,
    cases: Vec<TestCase>,
    /// Records of the reference, one per test case.
    records: Vec<Record<'evaluator>>,
    /// Number of perturbations that each test case has rejected after it had passed before.
    refusals: Vec<usize>,
    rollouts: usize,
    /// The last perturbations that helped.
    helped: Vec<Perturbation>,
}

/// Number of failing test cases that are played first. A perturbation is dropped if the sum of their violations does
/// not decrease.
const FIRST: usize = 4;
/// Fraction of perturbations that lead away from where a failing test case exceeds the limit of contact forces.
const RELIEVING: f64 = 0.3;
/// Fraction of the others that lead towards the goal of a failing test case.
const AIMED: f64 = 0.3;
/// A body is nearly at its goal within this multiple of the position tolerance; fraction of its perturbations that go
/// beyond the goal and back.
const NEAR: f64 = 4.0;
const TOO_FAR: f64 = 0.5;
/// Fraction of the other perturbations that lead along the contacts of bodies far from their goal.
const SLIDING: f64 = 0.5;
/// Fraction of the others that resemble earlier ones.
const LEARNED: f64 = 0.5;
/// Proposals per perturbation until one keeps the bounds, and halvings of each.
const PROPOSALS: usize = 20;
const HALVINGS: usize = 3;
/// Range of the joints (rad or m) that perturbations leave beside the reference: the arm departs from it by its errors.
const ROOM: f64 = 0.05;
/// Number of helpful perturbations that are remembered.
const REMEMBERED: usize = 6;

impl<'evaluator> Refinement<'evaluator> {
    /// Starts from a reference whose results in the test cases are known, in the order of the test cases.
    ///
    /// # Panics
    /// When there are not as many results as test cases.
    pub fn new(
        evaluator: &'evaluator Evaluator,
        reference: Reference,
        cases: Vec<TestCase>,
        results: Vec<TestResult>,
        seed: u64,
    ) -> Self {
        assert_eq!(cases.len(), results.len(), "every case has a result");
        let bounds = evaluator.bounds().including(&reference);
        let room = evaluator.room(&reference).map(|room| room.min(ROOM));
        let random = Rng::with_seed(seed);
        let records = results.into_iter().map(Record::from).collect();
        let refusals = vec![0; cases.len()];
        Self { evaluator, bounds, room, random, reference, cases, records, refusals, rollouts: 0, helped: Vec::new() }
    }

    /// The best reference so far.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// All test cases.
    pub fn cases(&self) -> &[TestCase] {
        &self.cases
    }

    /// Rollouts so far.
    pub fn rollouts(&self) -> usize {
        self.rollouts
    }

    /// Adds test cases with the results of the best reference.
    pub fn add(&mut self, cases: impl IntoIterator<Item = (TestCase, TestResult)>) {
        for (case, result) in cases {
            self.cases.push(case);
            self.records.push(result.into());
            self.refusals.push(0);
        }
    }

    /// Fraction of the test cases that fail.
    pub fn failing_fraction(&self) -> f64 {
        self.score().0 as f64 / self.cases.len().max(1) as f64
    }

    /// Tries a random perturbation, keeps it if it improves the [`score`](Self::score), and returns whether it does.
    /// Failing test cases are simulated first, then the passing ones, each in random order, until it is clear that the
    /// perturbation is no improvement. A perturbation that leaves the bounds is dropped, and so is the current one when
    /// `stop` returns true.
    pub fn improve(&mut self, stop: &(dyn Fn() -> bool + Sync)) -> bool {
        self.record_failing(stop);
        let Some((perturbation, reference)) = self.propose() else { return false };
        let is_better = self.attempt(reference, stop);
        if is_better {
            self.helped.push(perturbation);
            self.helped.drain(..self.helped.len().saturating_sub(REMEMBERED));
        }
        is_better
    }

    /// Plays failing test cases of which only results are known again, for snapshots: every attempt plays them.
    fn record_failing(&mut self, stop: &(dyn Fn() -> bool + Sync)) {
        let is_unknown = |&index: &usize| !self.records[index].result.passed && !self.records[index].has_snapshots();
        let unknown: Vec<usize> = (0..self.cases.len()).filter(is_unknown).collect();
        let reference = self.reference.clone();
        if let Some(new) = self.play(&reference, &unknown, stop, |_| true) {
            unknown.into_iter().zip(new).for_each(|(index, new)| self.records[index] = new);
        }
    }

    /// Plays some of the test cases with a reference while `keep_going` returns true for their results. `None` when it
    /// does not, or `stop` returned true.
    fn play(
        &mut self,
        reference: &Reference,
        indices: &[usize],
        stop: &(dyn Fn() -> bool + Sync),
        mut keep_going: impl FnMut(&TestResult) -> bool,
    ) -> Option<Vec<Record<'evaluator>>> {
        let cases = indices.iter().map(|&index| (self.cases[index], &self.records[index]));
        let same = self.reference.shared_intervals(reference);
        let mut rollouts = 0;
        let new = self.evaluator.record_all(reference, cases, same, stop, |result| {
            rollouts += 1;
            keep_going(result)
        });
        self.rollouts += rollouts;
        new
    }

    /// A perturbation, halved until it keeps the bounds, and the perturbed reference. `None` where none was found.
    fn propose(&mut self) -> Option<(Perturbation, Reference)> {
        for _ in 0..PROPOSALS {
            let mut perturbation = self.random_perturbation();
            for _ in 0..=HALVINGS {
                let reference = self.reference.perturbed(&perturbation);
                if self.bounds.allow(&reference) && self.has_room(&reference) {
                    return Some((perturbation, reference));
                }
                perturbation = perturbation.scaled(0.5);
            }
        }
        None
    }

    /// Whether an arm can follow a reference nearly as well as the first one.
    fn has_room(&self, reference: &Reference) -> bool {
        self.room.is_none_or(|least| self.evaluator.room(reference).is_some_and(|room| room >= least))
    }

    /// A random perturbation, one away from where a failing test case pushes too hard, one towards its goal, or one
    /// that resembles a perturbation which has helped.
    fn random_perturbation(&mut self) -> Perturbation {
        if self.evaluator.limits_contact_forces()
            && self.random.f64() < RELIEVING
            && let Some(TestResult { overshoot: Some(overshoot), .. }) = self.some_failing()
        {
            return Perturbation::relief(&mut self.random, &overshoot);
        }
        let new = Perturbation::random(&mut self.random, self.evaluator.success());
        if self.random.f64() < AIMED
            && let Some(TestResult { remaining_shift, unblocked_shift, remaining_rotation, .. }) = self.some_failing()
        {
            // Dry friction holds a body short of the goal: going beyond it and back again takes the body there.
            let is_near = remaining_shift.norm() < NEAR * self.evaluator.success().position;
            let goes_too_far = is_near && self.random.f64() < TOO_FAR;
            let new = if goes_too_far { Perturbation::late(&mut self.random, self.evaluator.success()) } else { new };
            // A body that contacts hold far from its goal should slide on them.
            let slides = !is_near && self.random.f64() < SLIDING;
            let remaining_shift = if slides { unblocked_shift } else { remaining_shift };
            return new.aimed(&remaining_shift, &remaining_rotation, &mut self.random);
        }
        if self.helped.is_empty() || self.random.f64() >= LEARNED {
            return new;
        }
        let helpful = self.helped[self.random.usize(..self.helped.len())];
        helpful.varied(&new, &mut self.random)
    }

    /// The result of any test case that fails.
    fn some_failing(&mut self) -> Option<TestResult> {
        let failing: Vec<TestResult> = self.results().filter(|result| !result.passed).copied().collect();
        (!failing.is_empty()).then(|| failing[self.random.usize(..failing.len())])
    }

    /// Accepts a reference if it is better than the best so far.
    fn attempt(&mut self, reference: Reference, stop: &(dyn Fn() -> bool + Sync)) -> bool {
        let (failing, mut passing) = self.shuffled();
        // The order does not affect the result: a perturbation must not lose any of these without a gain elsewhere.
        passing.sort_by_key(|&index| Reverse(self.refusals[index]));
        let violation_of =
            |indices: &[usize]| indices.iter().map(|&index| self.records[index].result.violation).sum::<f64>();
        let (first, before) = (FIRST.min(failing.len()), (failing.len(), violation_of(&failing)));
        let violation_of_first = violation_of(&failing[..first]);
        let order = [failing, passing].concat();
        // Test cases so far, and failing ones with the sum of their violations. Both grow with the number played.
        let (mut played, mut now) = (0, (0, 0.0));
        let new = self.play(&reference, &order, stop, |result| {
            played += 1;
            now = (now.0 + usize::from(!result.passed), now.1 + result.violation);
            let is_useless = played <= first && now.1 >= violation_of_first;
            let is_no_better = played >= before.0 && now >= before;
            !is_useless && !is_no_better
        });
        let Some(new) = new else {
            if played > before.0 {
                self.refusals[order[played - 1]] += 1;
            }
            return false;
        };
        self.reference = reference;
        order.into_iter().zip(new).for_each(|(index, new)| self.records[index] = new);
        true
    }

    /// Indices of failing and of passing test cases, in random order.
    fn shuffled(&mut self) -> (Vec<usize>, Vec<usize>) {
        let (mut failing, mut passing): (Vec<usize>, Vec<usize>) =
            (0..self.cases.len()).partition(|&index| !self.records[index].result.passed);
        self.random.shuffle(&mut failing);
        self.random.shuffle(&mut passing);
        (failing, passing)
    }

    fn results(&self) -> impl Iterator<Item = &TestResult> + Clone {
        self.records.iter().map(|record| &record.result)
    }

    /// Number of failing test cases and the sum of their violations. Fewer failing test cases are better, then a
    /// smaller sum.
    pub fn score(&self) -> (usize, f64) {
        let failing = self.results().filter(|result| !result.passed);
        (failing.clone().count(), failing.map(|result| result.violation).sum())
    }
}

//! Simpler references that succeed as often.
//!
//! Refinement keeps a random perturbation for the end of the motion, however it bends the rest: rotations and detours
//! in free air cost nothing, and oscillations remain after other perturbations have made them unnecessary. What no test
//! case needs is therefore taken back at the end, from the whole reference first, then from shorter and shorter parts
//! of it.

use std::collections::VecDeque;

use task::StraightMotion;

use crate::reference::Reference;
use crate::refinement::Refinement;

/// Shares of the departure from the straight motion that are taken back, until one is harmless.
const SHARES: [f64; 2] = [1.0, 0.5];
/// The shortest part of a reference that is straightened on its own, as a fraction of its duration.
const SHORTEST: f64 = 0.125;

impl Refinement<'_> {
    /// Drops all intervals after the first `intervals`, and pulls the reference toward a straight motion, each as far
    /// as every test case that passed still passes and no contact force of these exceeds the largest so far. Returns
    /// how many of these simplifications were kept. One during which `stop` returns true is not.
    pub fn simplify(&mut self, straight: &StraightMotion, intervals: usize, stop: &(dyn Fn() -> bool + Sync)) -> usize {
        let passed = self.results().filter(|result| result.passed);
        let largest_force = passed.map(|result| result.contact_force).fold(0.0, f64::max);
        let cut = self.reference.cut(intervals);
        let mut kept = usize::from(self.does_no_harm(cut, largest_force, stop));
        let mut parts = VecDeque::from([[0.0, 1.0]]);
        while let Some([from, to]) = parts.pop_front() {
            let share = SHARES.into_iter().find(|&share| {
                let straightened = self.reference.straightened(straight, [from, to], share);
                self.does_no_harm(straightened, largest_force, stop)
            });
            kept += usize::from(share.is_some());
            if share != Some(1.0) && to - from > SHORTEST {
                let middle = 0.5 * (from + to);
                parts.extend([[from, middle], [middle, to]]);
            }
        }
        kept
    }

    /// Accepts another reference if every test case that passed still passes, with no contact force beyond a limit (N).
    fn does_no_harm(&mut self, reference: Reference, limit: f64, stop: &(dyn Fn() -> bool + Sync)) -> bool {
        if reference == self.reference || !self.bounds.allow(&reference) || !self.has_room(&reference) {
            return false;
        }
        let (failing, mut passing) = self.shuffled();
        passing.sort_by_key(|&index| std::cmp::Reverse(self.refusals[index]));
        let (count, order) = (passing.len(), [passing, failing].concat());
        let mut played = 0;
        let new = self.play(&reference, &order, stop, |result| {
            played += 1;
            played > count || result.passed && result.contact_force <= limit
        });
        let Some(new) = new else {
            if let Some(&refused) = played.checked_sub(1).and_then(|last| order.get(last)) {
                self.refusals[refused] += 1;
            }
            return false;
        };
        self.reference = reference;
        order.into_iter().zip(new).for_each(|(index, new)| self.records[index] = new);
        true
    }
}

//! How many of the shortest steps are merged into one.

/// The length of steps. Where the velocity changes little, a step replaces 2, 4, 8, ... of the shortest ones. Impacts
/// change it much: they fall into the shortest steps.
#[derive(Debug, Clone, Copy)]
pub struct StepLength {
    /// The longest step to try replaces two to this power.
    longest: usize,
    /// Upper bound of `longest`.
    bound: usize,
    /// Largest change of velocity (m/s) in a longer step.
    largest_change: f64,
}

/// The shortest steps of a rollout, and which of them may be merged.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// Of the shortest steps (s).
    pub time_step: f64,
    /// Largest number that is merged into one.
    pub most: usize,
    /// A longer step changes the velocity of no point by more than this acceleration (m/s^2) does in the shortest step.
    pub steady: f64,
}

/// How far an interval between two knots is, in the shortest steps.
#[derive(Debug, Clone, Copy)]
pub struct Substeps {
    /// Number of those that are done, less than all.
    pub done: usize,
    /// Number of all.
    pub count: usize,
}

/// The default acceleration (m/s^2) up to which steps may be longer.
pub const STEADY: f64 = 1.0;

impl StepLength {
    /// For steps that replace at most two to the power of `bound` of the shortest ones.
    pub fn new(steps: &Steps, bound: usize) -> Self {
        Self { longest: 0, bound, largest_change: steps.steady * steps.time_step }
    }

    /// Largest change of velocity (m/s) in a longer step.
    pub fn largest_change(&self) -> f64 {
        self.largest_change
    }

    /// Takes a step, after some of the shortest steps of an interval. `advance` moves a copy of the state by
    /// two to some power of them, and returns the penetration (m) that the previous step has left, and the largest
    /// change of velocity (m/s) of any point. Returns how many steps were taken, and the penetration.
    pub fn step<S: Clone>(
        &mut self,
        state: &mut S,
        substeps: Substeps,
        mut advance: impl FnMut(&mut S, usize) -> (f64, f64),
    ) -> (usize, f64) {
        let (most, Substeps { done, count }) = (self.largest_change, substeps);
        let mut doublings = self.longest.min(done.trailing_zeros().min((count - done).ilog2()) as usize);
        loop {
            let mut next = state.clone();
            let (penetration, mut change) = advance(&mut next, doublings);
            if doublings == 0 || change <= most {
                if 2.0 * change <= most {
                    self.longest = self.longest.max(doublings + 1).min(self.bound);
                }
                *state = next;
                return (1 << doublings, penetration);
            }
            // Half of the step changes half as much.
            doublings -= 1;
            while doublings > 0 && 0.5 * change > most {
                (doublings, change) = (doublings - 1, 0.5 * change);
            }
            self.longest = doublings;
        }
    }
}

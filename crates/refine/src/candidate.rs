//! Plans on the way to a robust one.

use plan::{Round, SuccessRates};
use simulation::{Reference, Refinement, TestCase};

use crate::evaluation::{Drawn, Judgement};
use crate::origin::Solved;

/// A reference that is refined, and the problem it solves.
pub struct Candidate<'run> {
    pub solved: Solved,
    pub refinement: Refinement<'run>,
    pub round: Round,
}

/// The best plan so far, with its evaluation.
#[derive(Clone)]
pub struct Kept {
    pub solved: Solved,
    pub reference: Reference,
    pub rates: SuccessRates,
    /// Whether they are what is wanted, after a whole evaluation.
    pub reached: bool,
    /// The evaluation that they are of.
    pub evaluation: Drawn,
    /// Rollouts that this lacks because the time was over; 0 where it is decided.
    pub unplayed: usize,
    /// Test cases that it fails.
    pub failing: Vec<TestCase>,
    /// Number of its round, from 1.
    pub round: usize,
    /// Changes of its reference.
    pub changes: usize,
}

impl Kept {
    /// After another evaluation.
    pub fn judged(self, judgement: Judgement) -> Self {
        let failing = judgement.failing();
        let Judgement { rates, reached, evaluation, unplayed, .. } = judgement;
        Self { rates, reached, evaluation, unplayed, failing, ..self }
    }

    /// Whether it is better than another plan: robust before not, then by the rate of all rollouts.
    pub fn is_better_than(&self, other: &Self) -> bool {
        (self.reached, self.rates.overall()) > (other.reached, other.rates.overall())
    }
}

//! Candidates for a robust plan.

use plan::{Round, SuccessRates};
use simulation::{Reference, Refinement, TestCase, TestResult};

use crate::evaluation::{Drawn, Judgement};
use crate::origin::Solved;

/// A reference that is refined, and the problem it solves.
pub struct Candidate<'run> {
    pub solved: Solved,
    pub refinement: Refinement<'run>,
    pub round: Round,
}

/// A reference that was evaluated.
#[derive(Clone)]
pub struct Evaluated {
    pub solved: Solved,
    pub reference: Reference,
    pub rates: SuccessRates,
    /// Whether they reach the target, as an evaluation has shown.
    pub reached: bool,
    /// The evaluation that they are of.
    pub evaluation: Drawn,
    /// Rollouts that were not played for lack of time; 0 where it is decided.
    pub unplayed: usize,
    /// Test cases that it fails.
    pub failing: Vec<TestCase>,
    /// Number of its round, from 1.
    pub round: usize,
    /// Changes of its reference.
    pub perturbations: usize,
}

impl Evaluated {
    /// A reference of a round after a number of accepted perturbations, with the judgement of its evaluation.
    pub fn new(
        solved: Solved,
        reference: Reference,
        judgement: &Judgement,
        round: usize,
        perturbations: usize,
    ) -> Self {
        Self {
            solved,
            reference,
            rates: judgement.rates.clone(),
            reached: judgement.reached,
            evaluation: judgement.evaluation,
            unplayed: judgement.unplayed,
            failing: judgement.failing(),
            round,
            perturbations,
        }
    }

    /// After another evaluation.
    pub fn judged(self, judgement: &Judgement) -> Self {
        Self::new(self.solved, self.reference, judgement, self.round, self.perturbations)
    }

    /// Whether it is better than another plan: robust before not, then by the rate of all rollouts.
    pub fn is_better_than(&self, other: &Self) -> bool {
        (self.reached, self.rates.overall()) > (other.reached, other.rates.overall())
    }

    /// Whether the reference is longer than its plan's horizon.
    pub fn has_oscillation(&self) -> bool {
        self.reference.intervals() > self.solved.variant.task.horizon.steps
    }
}

/// A round whose homotopy has run and whose chosen reference is still to be refined; with its results in the training set.
pub fn round(solved: &Solved, results: &[TestResult]) -> Round {
    let Solved { variant, iterations, chosen, .. } = solved;
    Round::new(solved.planned(), variant, iterations, *chosen, results)
}

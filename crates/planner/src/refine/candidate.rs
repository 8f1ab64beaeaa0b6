//! Plans on the way to a robust one.

use simulation::{Evaluator, Reference, Refinement, Trial};
use task::Trajectory;

use crate::iteration::PlanIteration;
use crate::robustness::Round;
use crate::success_rates::SuccessRates;
use crate::variant::Variant;

/// A solved problem and the reference of it that is refined.
pub struct Candidate<'run> {
    pub variant: Variant,
    pub iterations: Vec<PlanIteration>,
    pub refinement: Refinement<'run>,
    pub round: Round,
    /// Whether its homotopy is that of the scene itself.
    pub is_scenes_own: bool,
}

/// The best plan so far, with its evaluation.
#[derive(Clone)]
pub struct Kept {
    pub variant: Variant,
    pub iterations: Vec<PlanIteration>,
    pub reference: Reference,
    pub rates: SuccessRates,
    /// Offsets (m) at which it fails there.
    pub failing: Vec<[f64; 3]>,
    /// Number of its round, from 1.
    pub round: usize,
    /// Whether its homotopy is that of the scene itself.
    pub is_scenes_own: bool,
}

/// How references are judged and changed.
#[derive(Clone, Copy)]
pub struct Training<'run> {
    pub evaluator: &'run Evaluator,
    pub seed: u64,
    pub threads: usize,
}

impl<'run> Training<'run> {
    /// The refinement of a reference in some trials.
    pub fn refinement(&self, reference: Reference, trials: &[Trial]) -> Refinement<'run> {
        Refinement::new(self.evaluator, reference, trials.to_vec(), self.seed, self.threads)
    }
}

impl<'run> Candidate<'run> {
    /// The homotopy iteration whose reference passes most trials; of equals the later, which is smoothed less.
    /// One of the iterations must have all steps.
    pub fn best_of(
        variant: Variant,
        iterations: Vec<PlanIteration>,
        training: Training<'run>,
        trials: &[Trial],
        is_scenes_own: bool,
    ) -> Self {
        let fine = iterations.iter().enumerate().filter(|(_, iteration)| !iteration.record.is_coarse(&variant.task));
        let refinements =
            fine.map(|(index, iteration)| (index, training.refinement(reference(&iteration.trajectory), trials)));
        let best = refinements.min_by(|(one_index, one), (other_index, other)| {
            one.score().0.cmp(&other.score().0).then(other_index.cmp(one_index))
        });
        let (index, refinement) = best.expect("a homotopy has an iteration");
        let round = Round::new(&variant, &iterations, index + 1, &refinement);
        Self { variant, iterations, refinement, round, is_scenes_own }
    }

    /// A plan that was refined before.
    pub fn resumed(kept: Kept, training: Training<'run>, trials: &[Trial]) -> Self {
        let Kept { mut variant, iterations, reference, is_scenes_own, .. } = kept;
        variant.name = format!("{}, resumed", variant.name);
        let refinement = training.refinement(reference, trials);
        let round = Round::new(&variant, &iterations, iterations.len(), &refinement);
        Self { variant, iterations, refinement, round, is_scenes_own }
    }
}

/// The reference of a motion.
pub fn reference(motion: &Trajectory) -> Reference {
    Reference::new(motion.time_step, &motion.reference)
}

//! Plans on the way to a robust one.

use ocp::HomotopyIteration;
use simulation::{Evaluator, Reference, Refinement, Trial};

use crate::robust::exam::Mark;
use crate::robust::portfolio::Variant;
use crate::robust::report::Round;

/// A solved problem and the reference of it that is refined.
pub struct Candidate<'run> {
    pub stages: Vec<HomotopyIteration>,
    pub refinement: Refinement<'run>,
    pub round: Round,
}

/// A plan with its exam.
pub struct Kept {
    pub stages: Vec<HomotopyIteration>,
    pub reference: Reference,
    pub marks: Vec<Mark>,
    /// Offsets (m) at which it fails there.
    pub failing: Vec<[f64; 3]>,
    /// Its place among the rounds.
    pub round: usize,
}

impl<'run> Candidate<'run> {
    /// The homotopy iteration whose reference passes most trials; of equals the later, which is smoothed less. `stages`
    /// must not be empty; `seed` is that of the refinement to come.
    pub fn new(
        variant: &Variant,
        stages: Vec<HomotopyIteration>,
        examiner: &'run Evaluator,
        training: &[Trial],
        (seed, jobs): (u64, usize),
    ) -> Self {
        let judged = stages.iter().map(|stage| Refinement::new(examiner, played(stage), training.to_vec(), seed, jobs));
        let best = judged.enumerate().min_by(|(one_stage, one), (other_stage, other)| {
            one.score().0.cmp(&other.score().0).then(other_stage.cmp(one_stage))
        });
        let (stage, refinement) = best.expect("a homotopy has an iteration");
        let round = Round::new(variant, &stages, stage + 1, &refinement);
        Self { stages, refinement, round }
    }
}

/// The reference of a homotopy iteration.
pub fn played(stage: &HomotopyIteration) -> Reference {
    Reference::new(stage.trajectory.time_step, &stage.trajectory.reference)
}

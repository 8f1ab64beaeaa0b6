//! Plans on the way to a robust one.

use plan::{PlanIteration, Round, SuccessRates, Variant};
use simulation::{Reference, Refinement, Trial};
use task::{AssemblyTask, Trajectory};

use crate::evaluation::{Drawn, Judgement};

/// A reference that is refined, and the problem it solves.
pub struct Candidate<'run> {
    pub variant: Variant,
    /// The homotopy that the reference comes from; none for one that was not planned.
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
    /// Whether they are what is wanted, after a whole evaluation.
    pub reached: bool,
    /// The evaluation that they are of.
    pub evaluation: Drawn,
    /// Rollouts that this lacks because the time was over; 0 where it is decided.
    pub unplayed: usize,
    /// Trials that it fails.
    pub failing: Vec<Trial>,
    /// Number of its round, from 1.
    pub round: usize,
    /// The homotopy iteration whose reference was refined, from 1.
    pub chosen: usize,
    /// Changes of that reference.
    pub changes: usize,
    /// Whether its homotopy is that of the scene itself.
    pub is_scenes_own: bool,
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

/// Indices of the homotopy iterations that have all steps of a task.
pub fn with_all_steps(iterations: &[PlanIteration], task: &AssemblyTask) -> Vec<usize> {
    (0..iterations.len()).filter(|&index| !iterations[index].record.is_coarse(task)).collect()
}

/// The reference of a motion.
pub fn reference(motion: &Trajectory) -> Reference {
    Reference::new(motion.time_step, &motion.reference)
}

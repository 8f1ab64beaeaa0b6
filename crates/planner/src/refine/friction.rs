//! A plan that meets friction, instead of one that meets none.
//!
//! A rollout of an arm takes several times as long as one of a free body, so that refinement tries few changes. A plan that
//! meets both no friction and the largest one succeeds far more often before it is refined, and is worth its time.

use std::time::Duration;

use crate::error::PlannerError;
use crate::refine::candidate::Candidate;
use crate::refine::portfolio::Recipe;
use crate::refine::{OWN_SHARE, Refiner};

/// Fraction of the training trials in which the plan of the scene must fail.
const LOST: f64 = 0.5;
/// A plan with friction takes about so many times as long as the plan of the scene.
const COST: u32 = 6;
/// Largest share of the time that is left for it.
const SHARE: f64 = 0.8;

impl<'run> Refiner<'run> {
    /// Refines the plan of the scene, which took `solving`, or one with friction where that fails in fewer trials.
    pub(super) fn refine_better(&mut self, own: Candidate<'run>, solving: Duration) -> Result<(), PlannerError> {
        let until = self.clock.share(self.clock.end(), SHARE);
        let is_wanted = self.problem.arm().is_some()
            && self.target.largest_friction() > 0.0
            && own.refinement.failing_fraction() > LOST
            && 2 * COST * solving < self.clock.left();
        let other = if is_wanted { self.solve_variant(Recipe::FrictionsAsScenarios, (1, 1), until)? } else { None };
        let until = self.clock.share(self.clock.end(), OWN_SHARE);
        match other {
            Some(other) if other.refinement.failing_fraction() < own.refinement.failing_fraction() => {
                self.rounds.push(own.round);
                self.refine(other, until)
            }
            Some(other) => {
                self.refine(own, until)?;
                self.rounds.push(other.round);
                Ok(())
            }
            None => self.refine(own, until),
        }
    }
}

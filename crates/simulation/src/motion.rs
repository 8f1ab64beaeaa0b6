//! Rollouts as trajectories of the planner, so that both are written and read alike.

use task::{Quality, ScenarioTrajectory, Trajectory};

use crate::reference::Reference;
use crate::rollout::Rollout;

impl Rollout {
    /// The motions of the body under some offsets (m, body frame): states and mean contact forces at the knots of the
    /// reference. Distances are smoothed by `tau`; final errors and largest forces include the settling time. A rollout
    /// that diverges ends early.
    pub fn trajectory(&self, reference: &Reference, offsets: &[[f64; 3]], tau: f64) -> Trajectory {
        Trajectory {
            time_step: reference.time_step(),
            reference: reference.states(),
            reference_keeps: reference.limits_kept(),
            scenarios: offsets.iter().map(|offset| self.scenario(reference, offset, tau)).collect(),
            quaternion_drift: 0.0,
        }
    }

    fn scenario(&self, reference: &Reference, offset: &[f64; 3], tau: f64) -> ScenarioTrajectory {
        let (_, substeps) = self.settings.divide(reference.time_step());
        let initial = task::pose::without_offset(&reference.start(), offset);
        let mut states = vec![task::at_rest(&initial)];
        let mut forces: Vec<Vec<f64>> = Vec::with_capacity(reference.intervals());
        let mut steps = 0;
        let outcome = self.play(reference, *offset, |body, impulses| {
            steps += 1;
            if steps % substeps == 0 && forces.len() < reference.intervals() {
                states.push(body.state());
                forces.push(impulses.iter().map(|impulse| impulse / reference.time_step()).collect());
            }
        });
        let motion = ScenarioTrajectory::new(
            &self.task,
            *offset,
            reference.time_step(),
            &reference.states(),
            &states,
            |step| &forces[step - 1],
            tau,
        );
        let quality = Quality {
            position_error: outcome.position_error,
            orientation_error: outcome.orientation_error,
            max_force: outcome.max_force,
            ..motion.quality
        };
        ScenarioTrajectory { quality, ..motion }
    }
}

//! Rollouts as the planner's trajectories, so that both are written and read alike.

use task::{Quality, ScenarioTrajectory, Trajectory};

use crate::reference::Reference;
use crate::rollout::Rollout;

impl Rollout {
    /// The motions that the body really makes with some offsets (m, body frame): states and mean contact forces at the
    /// knots of the reference; distances are smoothed by `tau`; final errors are those after the settling time.
    pub fn trajectory(&self, reference: &Reference, offsets: &[[f64; 3]], tau: f64) -> Trajectory {
        Trajectory {
            time_step: reference.time_step(),
            reference: reference.states(),
            reference_keeps: reference.needs(),
            scenarios: offsets.iter().map(|offset| self.scenario(reference, offset, tau)).collect(),
            quaternion_drift: 0.0,
        }
    }

    fn scenario(&self, reference: &Reference, offset: &[f64; 3], tau: f64) -> ScenarioTrajectory {
        let (_, substeps) = self.settings.divide(reference.time_step());
        let initial = task::pose::without_offset(&reference.start(), offset);
        let mut states = vec![std::array::from_fn(|index| initial.get(index).copied().unwrap_or(0.0))];
        let mut forces: Vec<Vec<f64>> = Vec::with_capacity(reference.intervals());
        let mut moments = 0;
        let outcome = self.play(reference, *offset, |moment, impulses| {
            moments += 1;
            if moments % substeps == 0 && forces.len() < reference.intervals() {
                states.push(moment.state());
                forces.push(impulses.iter().map(|impulse| impulse / reference.time_step()).collect());
            }
        });
        let motion =
            ScenarioTrajectory::new(&self.task, *offset, &reference.states(), &states, |step| &forces[step - 1], tau);
        let quality = Quality {
            position_error: outcome.position_error,
            orientation_error: outcome.orientation_error,
            max_force: outcome.max_force,
            ..motion.quality
        };
        ScenarioTrajectory { quality, ..motion }
    }
}

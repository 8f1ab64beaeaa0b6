//! Rollouts as trajectories of the planner, so that both have one format.

use task::{AssemblyTask, Limits, Quality, ScenarioTrajectory, Trajectory};

use crate::disturbance::Injection;
use crate::loads::Loads;
use crate::reference::Reference;
use crate::rollout::Rollout;

impl Rollout {
    /// The motions of the body under some injections, grasp errors or offsets (m, body frame): states and mean contact forces
    /// at the knots of the reference. Distances are smoothed by `tau`; final errors and largest forces include the settling time. A rollout
    /// that diverges ends early.
    pub fn trajectory<G: Copy + Into<Injection>>(
        &self,
        reference: &Reference,
        injections: &[G],
        tau: f64,
    ) -> Trajectory {
        Trajectory {
            time_step: reference.time_step(),
            reference: reference.states(),
            reference_keeps: reference.limits_kept(),
            scenarios: injections.iter().map(|&injection| self.scenario(reference, &injection.into(), tau)).collect(),
            quaternion_drift: 0.0,
        }
    }

    fn scenario(&self, reference: &Reference, injection: &Injection, tau: f64) -> ScenarioTrajectory {
        let Injection { grasp, disturbance } = injection;
        let (_, substeps) = self.settings.divide(reference.time_step());
        let mut states = vec![grasp.actual(&reference.start()).at_rest()];
        let mut forces: Vec<Vec<f64>> = Vec::with_capacity(reference.intervals());
        let mut steps = 0;
        let outcome = self.play(reference, *injection, |body, impulses| {
            steps += 1;
            if steps % substeps == 0 && forces.len() < reference.intervals() {
                states.push(body.state());
                forces.push(impulses.iter().map(|impulse| impulse / reference.time_step()).collect());
            }
        });
        let task = AssemblyTask { impedance: disturbance.impedance(self.task.impedance.clone()), ..self.task.clone() };
        let motion = ScenarioTrajectory::new(
            &task,
            *grasp,
            reference.time_step(),
            &reference.states(),
            &states,
            |step| forces[step - 1].iter().copied(),
            tau,
        );
        let quality = Quality {
            position_error: outcome.position_error,
            orientation_error: outcome.orientation_error,
            max_force: outcome.loads.contact_force,
            ..motion.quality
        };
        let Loads { contact_force, force, torque } = outcome.loads;
        let keeps = Limits { contact_force, force, torque, ..motion.keeps };
        ScenarioTrajectory { quality, keeps, ..motion }
    }
}

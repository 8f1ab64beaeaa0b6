//! Conversion between points of the transcription and trajectories.

use kkt::Owner;
use task::{POSE, STATE, Scenario, ScenarioTrajectory, State, Trajectory};

use crate::block::Owners;
use crate::terms::CONTACT_FORCE;
use crate::transcription::{INITIAL_CONTACT_FORCE, Transcription};

impl Transcription {
    /// The trajectory at a point `x`, with distances smoothed by `tau`.
    pub fn motion(&self, x: &[f64], tau: f64) -> Trajectory {
        let (task, layout) = (self.task(), self.layout());
        let (time_step, unit) = (task.horizon.time_step, task.impedance.force_unit());
        let reference = self.states(x, &task.start.at_rest(), Owner::Reference);
        let compliant = self.compliant_states(x);
        let drift = compliant.iter().map(|states| norm_drift(states)).fold(norm_drift(&reference), f64::max);
        let scenarios = compliant
            .iter()
            .zip(task.scenarios())
            .enumerate()
            .map(|(scenario, (states, Scenario { grasp, .. }))| {
                let first = |stage: usize| layout.variable(CONTACT_FORCE, stage, Owner::Scenario(scenario));
                let forces = |stage: usize| x[first(stage)..][..layout.pairs].iter().map(|force| force * unit);
                ScenarioTrajectory::new(task, grasp, time_step, &reference, states, forces, tau)
            })
            .collect();
        Trajectory::new(time_step, &reference, scenarios, drift)
    }

    /// The point of a trajectory, as a starting point.
    ///
    /// # Panics
    /// When the trajectory has fewer steps or scenarios than the transcription.
    pub fn point_at(&self, motion: &Trajectory) -> Vec<f64> {
        let (layout, unit) = (self.layout(), self.task().impedance.force_unit());
        let mut x = vec![INITIAL_CONTACT_FORCE; layout.variable_count()];
        for (stage, owner) in layout.stages_of(Owners::All) {
            let state = &mut x[layout.state(stage, owner)..][..STATE];
            let Owner::Scenario(scenario) = owner else {
                state.copy_from_slice(&motion.reference[stage][..]);
                continue;
            };
            let scenario_motion = &motion.scenarios[scenario];
            state.copy_from_slice(&scenario_motion.states[stage][..]);
            let forces = &mut x[layout.variable(CONTACT_FORCE, stage, owner)..][..layout.pairs];
            for (force, contact) in forces.iter_mut().zip(&scenario_motion.contacts[stage - 1]) {
                *force = (contact.force / unit).max(INITIAL_CONTACT_FORCE);
            }
        }
        x
    }

    /// States of the body at k = 0..N, of every scenario.
    pub(crate) fn compliant_states(&self, x: &[f64]) -> Vec<Vec<State>> {
        let states = |(scenario, initial)| self.states(x, initial, Owner::Scenario(scenario));
        self.initial_compliant().iter().enumerate().map(states).collect()
    }

    /// States of a trajectory at k = 0..N.
    fn states(&self, x: &[f64], initial: &State, owner: Owner) -> Vec<State> {
        let start = |stage| self.layout().state(stage, owner);
        let state = |stage| State(std::array::from_fn(|component| x[start(stage) + component]));
        let later = (1..=self.layout().steps).map(state);
        std::iter::once(*initial).chain(later).collect()
    }
}

/// Largest `| |xi| - 1 |`, the drift of Euler's method.
fn norm_drift(states: &[State]) -> f64 {
    let norm = |state: &State| state[3..POSE].iter().map(|c| c * c).sum::<f64>().sqrt();
    states.iter().map(|state| (norm(state) - 1.0).abs()).fold(0.0, f64::max)
}

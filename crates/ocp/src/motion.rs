//! Points of the transcription as motions, and motions as points where a solve may begin.

use task::{POSE, STATE, ScenarioTrajectory, Trajectory, at_rest};

use crate::transcription::{INITIAL_CONTACT_FORCE, Transcription};

impl Transcription {
    /// The motion at a point `x` whose distances are smoothed by `tau`.
    pub fn motion(&self, x: &[f64], tau: f64) -> Trajectory {
        let (task, layout) = (self.task(), self.layout());
        let time_step = task.horizon.time_step;
        let reference = self.states(x, &at_rest(&task.start), |stage| layout.reference(stage));
        let compliant: Vec<Vec<[f64; STATE]>> = (0..layout.scenarios)
            .map(|scenario| {
                let initial = &self.initial_compliant()[scenario];
                self.states(x, initial, |stage| layout.compliant(stage, scenario))
            })
            .collect();
        let drift = compliant.iter().map(|states| norm_drift(states)).fold(norm_drift(&reference), f64::max);
        let scenarios = compliant
            .iter()
            .enumerate()
            .map(|(scenario, states)| {
                let forces = |stage: usize| &x[layout.contact_force(stage, scenario, 0)..][..layout.pairs];
                ScenarioTrajectory::new(task, task.offsets[scenario], time_step, &reference, states, forces, tau)
            })
            .collect();
        Trajectory::new(time_step, &reference, scenarios, drift)
    }

    /// The variables at a motion, where a solve may begin.
    ///
    /// # Panics
    /// When the motion has fewer steps, scenarios or pairs than the transcription.
    pub fn point_at(&self, motion: &Trajectory) -> Vec<f64> {
        let layout = self.layout();
        let mut x = vec![INITIAL_CONTACT_FORCE; layout.variable_count()];
        for stage in layout.stages() {
            x[layout.reference(stage)..][..STATE].copy_from_slice(&motion.reference[stage]);
        }
        for (stage, scenario) in layout.stages_and_scenarios() {
            let scenario_motion = &motion.scenarios[scenario];
            x[layout.compliant(stage, scenario)..][..STATE].copy_from_slice(&scenario_motion.states[stage]);
            for (pair, contact) in scenario_motion.contacts[stage - 1].iter().enumerate() {
                let force = &mut x[layout.contact_force(stage, scenario, pair)];
                *force = contact.force.max(INITIAL_CONTACT_FORCE);
            }
        }
        x
    }

    /// States at k = 0..N; `start` is where a stage's state stands in `x`.
    fn states(&self, x: &[f64], initial: &[f64; STATE], start: impl Fn(usize) -> usize) -> Vec<[f64; STATE]> {
        let later = self.layout().stages().map(|stage| std::array::from_fn(|component| x[start(stage) + component]));
        std::iter::once(*initial).chain(later).collect()
    }
}

/// Largest `| |xi| - 1 |`: the drift of Euler's method.
fn norm_drift(states: &[[f64; STATE]]) -> f64 {
    let norm = |state: &[f64; STATE]| state[3..POSE].iter().map(|c| c * c).sum::<f64>().sqrt();
    states.iter().map(|state| (norm(state) - 1.0).abs()).fold(0.0, f64::max)
}

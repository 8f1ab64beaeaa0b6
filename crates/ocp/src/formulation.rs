//! What a transcription is of: task, contacts and the order of its variables, with conversions between points and
//! trajectories.

use kkt::Owner;
use nlp::Iterate;
use task::{AssemblyTask, Complementarity, POSE, Pose, STATE, Scenario, ScenarioTrajectory, State, Trajectory};

use crate::active_contacts::ActiveContacts;
use crate::block::{Blocks, Owners};
use crate::layout::{Layout, PairSource, same_pair};
use crate::term::blocks;
use crate::terms::{CONTACT_FORCE, initial_states, standard_terms};

/// Contact force in the initial guess (in the unit of force), and the value of all variables that are not states.
pub const INITIAL_CONTACT_FORCE: f64 = 1e-3;

/// A task with the contacts that are modelled.
#[derive(Debug, Clone)]
pub struct Formulation {
    task: AssemblyTask,
    layout: Layout,
    initial_compliant: Vec<State>,
}

impl Formulation {
    /// With all contacts.
    pub fn new(task: &AssemblyTask, complementarity: Complementarity) -> Self {
        Self::with_blocks(task, &blocks(&standard_terms(task, complementarity)))
    }

    /// With the variables and rows of some terms.
    pub(crate) fn with_blocks(task: &AssemblyTask, blocks: &Blocks) -> Self {
        Self { task: task.clone(), layout: Layout::new(task, blocks), initial_compliant: initial_states(task) }
    }

    /// With these contacts only.
    pub fn with_contacts(&self, contacts: ActiveContacts) -> Self {
        let (task, initial_compliant) = (self.task.clone(), self.initial_compliant.clone());
        Self { task, layout: self.layout.with_contacts(contacts), initial_compliant }
    }

    /// With the contacts that come near at a point.
    pub fn near(&self, x: &[f64]) -> Self {
        self.with_contacts(ActiveContacts::near(&self.task, &self.compliant_poses(x)))
    }

    /// The task.
    pub fn task(&self) -> &AssemblyTask {
        &self.task
    }

    /// Indices of variables and constraints.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Compliant states at the start, one per scenario.
    pub fn initial_compliant(&self) -> &[State] {
        &self.initial_compliant
    }

    /// The trivial guess: all trajectories rest at the start pose, with small positive contact forces.
    pub fn initial_guess(&self) -> Vec<f64> {
        let mut x = vec![INITIAL_CONTACT_FORCE; self.layout.variable_count()];
        for (stage, owner) in self.layout.stages_of(Owners::All) {
            let state = match owner {
                Owner::Reference => self.task.start.at_rest(),
                Owner::Scenario(scenario) => self.initial_compliant[scenario],
            };
            x[self.layout.state(stage, owner)..][..STATE].copy_from_slice(&state[..]);
        }
        x
    }

    /// The trajectory at a point `x`, with distances smoothed by `tau`. Pairs without a contact exert no force.
    pub fn motion(&self, x: &[f64], tau: f64) -> Trajectory {
        let (task, layout) = (&self.task, &self.layout);
        let (time_step, unit) = (task.horizon.time_step, task.impedance.force_unit());
        let reference = self.states(x, &task.start.at_rest(), Owner::Reference);
        let compliant = self.compliant_states(x);
        let drift = compliant.iter().map(|states| norm_drift(states)).fold(norm_drift(&reference), f64::max);
        let scenarios = compliant
            .iter()
            .zip(task.scenarios())
            .enumerate()
            .map(|(scenario, (states, Scenario { grasp, .. }))| {
                let forces = |stage: usize| {
                    let first = layout.variable(CONTACT_FORCE, stage, Owner::Scenario(scenario));
                    let mut forces = vec![0.0; layout.pairs];
                    for (slot, &pair) in layout.contacts().of(stage, scenario).iter().enumerate() {
                        forces[pair] = x[first + slot] * unit;
                    }
                    forces.into_iter()
                };
                ScenarioTrajectory::new(task, grasp, time_step, &reference, states, forces, tau)
            })
            .collect();
        Trajectory::new(time_step, &reference, scenarios, drift)
    }

    /// The point of a trajectory, as a starting point.
    ///
    /// # Panics
    /// When the trajectory has fewer steps or scenarios than the task.
    pub fn point_at(&self, motion: &Trajectory) -> Vec<f64> {
        let (layout, unit) = (&self.layout, self.task.impedance.force_unit());
        let mut x = vec![INITIAL_CONTACT_FORCE; layout.variable_count()];
        for (stage, owner) in layout.stages_of(Owners::All) {
            let state = &mut x[layout.state(stage, owner)..][..STATE];
            let Owner::Scenario(scenario) = owner else {
                state.copy_from_slice(&motion.reference[stage][..]);
                continue;
            };
            let scenario_motion = &motion.scenarios[scenario];
            state.copy_from_slice(&scenario_motion.states[stage][..]);
            let first = layout.variable(CONTACT_FORCE, stage, owner);
            for (slot, &pair) in layout.contacts().of(stage, scenario).iter().enumerate() {
                let force = scenario_motion.contacts[stage - 1][pair].force;
                x[first + slot] = (force / unit).max(INITIAL_CONTACT_FORCE);
            }
        }
        x
    }

    /// Variables of the same task with other contacts. Contacts that were not there exert no force.
    pub fn variables_of(&self, other: &Self, x: &[f64]) -> Vec<f64> {
        self.variables_from(other, x, &same_pair)
    }

    /// Variables of a task that differs in its pairs, and in its contacts.
    pub(crate) fn variables_from(&self, other: &Self, x: &[f64], source: &PairSource) -> Vec<f64> {
        self.layout.variables_from(&other.layout, x, source)
    }

    /// A primal-dual point of the same task with other contacts. Contacts that were not there exert no force.
    pub fn point_of(&self, other: &Self, point: &Iterate) -> Iterate {
        self.point_from(other, point, &same_pair)
    }

    /// A primal-dual point of a task that differs in its pairs, and in its contacts.
    pub(crate) fn point_from(&self, other: &Self, point: &Iterate, source: &PairSource) -> Iterate {
        let variables = |values: &[f64]| self.variables_from(other, values, source);
        Iterate {
            x: variables(&point.x),
            constraint_multipliers: self.layout.rows_from(&other.layout, &point.constraint_multipliers, source),
            lower_multipliers: variables(&point.lower_multipliers),
            upper_multipliers: variables(&point.upper_multipliers),
        }
    }

    /// Poses of the body at k = 0..N, of every scenario.
    pub(crate) fn compliant_poses(&self, x: &[f64]) -> Vec<Vec<Pose>> {
        let poses = |states: Vec<State>| states.iter().map(State::pose).collect();
        self.compliant_states(x).into_iter().map(poses).collect()
    }

    /// States of the body at k = 0..N, of every scenario.
    fn compliant_states(&self, x: &[f64]) -> Vec<Vec<State>> {
        let states = |(scenario, initial)| self.states(x, initial, Owner::Scenario(scenario));
        self.initial_compliant.iter().enumerate().map(states).collect()
    }

    /// States of a trajectory at k = 0..N.
    fn states(&self, x: &[f64], initial: &State, owner: Owner) -> Vec<State> {
        let start = |stage| self.layout.state(stage, owner);
        let state = |stage| State(std::array::from_fn(|component| x[start(stage) + component]));
        let later = (1..=self.layout.steps).map(state);
        std::iter::once(*initial).chain(later).collect()
    }
}

/// Largest `| |xi| - 1 |`, the drift of Euler's method.
fn norm_drift(states: &[State]) -> f64 {
    let norm = |state: &State| state[3..POSE].iter().map(|c| c * c).sum::<f64>().sqrt();
    states.iter().map(|state| (norm(state) - 1.0).abs()).fold(0.0, f64::max)
}

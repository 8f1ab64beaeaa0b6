//! What a solution means: reference, compliant states, wrenches, contacts and final errors.

use autodiff::{Batch, Workspace};

use crate::layout::{Layout, POSE, STATE, TWIST};
use crate::limits::Limits;
use crate::model;
use crate::pose;
use crate::quality::{Contact, Quality};
use crate::state::{at_rest, pose_of};
use crate::task::AssemblyTask;
use crate::transcription::{INITIAL_CONTACT_FORCE, Transcription};

/// A reference trajectory and the motion that every scenario makes when it tracks it. Quaternions are of unit norm.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Step (s).
    pub time_step: f64,
    /// Reference states (pose, twist) at k = 0..N.
    pub reference: Vec<[f64; STATE]>,
    /// One per offset.
    pub scenarios: Vec<ScenarioTrajectory>,
    /// Largest `| |xi| - 1 |` before normalisation: the drift of Euler's method.
    pub quaternion_drift: f64,
    /// The tightest limits that the reference keeps; it has no forces.
    pub reference_keeps: Limits,
}

/// The compliant motion of one scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct ScenarioTrajectory {
    /// Offset in the body frame (m).
    pub offset: [f64; 3],
    /// Compliant states at k = 0..N.
    pub states: Vec<[f64; STATE]>,
    /// Impedance wrenches at k = 1..N (Eq. impedancewrench): force in the world frame (N), torque in the body frame (Nm).
    pub wrenches: Vec<[f64; TWIST]>,
    /// Contacts at k = 1..N, one per pair.
    pub contacts: Vec<Vec<Contact>>,
    /// How well the scenario ends and how hard it touches.
    pub quality: Quality,
    /// The tightest limits that the scenario keeps.
    pub keeps: Limits,
}

impl Trajectory {
    /// Reads the point `x` of a transcription whose distances are smoothed by `tau`.
    pub fn new(transcription: &Transcription, x: &[f64], tau: f64) -> Self {
        let (task, layout) = (transcription.task(), transcription.layout());
        let reference_raw = states(layout, x, &at_rest(&task.start), |stage| layout.reference(stage));
        let scenarios_raw: Vec<Vec<[f64; STATE]>> = (0..layout.scenarios)
            .map(|scenario| {
                let initial = &transcription.initial_compliant()[scenario];
                states(layout, x, initial, |stage| layout.compliant(stage, scenario))
            })
            .collect();
        let drift = |states: &[[f64; STATE]]| {
            let norm = |state: &[f64; STATE]| state[3..POSE].iter().map(|c| c * c).sum::<f64>().sqrt();
            states.iter().map(|state| (norm(state) - 1.0).abs()).fold(0.0, f64::max)
        };
        let quaternion_drift = scenarios_raw.iter().map(|raw| drift(raw)).fold(drift(&reference_raw), f64::max);
        let scenarios = scenarios_raw
            .iter()
            .enumerate()
            .map(|(scenario, raw)| {
                let forces = |stage: usize| &x[layout.contact_force(stage, scenario, 0)..][..layout.pairs];
                ScenarioTrajectory::new(task, task.offsets[scenario], &reference_raw, raw, forces, tau)
            })
            .collect();
        Self {
            time_step: task.horizon.time_step,
            reference_keeps: Limits::kept_by(&reference_raw, task.horizon.time_step, &[], 0.0),
            reference: reference_raw.iter().map(normalised).collect(),
            scenarios,
            quaternion_drift,
        }
    }

    /// The variables of a transcription at this motion, where a solve may begin.
    ///
    /// # Panics
    /// When the motion has fewer steps, scenarios or pairs than the layout.
    pub fn variables(&self, layout: Layout) -> Vec<f64> {
        let mut x = vec![INITIAL_CONTACT_FORCE; layout.variable_count()];
        for stage in layout.stages() {
            x[layout.reference(stage)..][..STATE].copy_from_slice(&self.reference[stage]);
        }
        for (stage, scenario) in layout.stages_and_scenarios() {
            let motion = &self.scenarios[scenario];
            x[layout.compliant(stage, scenario)..][..STATE].copy_from_slice(&motion.states[stage]);
            for (pair, contact) in motion.contacts[stage - 1].iter().enumerate() {
                let force = &mut x[layout.contact_force(stage, scenario, pair)];
                *force = contact.force.max(INITIAL_CONTACT_FORCE);
            }
        }
        x
    }

    /// Largest final position error (m) and orientation error (rad) of all scenarios.
    pub fn worst_errors(&self) -> (f64, f64) {
        let qualities = self.scenarios.iter().map(|scenario| &scenario.quality);
        qualities.fold((0.0, 0.0), |(position, orientation), quality| {
            (quality.position_error.max(position), quality.orientation_error.max(orientation))
        })
    }

    /// The tightest limits that the reference and all scenarios keep.
    pub fn keeps(&self) -> Limits {
        self.scenarios.iter().fold(self.reference_keeps, |limits, scenario| limits.max(&scenario.keeps))
    }

    /// Deepest overlap of the exact shapes in any scenario (m), 0 when there is none.
    pub fn max_penetration(&self) -> f64 {
        let peaks = self.scenarios.iter().filter_map(|scenario| scenario.quality.penetration);
        peaks.map(|peak| peak.value).fold(0.0, f64::max)
    }
}

impl ScenarioTrajectory {
    /// From the states of reference and body at k = 0..N and the contact forces (N) of every pair in the step that leads
    /// to k = 1..N; distances are smoothed by `tau`.
    pub fn new<'x>(
        task: &AssemblyTask,
        offset: [f64; 3],
        reference: &[[f64; STATE]],
        raw: &[[f64; STATE]],
        forces: impl Fn(usize) -> &'x [f64],
        tau: f64,
    ) -> Self {
        let states: Vec<[f64; STATE]> = raw.iter().map(normalised).collect();
        let poses: Vec<[f64; POSE]> = states.iter().map(pose_of).collect();
        let distances: Vec<Vec<f64>> = task.pairs.iter().map(|pair| smoothed(&pair.shapes, &poses[1..], tau)).collect();
        let contacts: Vec<Vec<Contact>> = (1..poses.len())
            .map(|stage| {
                let pairs = distances.iter().zip(forces(stage));
                pairs.map(|(distances, &force)| Contact { distance: distances[stage - 1], force }).collect()
            })
            .collect();
        let quality = Quality::new(task, &poses, &contacts);
        let wrenches = wrenches(task, offset, &reference[1..], &raw[1..]);
        let keeps = Limits::kept_by(&states, task.horizon.time_step, &wrenches, quality.max_force);
        Self { offset, states, wrenches, contacts, quality, keeps }
    }
}

/// Smoothed distances, NaN where one cannot be computed.
fn smoothed(pair: &collision::Pair, poses: &[[f64; POSE]], tau: f64) -> Vec<f64> {
    poses.iter().map(|pose| pair.distance(pose, tau).map_or(f64::NAN, |distance| distance.smoothed_distance)).collect()
}

fn wrenches(
    task: &AssemblyTask,
    offset: [f64; 3],
    reference: &[[f64; STATE]],
    states: &[[f64; STATE]],
) -> Vec<[f64; TWIST]> {
    let tape = model::wrench(&task.impedance, &[0, 1, 2, 3, 4, 5]);
    let mut inputs = Batch::new(2 * STATE + offset.len(), states.len());
    let mut outputs = Batch::new(TWIST, states.len());
    for component in 0..STATE {
        inputs.row_mut(component).iter_mut().zip(reference).for_each(|(input, state)| *input = state[component]);
        inputs.row_mut(STATE + component).iter_mut().zip(states).for_each(|(input, state)| *input = state[component]);
    }
    for (axis, shift) in offset.into_iter().enumerate() {
        inputs.row_mut(2 * STATE + axis).fill(shift);
    }
    tape.evaluate(&inputs, &mut outputs, &mut Workspace::default());
    (0..states.len()).map(|point| std::array::from_fn(|axis| outputs.row(axis)[point])).collect()
}

fn states(layout: Layout, x: &[f64], initial: &[f64; STATE], start: impl Fn(usize) -> usize) -> Vec<[f64; STATE]> {
    let later = layout.stages().map(|stage| std::array::from_fn(|component| x[start(stage) + component]));
    std::iter::once(*initial).chain(later).collect()
}

fn normalised(state: &[f64; STATE]) -> [f64; STATE] {
    let mut unit = *state;
    unit[..POSE].copy_from_slice(&pose::normalised(&pose_of(state)));
    unit
}

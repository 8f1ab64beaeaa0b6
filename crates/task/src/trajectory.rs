//! The plan: reference, compliant states, wrenches, contacts and final errors.

use crate::grasp_error::GraspError;
use crate::limits::Limits;
use crate::pose;
use crate::quality::{Contact, Quality};
use crate::state::{POSE, STATE, TWIST, pose_of};
use crate::task::{AssemblyTask, ContactPair};

/// A reference trajectory, and the motion of the body in every scenario while the robot tracks it. Quaternions have
/// unit norm.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Length of a step (s).
    pub time_step: f64,
    /// Reference states (pose, twist) at k = 0..N.
    pub reference: Vec<[f64; STATE]>,
    /// One per grasp error.
    pub scenarios: Vec<ScenarioTrajectory>,
    /// Largest `| |xi| - 1 |` before normalisation: the drift of Euler's method.
    pub quaternion_drift: f64,
    /// The tightest limits that the reference satisfies. Those of forces are zero: a reference has none.
    pub reference_keeps: Limits,
}

/// The compliant motion of one scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct ScenarioTrajectory {
    /// Where the body sits in the gripper.
    pub grasp: GraspError,
    /// Compliant states at k = 0..N.
    pub states: Vec<[f64; STATE]>,
    /// Impedance wrenches at k = 1..N (Eq. impedancewrench): force in the world frame (N), torque in the body frame
    /// (Nm).
    pub wrenches: Vec<[f64; TWIST]>,
    /// Contacts at k = 1..N, one per pair.
    pub contacts: Vec<Vec<Contact>>,
    /// Final errors, and extremes of force and penetration.
    pub quality: Quality,
    /// The tightest limits that the scenario satisfies.
    pub keeps: Limits,
}

impl Trajectory {
    /// A trajectory from the raw states of the reference at k = 0..N, whose quaternions may have drifted from unit
    /// norm, and from the scenarios. `drift` is the largest deviation from unit norm.
    pub fn new(time_step: f64, reference: &[[f64; STATE]], scenarios: Vec<ScenarioTrajectory>, drift: f64) -> Self {
        Self {
            time_step,
            reference_keeps: Limits::kept_by(reference, time_step, &[], 0.0),
            reference: reference.iter().map(normalised).collect(),
            scenarios,
            quaternion_drift: drift,
        }
    }

    /// Largest final position error (m) and orientation error (rad) of all scenarios.
    pub fn worst_errors(&self) -> (f64, f64) {
        let qualities = self.scenarios.iter().map(|scenario| &scenario.quality);
        qualities.fold((0.0, 0.0), |(position, orientation), quality| {
            (quality.position_error.max(position), quality.orientation_error.max(orientation))
        })
    }

    /// The tightest limits that the reference and all scenarios satisfy.
    pub fn keeps(&self) -> Limits {
        self.scenarios.iter().fold(self.reference_keeps, |limits, scenario| limits.max(&scenario.keeps))
    }
}

impl ScenarioTrajectory {
    /// A scenario from the raw states of reference and body at k = 0..N, `time_step` seconds apart. `forces(k)` are the
    /// contact forces (N) of all pairs in the step that ends at k = 1..N. Distances are smoothed by `tau`.
    pub fn new<Forces: Iterator<Item = f64>>(
        task: &AssemblyTask,
        grasp: GraspError,
        time_step: f64,
        reference: &[[f64; STATE]],
        raw: &[[f64; STATE]],
        forces: impl Fn(usize) -> Forces,
        tau: f64,
    ) -> Self {
        let states: Vec<[f64; STATE]> = raw.iter().map(normalised).collect();
        let poses: Vec<[f64; POSE]> = states.iter().map(pose_of).collect();
        let smoothed = |pair: &ContactPair| pair.shapes.smoothed_distances(&poses[1..], tau);
        let distances: Vec<Vec<f64>> = task.pairs.iter().map(smoothed).collect();
        let contacts: Vec<Vec<Contact>> = (1..poses.len())
            .map(|step| {
                let pairs = distances.iter().zip(forces(step));
                pairs.map(|(distances, force)| Contact { distance: distances[step - 1], force }).collect()
            })
            .collect();
        let quality = Quality::new(task, &poses, &contacts);
        let wrenches = wrenches(task, &grasp, &reference[1..], &raw[1..]);
        let keeps = Limits::kept_by(&states, time_step, &wrenches, quality.max_force);
        Self { grasp, states, wrenches, contacts, quality, keeps }
    }
}

fn wrenches(
    task: &AssemblyTask,
    grasp: &GraspError,
    reference: &[[f64; STATE]],
    states: &[[f64; STATE]],
) -> Vec<[f64; TWIST]> {
    let (grasp, tracked) = (grasp.pose(), reference.iter().zip(states));
    tracked.map(|(reference, state)| task.impedance.wrench(reference, state, &grasp)).collect()
}

fn normalised(state: &[f64; STATE]) -> [f64; STATE] {
    let mut unit = *state;
    unit[..POSE].copy_from_slice(&pose::normalised(&pose_of(state)));
    unit
}

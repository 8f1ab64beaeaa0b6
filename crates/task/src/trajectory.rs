//! The plan: reference, compliant states, wrenches, contacts and final errors.

use crate::grasp_error::GraspError;
use crate::limits::Limits;
use crate::pose::{self, Pose, PoseError};
use crate::quality::{Contact, Quality};
use crate::state::{State, Wrench};
use crate::task::{AssemblyTask, ContactPair};

/// A reference trajectory, and the motion of the body in every scenario while the robot tracks it. Quaternions have
/// unit norm.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Length of a step (s).
    pub time_step: f64,
    /// Reference states (pose, twist) at k = 0..N.
    pub reference: Vec<State>,
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
    pub states: Vec<State>,
    /// Impedance wrenches at k = 1..N (Eq. impedancewrench).
    pub wrenches: Vec<Wrench>,
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
    pub fn new(time_step: f64, reference: &[State], scenarios: Vec<ScenarioTrajectory>, drift: f64) -> Self {
        Self {
            time_step,
            reference_keeps: Limits::kept_by(reference, time_step, &[], 0.0),
            reference: reference.iter().map(State::normalised).collect(),
            scenarios,
            quaternion_drift: drift,
        }
    }

    /// Largest final position error and orientation error of all scenarios.
    pub fn worst_error(&self) -> PoseError {
        let qualities = self.scenarios.iter().map(|scenario| &scenario.quality);
        qualities.fold(PoseError { position: 0.0, orientation: 0.0 }, |worst, quality| PoseError {
            position: quality.position_error.max(worst.position),
            orientation: quality.orientation_error.max(worst.orientation),
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
        reference: &[State],
        raw: &[State],
        forces: impl Fn(usize) -> Forces,
        tau: f64,
    ) -> Self {
        let states: Vec<State> = raw.iter().map(State::normalised).collect();
        let poses: Vec<Pose> = states.iter().map(State::pose).collect();
        let after_steps = pose::arrays(&poses[1..]);
        let smoothed = |pair: &ContactPair| pair.shapes.smoothed_distances(&after_steps, tau);
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

fn wrenches(task: &AssemblyTask, grasp: &GraspError, reference: &[State], states: &[State]) -> Vec<Wrench> {
    let (grasp, tracked) = (grasp.pose(), reference.iter().zip(states));
    tracked.map(|(reference, state)| task.impedance.wrench(reference, state, &grasp)).collect()
}

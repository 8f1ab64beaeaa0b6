//! Motions as a page shows them.

use std::collections::HashMap;

use collision::Solutions;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use planner::PlannerError;
use planner::files::{MotionTables, ScenarioTables};
use simulation::Success;
use task::{Contact, ContactPair, ScenarioTrajectory, Trajectory, pose_of};

use crate::model::{MotionData, ScenarioData, Source};
use crate::rounded::{ANGLE, FORCE, LENGTH, all, pose, rounded};

/// Smoothing of distances in rollouts and where they touch (N m): none that can be seen.
pub const HARD: f64 = 1e-6;
/// Forces below this fraction of a motion's largest one have no arrow.
const SHOWN: f64 = 0.02;
/// Smallest force that has an arrow (N).
const SMALLEST: f64 = 1e-3;

/// All pairs of a scene, by name, with what a page needs to know to judge a motion.
pub struct World {
    pairs: Vec<ContactPair>,
    indices: HashMap<String, usize>,
    goal: [f64; 7],
    success: Success,
}

/// What the scenarios of a motion share.
struct Shown {
    /// Pose of the reference at the start.
    believed: [f64; 7],
    /// Indices of the pairs of its tables.
    pairs: Vec<usize>,
    /// Smoothing of the distances (N m).
    tau: f64,
    /// Smallest force that has an arrow (N).
    least: f64,
}

impl World {
    /// Of the pairs of a scene.
    pub fn new(pairs: Vec<ContactPair>, goal: [f64; 7], success: Success) -> Self {
        let indices = pairs.iter().enumerate().map(|(index, pair)| (pair.to_string(), index)).collect();
        Self { pairs, indices, goal, success }
    }

    /// Names of the pairs.
    pub fn names(&self) -> Vec<String> {
        self.pairs.iter().map(ContactPair::to_string).collect()
    }

    /// A rollout as tables, whose pairs are all of the scene.
    pub fn tables(&self, played: Trajectory) -> MotionTables {
        let of_scenario = |motion: ScenarioTrajectory| {
            let ScenarioTrajectory { states, wrenches, contacts, .. } = motion;
            ScenarioTables { states, wrenches, contacts }
        };
        MotionTables {
            time_step: played.time_step,
            reference: played.reference,
            pairs: self.names(),
            scenarios: played.scenarios.into_iter().map(of_scenario).collect(),
        }
    }

    /// Distance from the goal (m) and angle to it (rad) of every scenario of a motion at its last knot.
    pub fn last_errors(&self, tables: &MotionTables) -> Vec<[f64; 2]> {
        let last = |scenario: &ScenarioTables| scenario.states.last().map_or(self.goal, pose_of);
        let errors = |pose: [f64; 7]| <[f64; 2]>::from(task::pose::errors(&pose, &self.goal));
        tables.scenarios.iter().map(|scenario| errors(last(scenario))).collect()
    }

    /// A motion whose scenarios are judged by some final errors: of rollouts, those after the settling time. Points of
    /// contact are those of distances smoothed by `tau`.
    ///
    /// # Errors
    /// When it has a pair that the scene does not have.
    pub fn motion(
        &self,
        tables: &MotionTables,
        errors: &[[f64; 2]],
        source: Source,
        tau: f64,
    ) -> Result<MotionData, PlannerError> {
        let index = |name: &String| self.indices.get(name).copied();
        let pairs: Option<Vec<usize>> = tables.pairs.iter().map(index).collect();
        let pairs = pairs.ok_or(PlannerError::Internal("a table names a pair that the scene does not have"))?;
        let forces = tables.scenarios.iter().flat_map(|scenario| scenario.contacts.iter().flatten());
        let least = SMALLEST.max(SHOWN * forces.map(|contact| contact.force).fold(0.0, f64::max));
        let shown = Shown { believed: pose_of(&tables.reference[0]), pairs, tau, least };
        let scenarios = tables.scenarios.iter().zip(errors);
        Ok(MotionData {
            source,
            time_step: tables.time_step,
            reference: tables.reference.iter().flat_map(|state| pose(&state[..7])).collect(),
            scenarios: scenarios.map(|(scenario, errors)| self.scenario(scenario, *errors, &shown)).collect(),
            execution: None,
        })
    }

    fn scenario(&self, scenario: &ScenarioTables, errors: [f64; 2], shown: &Shown) -> ScenarioData {
        let (offset, turn) = grasp_error(&shown.believed, &pose_of(&scenario.states[0]));
        let smallest = |contacts: &Vec<Contact>| {
            let least = contacts.iter().map(|contact| contact.distance).fold(f64::NAN, f64::min);
            rounded(least, LENGTH)
        };
        let sum = |contacts: &Vec<Contact>| rounded(contacts.iter().map(|contact| contact.force).sum(), FORCE);
        let pushing = |(contacts, state): (&Vec<Contact>, &[f64; 13])| {
            let pushing = contacts.iter().zip(&shown.pairs).filter(|(contact, _)| contact.force >= shown.least);
            pushing
                .filter_map(|(contact, &pair)| self.arrow(pair, contact.force, &pose_of(state), shown.tau))
                .flatten()
                .collect()
        };
        ScenarioData {
            offset: all(offset, LENGTH),
            turn: all(turn, ANGLE),
            disturbances: Vec::new(),
            errors: all(errors, LENGTH),
            success: self.success.reached(errors[0], errors[1]),
            poses: scenario.states.iter().flat_map(|state| pose(&state[..7])).collect(),
            wrenches: scenario.wrenches.iter().flatten().map(|&component| rounded(component, FORCE)).collect(),
            distances: scenario.contacts.iter().map(smallest).collect(),
            forces: scenario.contacts.iter().map(sum).collect(),
            measured: Vec::new(),
            contacts: scenario.contacts.iter().zip(&scenario.states[1..]).map(pushing).collect(),
        }
    }

    /// Pair, force, point and direction of a contact force on the body; none where the distance cannot be computed.
    fn arrow(&self, pair: usize, force: f64, pose: &[f64; 7], tau: f64) -> Option<[f64; 8]> {
        // Ten numbers: the touching point is asked for as well.
        let mut contact = [[0.0; 10]];
        let (poses, solutions) = (std::slice::from_ref(pose), &mut Solutions::default());
        self.pairs[pair].shapes.contacts(poses, tau, solutions, &mut contact).ok()?;
        let [_, nx, ny, nz, _, _, _, x, y, z] = contact[0];
        // A smoothed normal may be shorter than one.
        let normal = Vector3::new(nx, ny, nz).try_normalize(0.0)?;
        let ([x, y, z], [nx, ny, nz]) = (all([x, y, z], LENGTH), all(normal.into(), 3));
        Some([pair as f64, rounded(force, FORCE), x, y, z, nx, ny, nz])
    }
}

/// Offset (m, body frame) and turn (rad) of a body that is believed to be elsewhere.
fn grasp_error(believed: &[f64; 7], actual: &[f64; 7]) -> ([f64; 3], [f64; 3]) {
    let rotation = |pose: &[f64; 7]| UnitQuaternion::new_normalize(Quaternion::new(pose[3], pose[4], pose[5], pose[6]));
    let shift = Vector3::from_fn(|axis, _| believed[axis] - actual[axis]);
    let offset = rotation(actual).inverse() * shift;
    let turn = (rotation(actual).inverse() * rotation(believed)).scaled_axis();
    (offset.into(), turn.into())
}

#[cfg(test)]
mod tests {
    use task::GraspError;

    use super::*;

    #[test]
    fn grasp_errors_are_read_from_where_the_body_starts() {
        let mut state = [0.0; 13];
        state[..7].copy_from_slice(&[0.1, 0.2, 0.3, 0.6, 0.0, 0.8, 0.0]);
        let grasp = GraspError { offset: [0.01, -0.02, 0.03], turn: [0.1, 0.05, -0.2] };
        let start = grasp.actual(&pose_of(&state));
        let (offset, turn) = grasp_error(&pose_of(&state), &start);
        for axis in 0..3 {
            assert!((offset[axis] - grasp.offset[axis]).abs() < 1e-12, "{offset:?}");
            assert!((turn[axis] - grasp.turn[axis]).abs() < 1e-12, "{turn:?}");
        }
    }
}

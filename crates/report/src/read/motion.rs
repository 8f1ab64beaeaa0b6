//! Motions as a page shows them.

use std::collections::HashMap;

use collision::Solutions;
use nalgebra::Vector3;
use plan::PlannerError;
use simulation::Success;
use store::{MotionTables, ScenarioTables};
use task::{Contact, ContactPair, Pose, Quality, ScenarioTrajectory, State, Trajectory};

use crate::model::{MotionData, ScenarioData, Source};
use crate::rounded::{ANGLE, FORCE, LENGTH, all, pose, rounded};

/// Smoothing of distances in rollouts and where they touch (N m): none that can be seen.
pub const HARD: f64 = 1e-6;
/// Forces below this fraction of a motion's largest one have no arrow.
const SHOWN: f64 = 0.02;
/// Smallest force that has an arrow (N).
const SMALLEST: f64 = 1e-3;

/// All pairs of a scene, by name, with the criteria for judging a motion.
pub struct World {
    pairs: Vec<ContactPair>,
    indices: HashMap<String, usize>,
    goal: Pose,
    success: Success,
}

/// How a scenario ends, and how hard it pushes.
#[derive(Debug, Clone, Copy)]
pub struct Measures {
    /// Distance from the goal (m) and angle to it (rad).
    pub errors: [f64; 2],
    /// Largest contact force (N); not a number where it is not known.
    pub max_force: f64,
}

impl From<&Quality> for Measures {
    fn from(quality: &Quality) -> Self {
        Self { errors: [quality.position_error, quality.orientation_error], max_force: quality.max_force }
    }
}

/// Data that the scenarios of a motion share.
struct Shown {
    /// Pose of the reference at the start.
    believed: Pose,
    /// Indices of the pairs of its tables.
    pairs: Vec<usize>,
    /// Smoothing of the distances (N m).
    tau: f64,
    /// Smallest force that has an arrow (N).
    least: f64,
    /// Whether wrenches and arrows are included: they are most of the size of a page, and not needed for homotopy
    /// steps.
    in_full: bool,
}

impl World {
    /// For the pairs of a scene.
    pub fn new(pairs: Vec<ContactPair>, goal: Pose, success: Success) -> Self {
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

    /// How every scenario of a motion ends at its last knot, and the largest force of its steps.
    pub fn measures(&self, tables: &MotionTables) -> Vec<Measures> {
        let last = |scenario: &ScenarioTables| scenario.states.last().map_or(self.goal, State::pose);
        let errors = |pose: Pose| {
            let error = pose.error(&self.goal);
            [error.position, error.orientation]
        };
        let max_force = |scenario: &ScenarioTables| {
            scenario.contacts.iter().map(|contacts| largest_force(contacts)).fold(0.0, f64::max)
        };
        let measures = |scenario| Measures { errors: errors(last(scenario)), max_force: max_force(scenario) };
        tables.scenarios.iter().map(measures).collect()
    }

    /// A motion whose scenarios have some measures: of rollouts, those after the settling time. Points of contact are those
    /// of distances smoothed by `tau`.
    ///
    /// # Errors
    /// When it has a pair that the scene does not have.
    pub fn motion(
        &self,
        tables: &MotionTables,
        measures: &[Measures],
        source: Source,
        tau: f64,
    ) -> Result<MotionData, PlannerError> {
        let index = |name: &String| self.indices.get(name).copied();
        let pairs: Option<Vec<usize>> = tables.pairs.iter().map(index).collect();
        let pairs = pairs.ok_or(PlannerError::Internal("a table names a pair that the scene does not have"))?;
        let forces = tables.scenarios.iter().flat_map(|scenario| scenario.contacts.iter().flatten());
        let least = SMALLEST.max(SHOWN * forces.map(|contact| contact.force).fold(0.0, f64::max));
        let in_full = !matches!(source, Source::Iteration { .. });
        let shown = Shown { believed: tables.reference[0].pose(), pairs, tau, least, in_full };
        let scenarios = tables.scenarios.iter().zip(measures);
        Ok(MotionData {
            source,
            time_step: tables.time_step,
            reference: tables.reference.iter().flat_map(|state| pose(&state[..7])).collect(),
            scenarios: scenarios.map(|(scenario, measures)| self.scenario(scenario, *measures, &shown)).collect(),
            courses: Vec::new(),
            execution: None,
        })
    }

    fn scenario(&self, scenario: &ScenarioTables, measures: Measures, shown: &Shown) -> ScenarioData {
        let (offset, rotation) = grasp_error(&shown.believed, &scenario.states[0].pose());
        let smallest =
            |contacts: &Vec<Contact>| contacts.iter().map(|contact| contact.distance).fold(f64::NAN, f64::min);
        let distances = scenario.contacts.iter().map(smallest);
        let distances = std::iter::once(self.distance(&scenario.states[0].pose(), shown)).chain(distances);
        let pushing = |(contacts, state): (&Vec<Contact>, &State)| {
            let pushing = contacts.iter().zip(&shown.pairs).filter(|(contact, _)| contact.force >= shown.least);
            pushing
                .filter_map(|(contact, &pair)| self.arrow(pair, contact.force, &state.pose(), shown.tau))
                .flatten()
                .collect()
        };
        let steps = if shown.in_full { scenario.contacts.len() } else { 0 };
        let wrenches = scenario.wrenches.iter().take(steps);
        let contacts = scenario.contacts.iter().zip(&scenario.states[1..]).take(steps);
        ScenarioData {
            offset: all(offset, LENGTH),
            rotation: all(rotation, ANGLE),
            disturbances: Vec::new(),
            errors: all(measures.errors, LENGTH),
            success: self.success.reached(measures.errors[0], measures.errors[1]),
            poses: scenario.states.iter().flat_map(|state| pose(&state[..7])).collect(),
            wrenches: wrenches.flat_map(|wrench| wrench.0).map(|component| rounded(component, FORCE)).collect(),
            distances: distances.map(|distance| rounded(distance, LENGTH)).collect(),
            forces: scenario.contacts.iter().map(|contacts| rounded(largest_force(contacts), FORCE)).collect(),
            max_force: rounded(measures.max_force, FORCE),
            measured: Vec::new(),
            contacts: contacts.map(pushing).collect(),
        }
    }

    /// Smallest distance of all pairs at a pose; not a number where none can be computed.
    fn distance(&self, pose: &Pose, shown: &Shown) -> f64 {
        let contacts = shown.pairs.iter().filter_map(|&pair| self.contact(pair, pose, shown.tau));
        contacts.map(|[distance, ..]| distance).fold(f64::NAN, f64::min)
    }

    /// Pair, force, point and direction of a contact force on the body; none where the distance cannot be computed.
    fn arrow(&self, pair: usize, force: f64, pose: &Pose, tau: f64) -> Option<[f64; 8]> {
        let [_, nx, ny, nz, _, _, _, x, y, z] = self.contact(pair, pose, tau)?;
        // A smoothed normal may be shorter than one.
        let normal = Vector3::new(nx, ny, nz).try_normalize(0.0)?;
        let ([x, y, z], [nx, ny, nz]) = (all([x, y, z], LENGTH), all(normal.into(), 3));
        Some([pair as f64, rounded(force, FORCE), x, y, z, nx, ny, nz])
    }

    /// Distance, contact normal and contact point of a pair; none where they cannot be computed.
    fn contact(&self, pair: usize, pose: &Pose, tau: f64) -> Option<[f64; 10]> {
        let mut contact = [[0.0; 10]];
        self.pairs[pair].shapes.contacts(&[pose.0], tau, &mut Solutions::default(), &mut contact).ok()?;
        Some(contact[0])
    }
}

/// Force of the pair that pushes most.
fn largest_force(contacts: &[Contact]) -> f64 {
    contacts.iter().map(|contact| contact.force).fold(0.0, f64::max)
}

/// Offset (m, body frame) and rotation error (rad) of a body with an actual and a believed pose.
fn grasp_error(believed: &Pose, actual: &Pose) -> ([f64; 3], [f64; 3]) {
    let to_body = actual.orientation().inverse();
    let offset = to_body * (believed.position() - actual.position());
    let rotation = (to_body * believed.orientation()).scaled_axis();
    (offset.into(), rotation.into())
}

#[cfg(test)]
mod tests {
    use task::GraspError;

    use super::*;

    #[test]
    fn grasp_errors_are_read_from_where_the_body_starts() {
        let believed = Pose([0.1, 0.2, 0.3, 0.6, 0.0, 0.8, 0.0]);
        let grasp = GraspError { offset: [0.01, -0.02, 0.03], rotation: [0.1, 0.05, -0.2] };
        let (offset, rotation) = grasp_error(&believed, &grasp.actual(&believed));
        for axis in 0..3 {
            assert!((offset[axis] - grasp.offset[axis]).abs() < 1e-12, "{offset:?}");
            assert!((rotation[axis] - grasp.rotation[axis]).abs() < 1e-12, "{rotation:?}");
        }
    }
}

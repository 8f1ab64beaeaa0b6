//! Duration, forces and departures of a plan: the section `motion` of `result.json`.

use serde::{Deserialize, Serialize};
use task::{AssemblyTask, Contact, Departure, ScenarioTrajectory, State, StraightMotion, Trajectory};

use crate::or_null;

/// A body that no pair pushes with more than this is in free air (N): smoothed contacts push a little at a distance.
const FREE_FORCE: f64 = 0.1;

/// Visible properties of a plan: its duration, its largest force, and its departure from the straight motion to the
/// goal. Each scenario is compared with the straight motion from where its body starts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MotionRecord {
    /// Duration of the reference.
    pub duration_s: f64,
    /// Largest normal force of a pair, the mean over 10 ms, in any scenario and in any rollout of its test.
    #[serde(with = "or_null")]
    pub max_force_n: f64,
    /// Largest angle to the orientation of the nearest pose of the straight motion, of the reference and all bodies.
    pub rotation: Extreme,
    /// Largest distance from the straight path, of all bodies.
    pub departure: Extreme,
    /// The same in free air.
    pub free_departure: Extreme,
}

/// A largest value and when it occurs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Extreme {
    /// The value (m or rad).
    #[serde(with = "or_null")]
    pub largest: f64,
    /// When it is reached.
    pub time_s: f64,
}

impl MotionRecord {
    /// From a plan of a task.
    pub fn new(motion: &Trajectory, task: &AssemblyTask) -> Self {
        let largest = |values: &mut dyn Iterator<Item = (usize, f64)>| Extreme::of(values, motion.time_step);
        let reference = departures(&motion.reference, task);
        let bodies: Vec<(&ScenarioTrajectory, Vec<Departure>)> =
            motion.scenarios.iter().map(|scenario| (scenario, departures(&scenario.states, task))).collect();
        let of_bodies = || bodies.iter().flat_map(|(_, departures)| departures.iter().enumerate());
        let free = bodies.iter().flat_map(|(scenario, departures)| {
            let is_free = |step: &usize| is_free(*step, &scenario.contacts);
            departures.iter().enumerate().filter(move |(step, _)| is_free(step))
        });
        let distance = |(step, departure): (usize, &Departure)| (step, departure.distance);
        let rotation = |(step, departure): (usize, &Departure)| (step, departure.rotation);
        Self {
            duration_s: (motion.reference.len() - 1) as f64 * motion.time_step,
            max_force_n: motion.scenarios.iter().map(|scenario| scenario.quality.max_force).fold(0.0, f64::max),
            rotation: largest(&mut reference.iter().enumerate().chain(of_bodies()).map(rotation)),
            departure: largest(&mut of_bodies().map(distance)),
            free_departure: largest(&mut free.map(distance)),
        }
    }
}

impl Extreme {
    /// The first of the largest values, given with their steps. Not a number counts as the largest.
    fn of(values: &mut dyn Iterator<Item = (usize, f64)>, time_step: f64) -> Self {
        let largest = values.fold(
            (0, 0.0),
            |(at, largest), (step, value)| {
                if value <= largest { (at, largest) } else { (step, value) }
            },
        );
        Self { largest: largest.1, time_s: largest.0 as f64 * time_step }
    }
}

/// How far states at k = 0..N are from the straight motion from the first of them to the goal.
fn departures(states: &[State], task: &AssemblyTask) -> Vec<Departure> {
    let straight = StraightMotion::new(&states[0].pose(), &task.goal);
    states.iter().map(|state| straight.departure(&state.pose())).collect()
}

/// Whether no contact pushes the body in the steps that end and begin at a state; contacts are those at k = 1..N.
fn is_free(step: usize, contacts: &[Vec<Contact>]) -> bool {
    let steps = contacts.iter().take(step + 1).skip(step.saturating_sub(1));
    steps.flatten().all(|contact| contact.force <= FREE_FORCE)
}

#[cfg(test)]
mod tests {
    use task::{GraspError, Pose};

    use super::*;
    use crate::problem::{Choices, Problem};
    use crate::testing::corner;

    /// At a height above the goal of the corner scene and beside the straight path (m), rotated about it (rad).
    fn state(goal: &Pose, height: f64, aside: f64, turn: f64) -> State {
        let mut pose = *goal;
        pose.0[1] += aside;
        pose.0[2] += height;
        pose.0[3..].copy_from_slice(&[(0.5 * turn).cos(), 0.0, 0.0, (0.5 * turn).sin()]);
        pose.at_rest()
    }

    #[test]
    fn rotations_and_departures_are_those_from_the_straight_motion() {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let task = problem.task();
        let state = |height: f64, aside: f64, turn: f64| state(&task.goal, height, aside, turn);
        let reference = [state(0.1, 0.0, 0.0), state(0.05, 0.0, 0.3), state(0.0, 0.0, 0.0), state(0.0, 0.0, 0.0)];
        // Its path starts 10 mm aside, so that it is 5 mm from the straight one halfway.
        let body = [state(0.1, 0.01, 0.0), state(0.05, 0.01, 0.1), state(0.0, 0.007, 0.0), state(0.0, 0.0, 0.0)];
        let forces = [0.0, 5.0, 20.0];
        let grasp = GraspError::from([0.0, 0.01, 0.0]);
        let force = |step: usize| vec![forces[step - 1], 0.0].into_iter();
        let scenario = ScenarioTrajectory::new(task, grasp, 0.5, &reference, &body, force, 0.0);
        let motion = MotionRecord::new(&Trajectory::new(0.5, &reference, vec![scenario], 0.0), task);
        assert_eq!((motion.duration_s, motion.max_force_n), (1.5, 20.0));
        let close = |Extreme { largest, time_s }: Extreme, value: f64, time: f64| {
            (largest - value).abs() < 1e-4 * value && (time_s - time).abs() < 1e-12
        };
        assert!(close(motion.rotation, 0.3, 0.5), "of the reference: {:?}", motion.rotation);
        assert!(close(motion.departure, 0.006_965_26, 1.0), "{:?}", motion.departure);
        assert!(motion.free_departure.largest == 0.0, "in the second step it touches: {:?}", motion.free_departure);
    }

    #[test]
    fn a_departure_that_is_no_number_is_the_largest() {
        let largest = Extreme::of(&mut [(1, 0.3), (2, f64::NAN), (3, f64::INFINITY)].into_iter(), 0.1);
        assert!(!(largest.largest <= 1.0), "{largest:?}");
    }
}

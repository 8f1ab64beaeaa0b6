//! Rollouts as trajectories of the planner.

use simulation::{Rollout, Settings};
use task::Limits;

use crate::world::{block, hole, task, through};

const PATH: [[f64; 3]; 2] = [[0.0015, 0.0, 0.06], [0.0015, 0.0, 0.0]];

fn rollout() -> Rollout {
    Rollout::new(&task(&block([0.04, 0.04, 0.08], [0.0; 3]), &hole(0.042)), Settings::default())
}

#[test]
fn a_trajectory_has_the_states_and_the_outcome_of_its_rollout() {
    let (rollout, reference, offset) = (rollout(), through(&PATH, 1.0), [0.001, 0.0, 0.0]);
    let trajectory = rollout.trajectory(&reference, &[offset], 1e-5);
    let scenario = &trajectory.scenarios[0];
    assert_eq!((scenario.states.len(), scenario.contacts.len(), scenario.wrenches.len()), (26, 25, 25));
    assert!((scenario.states[0][0] - 0.0005).abs() < 1e-12);
    let outcome = rollout.play(&reference, offset, |_, _| {});
    assert_eq!(scenario.quality.position_error, outcome.position_error);
    assert_eq!(scenario.quality.max_force, outcome.loads.contact_force);
}

/// The task's own time step is 0.04 s.
#[test]
fn accelerations_are_those_of_the_reference_time_step() {
    for seconds in [1.0, 0.5] {
        let reference = through(&PATH, seconds);
        let trajectory = rollout().trajectory(&reference, &[[0.0; 3], [0.001, 0.0, 0.0]], 1e-5);
        for scenario in &trajectory.scenarios {
            let largest = |axes: std::ops::Range<usize>| {
                let pairs =
                    scenario.states.windows(2).flat_map(|pair| axes.clone().map(|axis| pair[1][axis] - pair[0][axis]));
                pairs.map(|change| change.abs() / (seconds / 25.0)).fold(0.0, f64::max)
            };
            let Limits { translational_acceleration, rotational_acceleration, .. } = scenario.keeps;
            assert!(largest(7..10) > 0.1, "the body accelerates");
            assert!((translational_acceleration / largest(7..10) - 1.0).abs() < 1e-12);
            assert!((rotational_acceleration - largest(10..13)).abs() < 1e-12);
        }
    }
}

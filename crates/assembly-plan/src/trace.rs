//! The course of one rollout as a table with the columns of `reference.csv`.

use simulation::{GraspError, Reference, Rollout, TimedState};

use crate::failure::Failure;
use crate::output::{STATE_COLUMNS, in_seconds, table};

/// Time and state of the body at the start and after every time step, as CSV.
pub fn trace(rollout: &Rollout, reference: &Reference, grasp: &GraspError) -> Result<Vec<u8>, Failure> {
    let start = TimedState { time: 0.0, pose: grasp.start(reference), velocity: [0.0; 3], angular_velocity: [0.0; 3] };
    let mut rows = vec![row(&start)];
    rollout.play(reference, *grasp, |moment, _| rows.push(row(moment)));
    table(std::iter::once("time_s").chain(STATE_COLUMNS), rows.into_iter())
}

fn row(moment: &TimedState) -> Vec<String> {
    std::iter::once(in_seconds(moment.time)).chain(moment.state().iter().map(f64::to_string)).collect()
}

//! The course of one rollout as a table with the columns of `reference.csv`.

use simulation::{Grasp, Reference, Rollout};

use crate::failure::Failure;
use crate::output::{STATE_COLUMNS, in_seconds, table};

/// Time and state of the body at the start and after every time step, as CSV.
pub fn trace(rollout: &Rollout, reference: &Reference, grasp: &Grasp) -> Result<Vec<u8>, Failure> {
    let at_rest = [0.0; 6];
    let mut rows = vec![row(0.0, &grasp.start(reference), &at_rest)];
    rollout.play(reference, *grasp, |moment, _| {
        let [vx, vy, vz] = moment.velocity;
        let [p, q, r] = moment.spin;
        rows.push(row(moment.time, &moment.pose, &[vx, vy, vz, p, q, r]));
    });
    table(std::iter::once("time_s").chain(STATE_COLUMNS), rows.into_iter())
}

fn row(time: f64, pose: &[f64; 7], twist: &[f64; 6]) -> Vec<String> {
    std::iter::once(in_seconds(time)).chain(pose.iter().chain(twist).map(f64::to_string)).collect()
}

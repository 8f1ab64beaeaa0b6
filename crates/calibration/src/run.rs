//! A log in the form in which rollouts play and are compared with it.

use nalgebra::{Isometry3, Vector3};
use planner::{Millimetres, PlannerError, Problem};
use simulation::{Reference, coordinates, interpolate, isometry};
use task::{AssemblyTask, GraspError, Impedance, STATE};

use crate::deviation::{COMPONENTS, deviation};
use crate::log::{Log, Row};

/// Time between two samples that are compared (s), at least: closer ones say the same.
const SAMPLE_INTERVAL: f64 = 0.01;

/// A log that is compared with rollouts.
#[derive(Debug, Clone)]
pub struct Run {
    /// Name of its file.
    pub name: String,
    /// The world that it was played in, with the gains that were set; without pairs of parts in free air.
    pub task: AssemblyTask,
    /// What the robot followed, from where it believed the part at first.
    pub reference: Reference,
    /// Times (s) and poses where the robot believed the part.
    pub samples: Vec<(f64, Isometry3<f64>)>,
    /// Deviations of the robot from its reference at these times (m, rad).
    pub lags: Vec<[f64; COMPONENTS]>,
    /// The grasp error, as far as the end of the log tells.
    pub grasp: GraspError,
}

impl Run {
    /// Of a log. The reference has a step for each control period of an arm, else for each row.
    ///
    /// # Errors
    /// When the part did not end at its goal, so that nobody knows how it sat in the gripper.
    pub fn new(log: &Log, problem: &Problem) -> Result<Self, PlannerError> {
        let mut task = AssemblyTask { impedance: Impedance::from(&log.impedance), ..problem.world() };
        let mut grasp = GraspError::default();
        if log.dry_run > 0.0 {
            task.pairs.clear();
        } else {
            grasp = grasp_at_end(log, problem)?;
        }
        let robot = problem.scene().robot.as_ref();
        let time_step = robot.map_or_else(|| median_gap(log), |robot| robot.control_period);
        let reference = reference(&log.rows, time_step);
        task.start = reference.start();
        let every = (SAMPLE_INTERVAL / time_step).round().max(1.0) as usize;
        let (mut samples, mut lags) = (Vec::new(), Vec::new());
        for knot in (every..reference.intervals()).step_by(every) {
            let time = knot as f64 * time_step;
            let believed = believed(&log.rows, time);
            samples.push((time, believed));
            lags.push(deviation(&believed, &reference.at(knot, 0.0).pose));
        }
        let name = log.file.display().to_string();
        Ok(Self { name, task, reference, samples, lags, grasp })
    }

    /// Whether the parts could touch.
    pub fn has_contact(&self) -> bool {
        !self.task.pairs.is_empty()
    }
}

/// A part at its goal is believed beside it by the grasp error.
fn grasp_at_end(log: &Log, problem: &Problem) -> Result<GraspError, PlannerError> {
    let end = log.rows.last().map_or_else(Isometry3::identity, |row| row.believed);
    let grasp = GraspError::of_believed(&(isometry(&problem.scene().goal).inverse() * end));
    let (length, most) = (Vector3::from(grasp.offset).norm(), log.delta + problem.success().position);
    if length > most {
        let problem = format!(
            "the part did not end at its goal, or sat {} mm beside where it was believed, more than the {} mm that the \
             plan bears: leave this log out",
            Millimetres(length),
            Millimetres(most)
        );
        return Err(PlannerError::file(&log.file, problem));
    }
    Ok(grasp)
}

/// Median of the times between two rows (s).
fn median_gap(log: &Log) -> f64 {
    let mut gaps: Vec<f64> = log.rows.windows(2).map(|pair| pair[1].time - pair[0].time).collect();
    gaps.sort_by(f64::total_cmp);
    gaps[gaps.len() / 2]
}

/// The reference on a regular grid: that of a row holds until the next one. It begins where the part was believed, where
/// rollouts start at rest.
fn reference(rows: &[Row], time_step: f64) -> Reference {
    let last = rows.last().map_or(0.0, |row| row.time);
    let mut states: Vec<[f64; STATE]> = Vec::new();
    for knot in 0..=(last / time_step).ceil() as usize {
        let mut state = rows[row_at(rows, knot as f64 * time_step)].reference;
        // The twist of a knot is that of the way to it.
        if let Some(before) = knot.checked_sub(1) {
            state[7..].copy_from_slice(&rows[row_at(rows, before as f64 * time_step)].reference[7..]);
        }
        states.push(state);
    }
    states[0][..7].copy_from_slice(&coordinates(&rows[0].believed));
    Reference::new(time_step, &states)
}

/// Index of the last row at or before a time (s).
fn row_at(rows: &[Row], time: f64) -> usize {
    /// Times are written to a microsecond.
    const ROUNDING: f64 = 1e-5;
    rows.partition_point(|row| row.time <= time + ROUNDING).saturating_sub(1)
}

/// Where the part was believed at a time (s).
fn believed(rows: &[Row], time: f64) -> Isometry3<f64> {
    let index = row_at(rows, time);
    let (from, Some(to)) = (&rows[index], rows.get(index + 1)) else { return rows[index].believed };
    let fraction = ((time - from.time) / (to.time - from.time)).clamp(0.0, 1.0);
    interpolate(&from.believed, &to.believed, fraction)
}

//! What a robot did, beside what a rollout does with the grasp error that there was.

use std::path::Path;

use nalgebra::Isometry3;
use serde::Deserialize;
use simulation::{Reference, Settings, isometry};
use task::{GraspError, pose_of};

use crate::error::PlannerError;
use crate::files::{StateRow, read_csv};
use crate::problem::Problem;

/// The phase of a log in which the plan was executed.
const PLAYING: &str = "playing";
/// The phase with which a log ends unless the robot was stopped.
pub const RESTING: &str = "resting";

/// How a motion was executed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Execution {
    /// How the part sits in the gripper, if it ended at its goal.
    pub grasp: GraspError,
    /// Whether that was planned for: no longer than the plan's offsets and the tolerance of success.
    pub is_planned: bool,
    /// Whether a rollout with this grasp error reaches the goal.
    pub rollout_succeeds: bool,
    /// Largest distance (m) between where the robot and the rollout believe the part at one time, and that time (s).
    pub largest_distance: (f64, f64),
    /// Mean of these distances (m).
    pub mean_distance: f64,
}

#[derive(Deserialize)]
struct PhaseRow {
    phase: String,
}

impl Execution {
    /// Of the log of a player: the columns of `reference.csv` with where the robot believed the part, and `phase`.
    ///
    /// # Errors
    /// When the log cannot be read or has no executed plan, or a rollout cannot be made.
    pub fn read(
        file: &Path,
        problem: &Problem,
        reference: &Reference,
        settings: Settings,
    ) -> Result<Self, PlannerError> {
        let (rows, phases) = (read_csv::<StateRow>(file)?, read_csv::<PhaseRow>(file)?);
        let pose = |row: &StateRow| isometry(&pose_of(&row.state()));
        let began = phases.iter().position(|row| row.phase == PLAYING);
        let Some(began) = began else {
            return Err(PlannerError::file(
                file,
                format!("no row has the phase `{PLAYING}`: the plan was not executed"),
            ));
        };
        let executed: Vec<(f64, Isometry3<f64>)> = rows[began..]
            .iter()
            .zip(&phases[began..])
            .take_while(|(_, row)| row.phase == PLAYING)
            .map(|(row, _)| (row.time(), pose(row)))
            .collect();
        let rested = phases.last().is_some_and(|row| row.phase == RESTING);
        if !rested {
            return Err(PlannerError::file(
                file,
                "the execution was stopped before its end: there is nothing to compare",
            ));
        }
        let end = rows.last().map_or_else(Isometry3::identity, pose);
        let grasp = GraspError::of_believed(&(isometry(&problem.scene().goal).inverse() * end));
        let tolerance = problem.success().position;
        let length = grasp.offset.iter().map(|component| component * component).sum::<f64>().sqrt();

        let mut believed = Vec::new();
        let rollout = problem.rollout(settings)?;
        let outcome = rollout.play(reference, grasp, |state, _| {
            believed.push((state.time, isometry(&state.pose) * grasp.believed()));
        });
        let distances: Vec<(f64, f64)> =
            executed.iter().filter_map(|(time, pose)| distance(&believed, *time, pose)).collect();
        let largest = distances.iter().copied().max_by(|one, other| one.0.total_cmp(&other.0));
        let sum: f64 = distances.iter().map(|(distance, _)| distance).sum();
        Ok(Self {
            grasp,
            is_planned: length <= problem.delta() + tolerance,
            rollout_succeeds: outcome.reaches_goal(&problem.success()),
            largest_distance: largest.unwrap_or_default(),
            mean_distance: sum / distances.len().max(1) as f64,
        })
    }
}

/// Distance to the first pose at or after a time, with the time.
fn distance(course: &[(f64, Isometry3<f64>)], time: f64, pose: &Isometry3<f64>) -> Option<(f64, f64)> {
    let (_, other) = course.get(course.partition_point(|(at, _)| *at < time))?;
    Some(((other.translation.vector - pose.translation.vector).norm(), time))
}

//! How far the body can move from a pose before it touches something.

use nalgebra::Vector3;
use serde::Serialize;
use task::{AssemblyTask, Pose};

use crate::clearance::Clearance;

/// Directions along which clearance is measured: the axes of the world, both ways.
const AXES: [&str; 3] = ["x", "y", "z"];
/// Poses on the straight line from the goal to the start.
const POSES: usize = 5;
/// Travel that is looked at, in offsets and in sizes of the body's path.
const OFFSETS: f64 = 3.0;
const PATH: f64 = 0.1;

/// Distances that the body can move along an axis of the world; null where nothing stops it within the range of the
/// search.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisClearance {
    /// `x`, `y` or `z`.
    pub axis: &'static str,
    /// Against the axis (m).
    pub backward_m: Option<f64>,
    /// Along the axis (m).
    pub forward_m: Option<f64>,
}

/// Clearances at a pose on the straight line from the goal to the start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PoseClearance {
    /// Distance from the goal (m).
    pub distance_from_goal_m: f64,
    /// Smallest exact distance of all pairs (m), negative where parts penetrate.
    pub clearance_m: f64,
    /// Along each axis of the world.
    pub axes: Vec<AxisClearance>,
}

impl PoseClearance {
    /// Smallest travel between two stops along an axis (m), if something stops the body on both sides of any.
    pub fn narrowest(&self) -> Option<f64> {
        let both = self.axes.iter().filter_map(|axis| Some(axis.backward_m? + axis.forward_m?));
        both.min_by(f64::total_cmp)
    }
}

/// Length of the largest offset of a scenario (m).
pub fn largest_offset(task: &AssemblyTask) -> f64 {
    task.offsets().iter().map(|offset| Vector3::from(*offset).norm()).fold(0.0, f64::max)
}

/// Longest travel that is looked at (m).
pub fn longest_travel(task: &AssemblyTask) -> f64 {
    (OFFSETS * largest_offset(task)).max(PATH * (task.start.position() - task.goal.position()).norm())
}

/// Clearance at the goal and at some poses on the path to it.
pub fn along_insertion(task: &AssemblyTask) -> Vec<PoseClearance> {
    let mut clearance = Clearance::new(task);
    (0..POSES).map(|index| at(task, &mut clearance, index as f64 / (POSES - 1) as f64)).collect()
}

/// The pose at a share of the path from the goal to the start, oriented as the goal.
pub fn between(task: &AssemblyTask, share: f64) -> Pose {
    let mut pose = task.goal;
    (0..3).for_each(|axis| pose.0[axis] += share * (task.start[axis] - task.goal[axis]));
    pose
}

/// Clearance at a share of the path from the goal to the start.
fn at(task: &AssemblyTask, clearance: &mut Clearance, share: f64) -> PoseClearance {
    let (pose, longest) = (between(task, share), longest_travel(task));
    let from = pose.position();
    let axes = AXES.iter().enumerate().map(|(axis, name)| {
        let mut along = |sign: f64| clearance.travel(&from, &(sign * Vector3::ith(axis, 1.0)), longest);
        AxisClearance { axis: name, backward_m: along(-1.0), forward_m: along(1.0) }
    });
    let axes = axes.collect();
    PoseClearance {
        distance_from_goal_m: (from - task.goal.position()).norm(),
        clearance_m: task.clearance(&pose),
        axes,
    }
}

//! How far the body can move from a pose before it touches something.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use serde::Serialize;
use task::AssemblyTask;

/// Directions along which play is measured: the axes of the world, both ways.
const AXES: [&str; 3] = ["x", "y", "z"];
/// A body this near (share of the longest travel looked at) touches.
const TOUCHING: f64 = 1e-4;
/// Steps along a direction, each as long as the smallest distance allows; along a wall they are short.
const MOST_STEPS: usize = 200;
/// Directions across the insertion.
const DIRECTIONS: usize = 16;
/// Poses on the straight line from the goal to the start.
const POSES: usize = 5;
/// Travel that is looked at, in offsets and in sizes of the body's path.
const OFFSETS: f64 = 3.0;
const PATH: f64 = 0.1;

/// How far the body can move along an axis of the world; null where nothing is in the way within the travel looked at.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisPlay {
    /// `x`, `y` or `z`.
    pub axis: &'static str,
    /// Against the axis (m).
    pub backward_m: Option<f64>,
    /// Along the axis (m).
    pub forward_m: Option<f64>,
}

/// Play at a pose on the straight line from the goal to the start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Play {
    /// Distance from the goal (m).
    pub distance_from_goal_m: f64,
    /// Smallest exact distance of all pairs (m), negative where parts overlap.
    pub clearance_m: f64,
    /// Along each axis of the world.
    pub axes: Vec<AxisPlay>,
}

impl Play {
    /// Smallest way between two stops along an axis (m), if something stops the body on both sides of any.
    pub fn narrowest(&self) -> Option<f64> {
        let both = self.axes.iter().filter_map(|play| Some(play.backward_m? + play.forward_m?));
        both.min_by(f64::total_cmp)
    }
}

/// Longest travel that is looked at (m).
pub fn longest_travel(task: &AssemblyTask) -> f64 {
    let norm = |vector: &[f64]| vector.iter().map(|component| component * component).sum::<f64>().sqrt();
    let offset = task.offsets().iter().map(|offset| norm(offset)).fold(0.0, f64::max);
    let path: [f64; 3] = std::array::from_fn(|axis| task.start[axis] - task.goal[axis]);
    (OFFSETS * offset).max(PATH * norm(&path))
}

/// Play at the goal and at some poses on the way to it.
pub fn along_insertion(task: &AssemblyTask) -> Vec<Play> {
    (0..POSES).map(|index| play(task, &between(task, index as f64 / (POSES - 1) as f64))).collect()
}

/// The pose at a share of the way from the goal to the start, oriented as the goal.
pub fn between(task: &AssemblyTask, share: f64) -> [f64; 7] {
    let mut pose = task.goal;
    (0..3).for_each(|axis| pose[axis] += share * (task.start[axis] - task.goal[axis]));
    pose
}

fn play(task: &AssemblyTask, pose: &[f64; 7]) -> Play {
    let distance = (0..3).map(|axis| (pose[axis] - task.goal[axis]).powi(2)).sum::<f64>().sqrt();
    let axes = AXES.iter().enumerate().map(|(axis, name)| {
        let along = |sign: f64| {
            let mut direction = [0.0; 3];
            direction[axis] = sign;
            travel(task, pose, &direction)
        };
        AxisPlay { axis: name, backward_m: along(-1.0), forward_m: along(1.0) }
    });
    Play { distance_from_goal_m: distance, clearance_m: task.clearance(pose), axes: axes.collect() }
}

/// How far the body moves along a direction until it touches something (m), if it does within the longest travel.
pub fn travel(task: &AssemblyTask, pose: &[f64; 7], direction: &[f64; 3]) -> Option<f64> {
    let longest = longest_travel(task);
    let mut travelled = 0.0;
    for _ in 0..MOST_STEPS {
        let mut moved = *pose;
        (0..3).for_each(|axis| moved[axis] += travelled * direction[axis]);
        // No motion shorter than the smallest distance of all pairs makes them touch.
        let clearance = task.clearance(&moved);
        if clearance <= TOUCHING * longest {
            return Some(travelled + clearance.max(0.0));
        }
        travelled += clearance;
        if travelled > longest {
            break;
        }
    }
    None
}

/// The farthest that play lets the body rest from its goal (m): across the insertion, where something stops it in all
/// directions.
pub fn farthest_rest(task: &AssemblyTask) -> Option<f64> {
    let way = Vector3::from_fn(|axis, _| task.start[axis] - task.goal[axis]).try_normalize(f64::EPSILON)?;
    let right = way.cross(&Vector3::ith(way.iamin(), 1.0)).normalize();
    let up = way.cross(&right);
    let mut farthest = 0.0f64;
    for index in 0..DIRECTIONS {
        let angle = TAU * index as f64 / DIRECTIONS as f64;
        let direction = right * angle.cos() + up * angle.sin();
        farthest = farthest.max(travel(task, &task.goal, &direction.into())?);
    }
    Some(farthest)
}

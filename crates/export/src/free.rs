//! Free air: poses at which the part touches nothing, whatever its grasp error.

use nalgebra::{Isometry3, Vector3};
use plan::Problem;
use plan::carried::{CarriedWorld, Frames};
use serde::Serialize;
use task::{AssemblyTask, Pose, State};

use crate::arm_room::ArmStart;
use crate::joints::{Held, course, shifted};

/// Largest height of a dry run (m), and how close heights are looked at (m).
const HIGHEST: f64 = 0.3;
const RESOLUTION: f64 = 0.002;
/// Heights at which the clearance of the start is written (m).
const CLEARANCES: f64 = 0.01;
/// Margin besides offset and rotation error of the part (m).
const MARGIN: f64 = 0.005;
/// Where joint friction can hold the tool further away than this (m, rad), the arm is too close to a singular configuration.
const LARGEST_HELD: Held = Held { distance: 0.01, angle: 0.06 };

/// Heights of dry runs in free air, and the free space around the start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FreeAir {
    /// Intervals of heights (m) of a dry run at which nothing touches and the arm can move: first and last.
    pub heights_m: Vec<[f64; 2]>,
    /// Distance that stays free besides this, for offset and rotation error of the part (m).
    pub margin_m: f64,
    /// Farthest point of the part from the tool point (m): a rotation by an angle moves no point by more than this
    /// times it.
    pub radius_m: f64,
    /// Pairs of a height (m) and of how far (m) the part may move from the start of the reference, shifted by it, before
    /// it may touch something.
    pub start_clearance_m: Vec<[f64; 2]>,
    /// The arm at the start, at several heights from 0 on; none without an arm.
    pub arm_starts: Vec<ArmStart>,
}

impl FreeAir {
    /// Around the reference of a problem; `grasp` is the part in the tool.
    pub fn new(problem: &Problem, states: &[State], time_step: f64, grasp: &Isometry3<f64>) -> Self {
        let world = problem.world();
        let radius_m = farthest_point(&world, &grasp.inverse());
        let rotation = problem.scene().robustness.rotation_error * farthest_point(&world, &Isometry3::identity());
        let margin_m = problem.offset_magnitude() + rotation + MARGIN;
        let poses: Vec<Pose> = states.iter().map(State::pose).collect();
        let out = way_out(&poses, grasp);
        let carried = CarriedWorld::new(problem.scene());
        let arm_start = |height: f64| {
            let robot = problem.scene().robot.as_ref()?;
            let states = shifted(states, &(height * out.unwrap_or_default()));
            let course = course(robot, time_step, &states).ok()?;
            let first = course.configurations.first()?;
            ArmStart::new(problem.scene(), carried.as_ref(), margin_m, radius_m, height, first)
        };
        let heights = clearance_heights().take_while(|height| out.is_some() || *height == 0.0);
        let arm_starts = heights.filter_map(arm_start).collect();
        let Some(out) = out else {
            let clearance = world.clearance(&poses[0]) - margin_m;
            return Self {
                heights_m: Vec::new(),
                margin_m,
                radius_m,
                start_clearance_m: vec![[0.0, clearance]],
                arm_starts,
            };
        };
        let at = |pose: &Pose, height: f64| {
            let mut isometry = pose.isometry();
            isometry.translation.vector += height * out;
            Pose::from(&isometry)
        };
        let room = |height: f64| {
            let room_at = |pose: &Pose| world.clearance(&at(pose, height)) - margin_m;
            poses.iter().map(room_at).fold(f64::INFINITY, f64::min)
        };
        let is_free = |frames: Vec<Frames>| carried.as_ref().is_none_or(|carried| carried.is_free(&frames, margin_m));
        let can_move = |height: f64| {
            let Some(robot) = &problem.scene().robot else {
                return is_free(poses.iter().map(|pose| Frames::of_body(at(pose, height).isometry())).collect());
            };
            let states = shifted(states, &(height * out));
            course(robot, time_step, &states).is_ok_and(|course| {
                let held = Held::along(robot, &problem.task().impedance, &course);
                held.distance <= LARGEST_HELD.distance
                    && held.angle <= LARGEST_HELD.angle
                    && is_free(Frames::along(robot, &course.configurations))
            })
        };
        let start_clearance_m = clearance_heights()
            .map(|height| [height, (world.clearance(&at(&poses[0], height)) - margin_m).min(HIGHEST)])
            .collect();
        Self { heights_m: intervals(room, can_move), margin_m, radius_m, start_clearance_m, arm_starts }
    }

    /// A height for a dry run (m), if there is one.
    pub fn height(&self) -> Option<f64> {
        self.heights_m.first().map(|[low, high]| ((low / 0.005).ceil() * 0.005).min(*high))
    }
}

/// Heights (m) at which the room around the start is looked at.
fn clearance_heights() -> impl Iterator<Item = f64> {
    (0..=(HIGHEST / CLEARANCES) as usize).map(|index| index as f64 * CLEARANCES)
}

/// Direction of dry runs in the world, from the tool's last pose to its first.
pub fn way_out(poses: &[Pose], grasp: &Isometry3<f64>) -> Option<Vector3<f64>> {
    /// A reference that ends closer to its start (m) has none.
    const SHORTEST: f64 = 1e-6;
    let tool = |pose: &Pose| (pose.isometry() * grasp.inverse()).translation.vector;
    (tool(poses.first()?) - tool(poses.last()?)).try_normalize(SHORTEST)
}

/// Intervals with enough room: raising a part by a height brings it closer to anything by at most that height.
fn intervals(room: impl Fn(f64) -> f64, can_move: impl Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let mut found: Vec<[f64; 2]> = Vec::new();
    let (mut height, mut is_open) = (0.0, false);
    while height <= HIGHEST {
        let free = room(height);
        let is_free = free >= 0.0 && can_move(height);
        match found.last_mut() {
            Some(interval) if is_free && is_open => interval[1] = height,
            _ if is_free => found.push([height, height]),
            _ => {}
        }
        is_open = is_free;
        // In between, there is room too, or none.
        height += if is_free { RESOLUTION } else { (-free).max(RESOLUTION) };
    }
    found
}

/// Farthest point (m) of the part from the origin of a frame in it.
fn farthest_point(world: &AssemblyTask, frame: &Isometry3<f64>) -> f64 {
    let origin = frame.translation.vector;
    let points = world.pairs.iter().flat_map(|pair| pair.shapes.body().vertices().iter());
    points.map(|point| (Vector3::from(*point) - origin).norm()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_end_where_there_is_a_ceiling() {
        // Free between 0.05 and 0.1 m, and where the arm can move only.
        let found = intervals(|height| (height - 0.05).min(0.1 - height), |height| height < 0.08);
        assert_eq!(found.len(), 1);
        assert!((found[0][0] - 0.05).abs() <= RESOLUTION && (found[0][1] - 0.08).abs() <= 2.0 * RESOLUTION);
        assert!(intervals(|_| -0.01, |_| true).is_empty());
    }
}

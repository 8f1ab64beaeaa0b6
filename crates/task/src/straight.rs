//! The straight motion between two poses, and how far other poses are from it.

use nalgebra::Isometry3;

use crate::pose::{Pose, interpolate};

/// Straight from one pose to another, rotating about one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightMotion {
    start: Isometry3<f64>,
    goal: Isometry3<f64>,
}

/// How far a pose is from the nearest one of a straight motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Departure {
    /// Distance of the positions (m).
    pub distance: f64,
    /// Angle between the orientations (rad).
    pub rotation: f64,
}

/// A path shorter than this (m) has no direction, and a rotation smaller than this (rad) no axis.
const LEAST: f64 = 1e-12;

impl StraightMotion {
    /// Between two poses, with quaternions of any norm.
    pub fn new(start: &Pose, goal: &Pose) -> Self {
        Self { start: start.isometry(), goal: goal.isometry() }
    }

    /// The pose with the nearest position; where start and goal are at the same place, the one that is as far from the goal
    /// in its orientation.
    pub fn nearest(&self, pose: &Isometry3<f64>) -> Isometry3<f64> {
        let path = self.goal.translation.vector - self.start.translation.vector;
        let angle = self.start.rotation.angle_to(&self.goal.rotation);
        let fraction = if path.norm() > LEAST {
            path.dot(&(pose.translation.vector - self.start.translation.vector)) / path.norm_squared()
        } else if angle > LEAST {
            1.0 - pose.rotation.angle_to(&self.goal.rotation) / angle
        } else {
            1.0
        };
        interpolate(&self.start, &self.goal, fraction.clamp(0.0, 1.0))
    }

    /// How far a pose, with a quaternion of any norm, is from the nearest one.
    pub fn departure(&self, pose: &Pose) -> Departure {
        let pose = pose.isometry();
        let nearest = self.nearest(&pose);
        Departure {
            distance: (pose.translation.vector - nearest.translation.vector).norm(),
            rotation: pose.rotation.angle_to(&nearest.rotation),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At a height (m), shifted aside (m) and rotated about z (rad).
    fn pose(height: f64, aside: f64, turn: f64) -> Pose {
        Pose([aside, 0.0, height, (0.5 * turn).cos(), 0.0, 0.0, (0.5 * turn).sin()])
    }

    fn assert_departs(motion: &StraightMotion, pose: &Pose, distance: f64, rotation: f64) {
        let departure = motion.departure(pose);
        assert!((departure.distance - distance).abs() < 1e-12, "{departure:?}");
        assert!((departure.rotation - rotation).abs() < 1e-9, "{departure:?}");
    }

    #[test]
    fn poses_depart_from_the_nearest_one() {
        let motion = StraightMotion::new(&pose(0.1, 0.0, 0.4), &pose(0.0, 0.0, 0.0));
        assert_departs(&motion, &pose(0.05, 0.0, 0.2), 0.0, 0.0);
        assert_departs(&motion, &pose(0.05, 0.003, 0.5), 0.003, 0.3);
        assert_departs(&motion, &pose(-0.004, 0.003, 0.1), 0.005, 0.1);
        assert_departs(&motion, &pose(0.104, 0.0, 0.4), 0.004, 0.0);
    }

    #[test]
    fn a_motion_in_place_is_followed_by_its_rotation() {
        let turning = StraightMotion::new(&pose(0.0, 0.0, 0.4), &pose(0.0, 0.0, 0.0));
        assert_departs(&turning, &pose(0.0, 0.002, 0.1), 0.002, 0.0);
        let resting = StraightMotion::new(&pose(0.0, 0.0, 0.4), &pose(0.0, 0.0, 0.4));
        assert_departs(&resting, &pose(0.01, 0.0, 0.1), 0.01, 0.3);
    }
}

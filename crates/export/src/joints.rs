//! A motion in the joints of an arm: errors that their friction can hold, and steps of torques.

use nalgebra::{Vector3, Vector6};
use plan::ArmCourse;
use robot::JointVector;
use scene::Robot;
use task::{GraspError, Impedance, State};

use crate::smooth::SmoothReference;

/// How far joint friction can hold the tool from its reference: distance (m) and angle (rad).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Held {
    /// Distance (m).
    pub distance: f64,
    /// Angle (rad).
    pub angle: f64,
}

impl Held {
    /// The larger of each.
    pub fn max(self, other: Self) -> Self {
        Self { distance: self.distance.max(other.distance), angle: self.angle.max(other.angle) }
    }

    /// At joint positions: the largest errors of the pose whose wrench the friction of all joints balances.
    pub fn at(robot: &Robot, impedance: &Impedance, configuration: &JointVector) -> Self {
        let jacobian = robot.arm.at(configuration).jacobian();
        let joints = robot.arm.joints().len();
        let Some(inverse) = (jacobian * jacobian.transpose()).try_inverse() else {
            return Self { distance: f64::INFINITY, angle: f64::INFINITY };
        };
        // Every sign of the friction of every joint: the largest error is at a corner of this box.
        let at_corner = |signs: usize| {
            let friction = JointVector::from_fn(|joint, _| match robot.joint_friction.get(joint) {
                Some(friction) if joint < joints => {
                    if signs >> joint & 1 == 1 {
                        *friction
                    } else {
                        -friction
                    }
                }
                _ => 0.0,
            });
            let wrench = inverse * (jacobian * friction);
            Self {
                distance: wrench.fixed_rows::<3>(0).norm() / impedance.translational_stiffness,
                angle: wrench.fixed_rows::<3>(3).norm() / impedance.rotational_stiffness,
            }
        };
        (0..1 << joints).map(at_corner).fold(Self::default(), Self::max)
    }

    /// Along a course.
    pub fn along(robot: &Robot, impedance: &Impedance, course: &ArmCourse) -> Self {
        course.configurations.iter().map(|at| Self::at(robot, impedance, at)).fold(Self::default(), Self::max)
    }
}

/// Largest step (Nm) of a joint torque between two references that are a millisecond apart, the arm at rest on its
/// reference: stiffness and damping make it of the steps of pose and velocity.
pub fn largest_torque_step(
    robot: &Robot,
    impedance: &Impedance,
    reference: &SmoothReference,
    course: &ArmCourse,
) -> f64 {
    const MILLISECOND: f64 = 1e-3;
    let per_knot = MILLISECOND / reference.time_step();
    let count = (reference.duration() / MILLISECOND).ceil() as usize;
    let largest = |sample: usize| {
        let knots = (sample as f64 * per_knot, (sample + 1) as f64 * per_knot);
        let (from, to) = (reference.at(knots.0), reference.at(knots.1));
        let moved = impedance.translational_stiffness * (to.pose.translation.vector - from.pose.translation.vector);
        let turned = impedance.rotational_stiffness * (from.pose.rotation.inverse() * to.pose.rotation).scaled_axis();
        let braked = impedance.translational_damping * (to.velocity - from.velocity);
        let slowed = impedance.rotational_damping * (to.angular_velocity - from.angular_velocity);
        let wrench = stacked(&(moved + braked), &(turned + slowed));
        let nearest = (knots.0.round() as usize).min(course.configurations.len() - 1);
        robot.arm.at(&course.configurations[nearest]).jacobian().tr_mul(&wrench).amax()
    };
    (0..count).map(largest).fold(0.0, f64::max)
}

/// The joints of an arm that follows states of the part, without a grasp error.
///
/// # Errors
/// When the arm does not reach one of them.
pub fn course(robot: &Robot, time_step: f64, states: &[State]) -> Result<ArmCourse, robot::FollowError> {
    ArmCourse::new(robot, time_step, &GraspError::default(), states, &[])
}

/// Tracking error of a tool on springs: the velocity that damping makes up for (m, rad).
pub fn tracking_error(impedance: &Impedance, speed: f64, turning: f64) -> Held {
    let largest = |matrix: &nalgebra::Matrix3<f64>| matrix.symmetric_eigenvalues().amax();
    Held {
        distance: largest(&impedance.translational_damping) * speed / impedance.translational_stiffness,
        angle: largest(&impedance.rotational_damping) * turning / impedance.rotational_stiffness,
    }
}

/// States of the part, all shifted by a vector (m, world frame).
pub fn shifted(states: &[State], way: &Vector3<f64>) -> Vec<State> {
    let moved = |state: &State| {
        let mut moved = *state;
        (0..3).for_each(|axis| moved.0[axis] += way[axis]);
        moved
    };
    states.iter().map(moved).collect()
}

fn stacked(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
}

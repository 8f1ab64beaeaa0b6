//! How the arm of a scene moves while the body does.

use nalgebra::{Isometry3, Vector3, Vector6};
use robot::{FollowError, JointVector};
use scene::Robot;
use task::{GraspError, State, Wrench};

/// Gravity (m/s^2, world frame).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

/// Joints of an arm along a motion of the body, one entry per knot.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmCourse {
    /// Positions (rad or m).
    pub configurations: Vec<JointVector>,
    /// Commanded torques of the impedance controller plus those that support arm and body (Nm, N for a prismatic
    /// joint).
    pub torques: Vec<JointVector>,
}

impl ArmCourse {
    /// For the arm that holds the body with a grasp error, in its states at k = 0..N and under the wrenches at k = 1..N
    /// (N and Nm, torques in the body frame). The arm moves its tip to the believed pose of the body, not to the
    /// reference.
    ///
    /// # Errors
    /// When the arm does not reach a pose, or a joint is too slow.
    pub fn new(
        robot: &Robot,
        time_step: f64,
        grasp: &GraspError,
        states: &[State],
        wrenches: &[Wrench],
    ) -> Result<Self, FollowError> {
        let believed = grasp.believed();
        let timed = |(knot, state): (usize, &State)| (knot as f64 * time_step, state.pose().isometry() * believed);
        let motion: Vec<(f64, Isometry3<f64>)> = states.iter().enumerate().map(timed).collect();
        // At the goal the scene names the arm's branch.
        let configurations = robot.arm.follow_back(&motion, &robot.configuration)?.configurations;
        let wrenches = std::iter::once(&Wrench::ZERO).chain(wrenches);
        let torque = |(configuration, wrench): (&JointVector, &Wrench)| {
            let torque = believed.rotation.inverse() * wrench.torque();
            let wrench = Vector6::from(Wrench::new(&wrench.force(), &torque).0);
            let configured = robot.arm.at(configuration);
            configured.gravity(&GRAVITY) + configured.jacobian().tr_mul(&wrench)
        };
        let torques = configurations.iter().zip(wrenches).map(torque).collect();
        Ok(Self { configurations, torques })
    }
}

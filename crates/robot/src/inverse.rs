//! Joint positions for poses of the part.

use nalgebra::{Cholesky, Isometry3, Matrix6, Vector6};

use crate::arm::{Arm, ArmError};
use crate::configured::{CHARACTERISTIC_LENGTH, ConfiguredArm};
use crate::joint::{Jacobian, JointVector};

/// Why there are no joint positions for a pose.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InverseError {
    /// Damped Newton steps do not reach the pose.
    #[error(
        "the arm does not reach the pose: it stays {distance:.1e} m and {angle:.1e} rad away; move the base or choose another configuration"
    )]
    NotReached {
        /// Distance that is left (m).
        distance: f64,
        /// Angle that is left (rad).
        angle: f64,
    },
    /// The pose is reached beyond a joint's limits.
    #[error("the arm reaches the pose only beyond a limit: {0}; move the base or choose another configuration")]
    Limit(ArmError),
}

/// Distance (m) and angle (rad) at which a pose is reached.
const TOLERANCE: f64 = 1e-10;
/// Largest number of steps. Poses nearby take less than ten.
const STEPS: usize = 200;
/// Damping when the pose is reached: bounds steps where the arm is singular, and is too little to slow others down.
const LEAST_DAMPING: f64 = 1e-12;

impl Arm {
    /// Joint positions (rad or m) with the part at `pose` in the world frame, on the IK branch of `near`: damped Newton
    /// steps (Levenberg-Marquardt) lead there from these positions. A redundant arm takes the shortest steps. Another
    /// branch may be closer if `near` is more than about 0.3 rad off.
    ///
    /// The damping is half of the squared error (Sugihara, 2011), with translations over [`CHARACTERISTIC_LENGTH`]:
    /// steps are careful far away and converge quadratically at the pose.
    ///
    /// # Errors
    /// When the steps do not converge, or the positions are beyond limits.
    pub fn inverse_kinematics(&self, pose: &Isometry3<f64>, near: &JointVector) -> Result<JointVector, InverseError> {
        let mut configuration = *near;
        let mut steps = 0;
        loop {
            let configured = self.at(&configuration);
            let error = displacement(&configured.pose(), pose);
            let (distance, angle) = (error.fixed_rows::<3>(0).norm(), error.fixed_rows::<3>(3).norm());
            if distance < TOLERANCE && angle < TOLERANCE {
                self.check_limits(&configuration).map_err(InverseError::Limit)?;
                return Ok(configuration);
            }
            let step = newton_step(&configured, &error).filter(|_| steps < STEPS);
            let step = step.ok_or(InverseError::NotReached { distance, angle })?;
            configuration += step;
            steps += 1;
        }
    }
}

/// From one pose to the other: distance in the world frame (m), rotation vector in the body frame (rad).
fn displacement(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Vector6<f64> {
    let shift = to.translation.vector - from.translation.vector;
    let turn = (from.rotation.inverse() * to.rotation).scaled_axis();
    Vector6::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
}

/// `J' (J J' + damping)^-1 error`, the shortest of the damped least-squares steps.
fn newton_step(configured: &ConfiguredArm, error: &Vector6<f64>) -> Option<JointVector> {
    let mut jacobian: Jacobian = configured.jacobian();
    let mut error = *error;
    jacobian.fixed_rows_mut::<3>(0).unscale_mut(CHARACTERISTIC_LENGTH);
    error.fixed_rows_mut::<3>(0).unscale_mut(CHARACTERISTIC_LENGTH);
    let damping = 0.5 * error.norm_squared() + LEAST_DAMPING;
    let normal: Matrix6<f64> = jacobian * jacobian.transpose() + Matrix6::from_diagonal_element(damping);
    Some(jacobian.tr_mul(&Cholesky::new(normal)?.solve(&error)))
}

//! Kinematics of an arm at one configuration. The crate `k` has these for an older nalgebra, with allocations and without
//! dynamics.

use nalgebra::{Isometry3, IsometryMatrix3, Vector3, Vector6};

use crate::arm::Arm;
use crate::joint::{Jacobian, JointKind, JointVector, MOST_JOINTS};
use crate::spatial::{Motion, SpatialInertia};

/// An arm at given joint positions: what depends on these is computed once, without allocations.
#[derive(Debug, Clone)]
pub struct ConfiguredArm<'arm> {
    pub(crate) arm: &'arm Arm,
    /// Velocity of each link per speed of its joint; zero beyond the last joint.
    pub(crate) axes: [Motion; MOST_JOINTS],
    /// Inertia of each link, the payload included.
    pub(crate) inertias: [SpatialInertia; MOST_JOINTS],
    /// Frame of the part in that of the base.
    part: IsometryMatrix3<f64>,
}

/// Length (m) by which translations are divided where they are compared with rotations.
pub const CHARACTERISTIC_LENGTH: f64 = 0.5;
/// Largest number of iterations for singular values, which take about ten.
const ITERATIONS: usize = 1000;

impl Arm {
    /// The arm at joint positions (rad or m), which may be beyond limits.
    pub fn at(&self, configuration: &JointVector) -> ConfiguredArm<'_> {
        ConfiguredArm::new(self, configuration)
    }

    /// Pose of the part in the world frame.
    pub fn pose(&self, configuration: &JointVector) -> Isometry3<f64> {
        self.at(configuration).pose()
    }
}

impl<'arm> ConfiguredArm<'arm> {
    fn new(arm: &'arm Arm, configuration: &JointVector) -> Self {
        let mut axes = [Motion::zero(); MOST_JOINTS];
        let mut inertias = [SpatialInertia::zero(); MOST_JOINTS];
        let mut frame = IsometryMatrix3::identity();
        for (index, joint) in arm.joints().iter().enumerate() {
            frame *= joint.link_frame(configuration[index]);
            let axis = frame.rotation * joint.axis.into_inner();
            axes[index] = match joint.kind {
                JointKind::Revolute => Motion { angular: axis, linear: frame.translation.vector.cross(&axis) },
                JointKind::Prismatic => Motion { angular: Vector3::zeros(), linear: axis },
            };
            inertias[index] = SpatialInertia::placed(&joint.link_inertia, &frame);
        }
        let part = frame * arm.part_frame();
        let last = arm.joints().len() - 1;
        inertias[last] = inertias[last].plus(&SpatialInertia::placed(arm.payload(), &part));
        Self { arm, axes, inertias, part }
    }

    /// Pose of the part in the world frame.
    pub fn pose(&self) -> Isometry3<f64> {
        nalgebra::convert(self.arm.base() * self.part)
    }

    /// Velocity of the part's origin in the world frame (m/s) and its angular velocity in the body frame (rad/s) per speed
    /// of each joint.
    pub fn jacobian(&self) -> Jacobian {
        let mut jacobian = Jacobian::zeros();
        for index in 0..self.arm.joints().len() {
            jacobian
                .set_column(index, &self.in_scene(&self.axes[index].at(self.position()), &self.axes[index].angular));
        }
        jacobian
    }

    /// Rate of the Jacobian times the joint speeds `velocity` (rad/s or m/s): the acceleration of the part (m/s^2 in
    /// the world frame, rad/s^2 in the body frame) while no joint speed changes.
    ///
    /// With the link's velocity `v` and acceleration `a` (spatial vectors), the part's origin `p` has the acceleration
    /// `a_linear + a_angular x p + v_angular x p_dot`. In the body frame, the rate of the angular velocity is the
    /// rotated angular acceleration, since `R' w` has the rate `R' (w_dot - w x w)`.
    pub fn velocity_product(&self, velocity: &JointVector) -> Vector6<f64> {
        let (mut motion, mut rate) = (Motion::zero(), Motion::zero());
        for index in 0..self.arm.joints().len() {
            let step = self.axes[index].scaled(velocity[index]);
            rate = rate.plus(&motion.carry(&step));
            motion = motion.plus(&step);
        }
        let centripetal = motion.angular.cross(&motion.at(self.position()));
        self.in_scene(&(rate.at(self.position()) + centripetal), &rate.angular)
    }

    /// Smallest singular value of the Jacobian, with velocities divided by [`CHARACTERISTIC_LENGTH`]; unitless for revolute
    /// joints. Zero where the part cannot move in every direction, so always with fewer than six joints,
    /// and at positions that are no numbers.
    pub fn smallest_singular_value(&self) -> f64 {
        let mut jacobian = self.jacobian();
        jacobian.fixed_rows_mut::<3>(0).unscale_mut(CHARACTERISTIC_LENGTH);
        // Without a bound, iterations with NaN would never end.
        let decomposition = jacobian.try_svd(false, false, f64::EPSILON, ITERATIONS);
        decomposition.map_or(0.0, |decomposition| decomposition.singular_values.min())
    }

    /// Position of the part in the frame of the base (m).
    fn position(&self) -> &Vector3<f64> {
        &self.part.translation.vector
    }

    /// A linear and an angular vector of the base's frame, in the world frame and in the part's.
    fn in_scene(&self, linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
        let world = self.arm.base().rotation * linear;
        let body = self.part.rotation.inverse_transform_vector(angular);
        Vector6::new(world.x, world.y, world.z, body.x, body.y, body.z)
    }
}

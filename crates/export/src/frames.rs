//! From the part in the world to the tool in the frame of the robot's base.

use nalgebra::{Isometry3, Matrix3, Matrix6, Vector3, Vector6};
use scene::Scene;
use simulation::Knot;
use task::{Impedance, Pose, Wrench};

/// The robot's base and the grasp of its tool. Without an arm in the scene both are the identity: the tool is the part,
/// and the base is the world.
///
/// ```text
/// world --base--> robot's base --tool--> tool point (the scene's `tip`) --grasp--> part, as the robot believes it
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frames {
    /// The robot's base in the world.
    pub base: Isometry3<f64>,
    /// The part in the tool.
    pub grasp: Isometry3<f64>,
}

/// Motion of the tool at one time. All vectors are along the axes of the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolState {
    /// Pose of the tool in the base.
    pub pose: Isometry3<f64>,
    /// Velocity of the tool point (m/s).
    pub velocity: Vector3<f64>,
    /// Angular velocity (rad/s).
    pub angular_velocity: Vector3<f64>,
}

/// Gains of a controller at the tool point, along and about the axes of the base: first translation, then rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolGains {
    /// Stiffness (N/m, Nm/rad).
    pub stiffness: Matrix6<f64>,
    /// Damping (Ns/m, Nms/rad).
    pub damping: Matrix6<f64>,
}

impl Frames {
    /// The frames of a scene.
    pub fn of(scene: &Scene) -> Self {
        let pose = |pose: Option<&Pose>| pose.map_or_else(Isometry3::identity, Pose::isometry);
        let robot = scene.robot.as_ref();
        Self { base: pose(robot.map(|robot| &robot.base)), grasp: pose(robot.map(|robot| &robot.grasp)) }
    }

    /// The tool in the base while the part is at a pose of the world.
    pub fn tool(&self, part: &Isometry3<f64>) -> Isometry3<f64> {
        self.base.inverse() * part * self.grasp.inverse()
    }

    /// Motion of the tool while the part follows a reference.
    pub fn tool_state(&self, part: &Knot) -> ToolState {
        let to_base = self.base.rotation.inverse();
        let pose = self.tool(&part.pose);
        let angular_velocity = to_base * part.pose.rotation * part.angular_velocity;
        let velocity = to_base * part.velocity - angular_velocity.cross(&self.lever(&pose));
        ToolState { pose, velocity, angular_velocity }
    }

    /// A wrench on the part (N in the world, Nm in the part's frame, about its origin) as one at the tool point, along the axes
    /// of the base: the force acts at the part, so it has the moment `r x F` about the tool point.
    pub fn tool_wrench(&self, part: &Isometry3<f64>, wrench: &Wrench) -> Vector6<f64> {
        let to_base = self.base.rotation.inverse();
        let force = to_base * wrench.force();
        let torque = to_base * part.rotation * wrench.torque();
        stacked(&force, &(torque + self.lever(&self.tool(part)).cross(&force)))
    }

    /// The controller of a plan at the tool point, with the part at a pose of the world. Exact for small deviations
    /// from there: the lever of a controller that acts at the part rotates with it.
    pub fn tool_gains(&self, part: &Isometry3<f64>, impedance: &Impedance) -> ToolGains {
        let to_base = self.base.rotation.inverse().to_rotation_matrix();
        let from_part = to_base * part.rotation.to_rotation_matrix();
        let carried = self.carried(&self.tool(part));
        let stiffness = blocks(
            &(Matrix3::identity() * impedance.translational_stiffness),
            &(Matrix3::identity() * impedance.rotational_stiffness),
        );
        let damping = blocks(
            &(to_base * impedance.translational_damping * to_base.inverse()),
            &(from_part * impedance.rotational_damping * from_part.inverse()),
        );
        let at_tool = |gains: Matrix6<f64>| carried.transpose() * gains * carried;
        ToolGains { stiffness: at_tool(stiffness), damping: at_tool(damping) }
    }

    /// From the tool point to the part's origin, along the axes of the base (m).
    fn lever(&self, tool: &Isometry3<f64>) -> Vector3<f64> {
        tool.rotation * self.grasp.translation.vector
    }

    /// The twist of the part for a twist of the tool, both along the axes of the base.
    fn carried(&self, tool: &Isometry3<f64>) -> Matrix6<f64> {
        let mut carried = Matrix6::identity();
        carried.fixed_view_mut::<3, 3>(0, 3).copy_from(&-self.lever(tool).cross_matrix());
        carried
    }
}

fn stacked(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
}

fn blocks(translational: &Matrix3<f64>, rotational: &Matrix3<f64>) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(translational);
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(rotational);
    matrix
}

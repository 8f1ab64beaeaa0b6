//! The robot that moves the body: its arm, and what it is commanded.

mod interface;
mod stiffness;
mod warnings;

use std::ops::Range;
use std::path::PathBuf;

use ::robot::gains::FrictionWrench;
use ::robot::{Arm, JointPath, JointVector, RigidInertia};
use nalgebra::{Isometry3, Matrix3, Matrix6};
use task::Pose;
use task::pose::interpolate;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::material::Material;
use crate::pose::{Endpoints, StartPose, orientation};
use crate::table::Table;

pub use interface::{Interface, Surroundings, position_robot};
pub use stiffness::{LARGEST_FORCE, Stiffness, stiffness};
pub use warnings::warnings;

/// Keys that only an arm of a URDF file has.
const ARM_KEYS: [&str; 6] = ["tip", "grasp", "base", "configuration", "rotor_inertia", "joint_friction"];
/// Fewer joints cannot hold a part's position and orientation.
const LEAST_JOINTS: usize = 6;
/// Poses on the straight path from the goal to a start at which the arm is checked.
const POSES: usize = 20;

/// An arm of a URDF file, with the body in its gripper.
#[derive(Debug, Clone)]
pub struct Robot {
    /// Its file.
    pub urdf: PathBuf,
    /// Link that holds the body.
    pub tip: String,
    /// Pose of the body's frame in that of the tip (position m, unit quaternion w x y z).
    pub grasp: Pose,
    /// Pose of the arm's base in the world frame, in the same way.
    pub base: Pose,
    /// The arm, with base, grasp, rotors and payload.
    pub arm: Arm,
    /// Joint positions (rad or m) near the goal, as the scene gives them.
    pub given: JointVector,
    /// Joint positions (rad or m) with the body at its goal.
    pub configuration: JointVector,
    /// Wrench that joint friction can hold at the goal; `None` where the arm is singular there.
    pub friction_wrench: Option<FrictionWrench>,
    /// Friction of each joint (Nm or N) that the controller leaves.
    pub joint_friction: Vec<f64>,
    /// Time between two commands of the controller (s).
    pub control_period: f64,
    /// Distances of the arm from its limits and from singular configurations on the straight paths between goal and
    /// starts.
    pub ways: Vec<JointPath>,
}

impl Robot {
    /// The arm of a scene, if its robot has a URDF file. Its payload is the body's material.
    pub fn read(table: &Table, material: Option<&Material>, ends: Endpoints) -> Result<Option<Self>, SceneError> {
        let Some(urdf) = table.find("urdf") else {
            return match ARM_KEYS.iter().find_map(|key| table.find(key)) {
                Some(entry) => Err(entry.refuse_name(format!("{} needs `urdf`", entry.path()))),
                None => Ok(None),
            };
        };
        let tip = table.require("tip")?;
        let (grasp, base) = (placement(&table.table("grasp")?)?, placement(&table.table("base")?)?);
        let file = urdf.source().file;
        let path = file.parent().unwrap_or(file).join(urdf.text()?);
        let arm = Arm::read(&path, tip.text()?).map_err(|error| urdf.refuse(error.to_string()))?;
        let count = arm.joints().len();
        if count < LEAST_JOINTS {
            let joints: Vec<&str> = arm.joints().iter().map(|joint| joint.name.as_str()).collect();
            return Err(tip.refuse(format!(
                "an arm needs at least {LEAST_JOINTS} joints to move a part in all directions, and {count} move in front of \
                 this link: {}; name a link behind the last joint, or give robot.apparent_inertia instead of robot.urdf",
                joints.join(", ")
            )));
        }
        let rotor_inertia = per_joint(table, "rotor_inertia", count)?;
        let payload = material.map_or(Ok(RigidInertia::zero()), payload).map_err(|error| urdf.refuse(error))?;
        let arm = arm.with_base(&base.isometry()).with_grasp(&grasp.isometry()).with_payload(payload);
        let arm = arm.with_rotor_inertia(&rotor_inertia).map_err(|error| urdf.refuse(error.to_string()))?;
        let given = table.require("configuration")?;
        let near = arm.configuration(&given.numbers()?).map_err(|error| given.refuse(error.to_string()))?;
        let unreachable = |what: String, reason: String| {
            given.refuse(format!(
                "the arm does not reach {what} from these joint positions: {reason}; check base, grasp and configuration"
            ))
        };
        let configuration = arm
            .inverse_kinematics(&ends.goal.isometry(), &near)
            .map_err(|error| unreachable("the goal".into(), error.to_string()))?;
        let way = |start: &StartPose| {
            let what = format!("start `{}` on the straight path from the goal", start.name);
            arm.follow(&straight(ends.goal, &start.pose), &configuration)
                .map_err(|error| unreachable(what, error.reason.to_string()))
        };
        let ways = ends.starts.iter().map(way).collect::<Result<_, _>>()?;
        let joint_friction = per_joint(table, "joint_friction", count)?;
        let friction_wrench = FrictionWrench::new(&arm.at(&configuration).jacobian(), &joint_friction);
        let (tip, control_period) = (tip.text()?.to_owned(), table.number("control_period")?);
        let urdf = path.canonicalize().unwrap_or(path);
        Ok(Some(Self {
            urdf,
            tip,
            grasp,
            base,
            arm,
            given: near,
            configuration,
            friction_wrench,
            joint_friction,
            control_period,
            ways,
        }))
    }

    /// Velocity (m/s) and angular velocity (rad/s) along every axis at once that no joint is too slow for, at the goal and
    /// with the redundant joints at rest that a pseudoinverse leaves; both need the joints equally. `None` where no joint
    /// has a limit, or the arm is singular.
    pub fn velocities(&self) -> Option<[f64; 2]> {
        let jacobian = self.arm.at(&self.configuration).jacobian();
        let normal: Matrix6<f64> = jacobian * jacobian.transpose();
        let joint_speeds = jacobian.transpose() * normal.try_inverse()?;
        let needed = |joint: usize, axes: Range<usize>| axes.map(|axis| joint_speeds[(joint, axis)].abs()).sum::<f64>();
        let slowest = |axes: Range<usize>| {
            let joints = self.arm.joints().iter().enumerate();
            let fastest = joints.map(|(index, joint)| 0.5 * joint.velocity / needed(index, axes.clone()));
            fastest.fold(f64::INFINITY, f64::min)
        };
        let velocities = [slowest(0..3), slowest(3..6)];
        velocities.iter().all(|velocity| velocity.is_finite()).then_some(velocities)
    }

    /// Reflected inertia of each joint's rotor (kg m^2 or kg).
    pub fn rotor_inertia(&self) -> Vec<f64> {
        self.arm.joints().iter().map(|joint| joint.rotor_inertia).collect()
    }
}

/// A pose that a table gives in part: the identity where it does not.
fn placement(table: &Table) -> Result<Pose, SceneError> {
    let position = table.find("position").map_or(Ok([0.0; 3]), |entry| entry.vector())?;
    let orientation = table.find("orientation").map_or(Ok([1.0, 0.0, 0.0, 0.0]), |entry| orientation(&entry))?;
    Ok(Pose::new(position, orientation))
}

/// One number for each joint: the same where the scene gives one only.
fn per_joint(table: &Table, name: &str, joints: usize) -> Result<Vec<f64>, SceneError> {
    let Some(entry) = table.find(name) else { return Ok(vec![table.number(name)?; joints]) };
    let numbers = entry.number_or_numbers()?;
    match numbers[..] {
        [number] => Ok(vec![number; joints]),
        _ if numbers.len() == joints => Ok(numbers),
        _ => Err(wrong_count(&entry, numbers.len(), joints)),
    }
}

fn wrong_count(entry: &Entry, given: usize, joints: usize) -> SceneError {
    entry.refuse(format!("{} has {given} numbers: one for all joints, or one for each of {joints}", entry.path()))
}

/// The body itself, about its centre of mass.
fn payload(material: &Material) -> Result<RigidInertia, String> {
    let center = material.center;
    let shifted = Matrix3::identity() * center.norm_squared() - center * center.transpose();
    let rotational = material.rotational - shifted * material.mass;
    RigidInertia::new(material.mass, center, rotational).map_err(|error| error.to_string())
}

/// Poses on the straight path between two, a second apart.
fn straight(from: &Pose, to: &Pose) -> Vec<(f64, Isometry3<f64>)> {
    let (from, to) = (from.isometry(), to.isometry());
    let pose = |index: usize| (index as f64, interpolate(&from, &to, index as f64 / (POSES - 1) as f64));
    (0..POSES).map(pose).collect()
}

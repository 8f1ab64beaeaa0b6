//! The arm that holds the part, and its controller.

use std::ops::RangeInclusive;

use robot::{Arm, ArmError, InverseError, JointVector};
use task::AssemblyTask;
use task::pose::interpolate;

use crate::reference::Reference;
use crate::settings_error::{SettingsError, check};

/// An arm under an impedance controller that knows its kinematics and dynamics. The controller reads positions and
/// speeds of the joints every period and, after the delay, commands the torques `J' w + bias`, which hold until the
/// next ones arrive: `w` is the wrench of the impedance law at the believed pose of the part, `bias` are Coriolis and
/// centrifugal torques. It compensates gravity, so the model has gravity only in the largest torques. Limits of
/// positions and speeds are not enforced.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmModel {
    /// With base, grasp, payload and rotor inertia; the grasp is the one that the robot believes.
    pub arm: Arm,
    /// Joint positions near the goal (rad or m), one per joint: they name the IK branch.
    pub configuration: Vec<f64>,
    /// Dry friction of each joint that the controller leaves (Nm, N for a prismatic joint), 0 to 1e4.
    pub joint_friction: Vec<f64>,
    /// Time between two samples of the controller (s), 1e-4 to 0.1.
    pub control_period: f64,
    /// Time from a sample to its torques (s), 0 to 0.1.
    pub delay: f64,
}

/// Why rollouts of an arm are not possible.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ArmModelError {
    /// A configuration that is not one of the arm.
    #[error("configuration: {0}")]
    Configuration(ArmError),
    /// The number of friction torques is not the number of joints.
    #[error("joint_friction has {given} numbers, and the arm {joints} joints: give one per joint")]
    FrictionCount {
        /// How many were given.
        given: usize,
        /// Number of joints.
        joints: usize,
    },
    /// A number out of its range.
    #[error(transparent)]
    Range(#[from] SettingsError),
    /// A pose on the path from the goal to the start that the arm does not reach.
    #[error("{percent} % of the straight path from the goal to the start: {error}")]
    Pose {
        /// Place on the path; 0 is the goal.
        percent: usize,
        /// What fails.
        error: InverseError,
    },
    /// At the start the part cannot move in every direction.
    #[error(
        "the arm is singular at the start: it cannot move the part in every direction; choose another configuration"
    )]
    Singular,
}

/// Parts of the path from goal to start, each short enough to stay on one IK branch.
const PARTS: usize = 20;

impl ArmModel {
    /// Allowed friction of a joint (Nm, N for a prismatic joint).
    pub const JOINT_FRICTIONS: RangeInclusive<f64> = 0.0..=1e4;
    /// Allowed control periods (s).
    pub const CONTROL_PERIODS: RangeInclusive<f64> = 1e-4..=0.1;
    /// Allowed delays (s).
    pub const DELAYS: RangeInclusive<f64> = 0.0..=0.1;

    /// Joint positions (rad or m) at the start of a task, followed from those at the goal along the straight path.
    ///
    /// # Errors
    /// When a number is out of its range, or the arm does not reach a pose of that path or is singular at the
    /// start.
    pub fn start(&self, task: &AssemblyTask) -> Result<JointVector, ArmModelError> {
        let configuration = self.arm.configuration(&self.configuration).map_err(ArmModelError::Configuration)?;
        let (given, joints) = (self.joint_friction.len(), self.arm.joints().len());
        if given != joints {
            return Err(ArmModelError::FrictionCount { given, joints });
        }
        for &friction in &self.joint_friction {
            check("joint_friction", friction, &Self::JOINT_FRICTIONS, "Nm")?;
        }
        check("control_period", self.control_period, &Self::CONTROL_PERIODS, "s")?;
        check("delay", self.delay, &Self::DELAYS, "s")?;
        let (goal, start) = (task.goal.isometry(), task.start.isometry());
        let start = (0..=PARTS).try_fold(configuration, |near, part| {
            let pose = interpolate(&goal, &start, part as f64 / PARTS as f64);
            let reached = self.arm.inverse_kinematics(&pose, &near);
            reached.map_err(|error| ArmModelError::Pose { percent: 100 * part / PARTS, error })
        })?;
        self.arm.at(&start).apparent_inertia().map(|_| start).ok_or(ArmModelError::Singular)
    }

    /// Smallest distance of the joints from the ends of their ranges (rad or m) along a reference, followed from its
    /// end, where the configuration names the IK branch. `None` if a pose is outside the ranges or out of reach, or a
    /// joint is too slow.
    pub(crate) fn room(&self, reference: &Reference) -> Option<f64> {
        let near = self.arm.configuration(&self.configuration).ok()?;
        let count = reference.intervals();
        let timed = |index: usize| (index as f64 * reference.time_step(), reference.at(index, 0.0).pose);
        let path = self.arm.follow_back(&(0..=count).map(timed).collect::<Vec<_>>(), &near).ok()?;
        Some(path.limit_distance.map_or(f64::INFINITY, |nearest| nearest.value))
    }
}

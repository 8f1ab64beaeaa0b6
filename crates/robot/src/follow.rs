//! Joint positions along a motion of the part.

use nalgebra::Isometry3;

use crate::arm::Arm;
use crate::inverse::InverseError;
use crate::joint::JointVector;

/// Joint positions along a motion, and where they come close to what the arm can do.
#[derive(Debug, Clone, PartialEq)]
pub struct JointPath {
    /// One per pose (rad or m).
    pub configurations: Vec<JointVector>,
    /// Smallest distance of a joint to its limits (rad or m). `None` if no joint has limits.
    pub limit_distance: Option<JointExtreme>,
    /// Smallest singular value of the Jacobian ([`crate::ConfiguredArm::smallest_singular_value`]) and its time (s). `None`
    /// without poses.
    pub singular_value: Option<(f64, f64)>,
    /// Largest joint speed (rad/s or m/s) between two poses, with the time of the second one. `None` with less than two.
    pub speed: Option<JointExtreme>,
}

/// An extreme value of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointExtreme {
    /// The value.
    pub value: f64,
    /// Index of the joint.
    pub joint: usize,
    /// When it is reached (s).
    pub time: f64,
}

/// Why an arm cannot follow a motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("at {time} s: {reason}")]
pub struct FollowError {
    /// Time of the pose at which the motion fails (s).
    pub time: f64,
    /// Cause of the failure.
    pub reason: FollowReason,
}

/// Causes of the failure of a motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FollowReason {
    /// The arm does not reach a pose within its limits.
    #[error(transparent)]
    Pose(#[from] InverseError),
    /// A joint would have to move faster than it can.
    #[error(
        "joint `{joint}` would need {speed:.3} {unit}/s, and its limit is {limit:.3} {unit}/s; give the motion more time"
    )]
    Speed {
        /// Name of the joint.
        joint: String,
        /// Its speed (rad/s or m/s).
        speed: f64,
        /// Its limit (rad/s or m/s).
        limit: f64,
        /// Unit of its positions.
        unit: &'static str,
    },
    /// Times do not increase.
    #[error("the time of a pose must be after that of the pose before")]
    Time,
}

impl Arm {
    /// Joint positions (rad or m) for the times (s) and poses (world frame) of a motion: those of each pose are found
    /// from those of the pose before, those of the first one from `from`. The arm therefore stays on one IK branch as
    /// long as poses are close to each other; a jump to another branch shows as a speed that no joint has.
    ///
    /// # Errors
    /// When a pose is not reached within the limits of the joints, a joint is too slow, or times do not
    /// increase.
    pub fn follow(&self, motion: &[(f64, Isometry3<f64>)], from: &JointVector) -> Result<JointPath, FollowError> {
        let mut path = JointPath {
            configurations: Vec::with_capacity(motion.len()),
            limit_distance: None,
            singular_value: None,
            speed: None,
        };
        let mut before: Option<(f64, JointVector)> = None;
        for &(time, ref pose) in motion {
            let failed = |reason| FollowError { time, reason };
            let near = before.as_ref().map_or(from, |(_, configuration)| configuration);
            let configuration = self.inverse_kinematics(pose, near).map_err(|error| failed(error.into()))?;
            if let Some(before) = &before {
                let fastest = self.fastest(before, &(time, configuration)).map_err(failed)?;
                path.speed =
                    Some(path.speed.map_or(fastest, |known| if fastest.value > known.value { fastest } else { known }));
            }
            path.note_posture(self, time, &configuration);
            path.configurations.push(configuration);
            before = Some((time, configuration));
        }
        Ok(path)
    }

    /// As [`follow`](Self::follow), but from the end of a motion: the joint positions of the last pose are found from `from`,
    /// those of every other one from those of the pose after it. The path is in the order of the motion; the time of the
    /// fastest joint is that of the earlier of the two poses.
    ///
    /// # Errors
    /// As [`follow`](Self::follow).
    pub fn follow_back(&self, motion: &[(f64, Isometry3<f64>)], from: &JointVector) -> Result<JointPath, FollowError> {
        let end = motion.last().map_or(0.0, |(time, _)| *time);
        let backwards: Vec<(f64, Isometry3<f64>)> =
            motion.iter().rev().map(|(time, pose)| (end - time, *pose)).collect();
        let path = self.follow(&backwards, from);
        let mut path = path.map_err(|error| FollowError { time: end - error.time, ..error })?;
        path.configurations.reverse();
        for extreme in [&mut path.limit_distance, &mut path.speed].into_iter().flatten() {
            extreme.time = end - extreme.time;
        }
        path.singular_value = path.singular_value.map(|(value, time)| (value, end - time));
        Ok(path)
    }

    /// The fastest joint between two configurations with their times.
    fn fastest(
        &self,
        (start, from): &(f64, JointVector),
        (end, to): &(f64, JointVector),
    ) -> Result<JointExtreme, FollowReason> {
        let duration = end - start;
        if duration.is_nan() || duration <= 0.0 {
            return Err(FollowReason::Time);
        }
        let mut fastest = JointExtreme { value: 0.0, joint: 0, time: *end };
        for (index, joint) in self.joints().iter().enumerate() {
            let speed = (to[index] - from[index]).abs() / duration;
            if speed > joint.velocity {
                let (name, limit, unit) = (joint.name.clone(), joint.velocity, joint.kind.unit());
                return Err(FollowReason::Speed { joint: name, speed, limit, unit });
            }
            if speed > fastest.value {
                fastest = JointExtreme { value: speed, joint: index, ..fastest };
            }
        }
        Ok(fastest)
    }
}

impl JointPath {
    /// Keeps what is smaller at a configuration than at those before.
    fn note_posture(&mut self, arm: &Arm, time: f64, configuration: &JointVector) {
        for (joint, limits) in arm.joints().iter().enumerate() {
            let value = limits.limit_distance(configuration[joint]);
            if value.is_finite() && self.limit_distance.is_none_or(|known| value < known.value) {
                self.limit_distance = Some(JointExtreme { value, joint, time });
            }
        }
        let value = arm.at(configuration).smallest_singular_value();
        if self.singular_value.is_none_or(|(known, _)| value < known) {
            self.singular_value = Some((value, time));
        }
    }
}

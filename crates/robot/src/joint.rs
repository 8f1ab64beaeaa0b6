//! Joints of an arm.

use nalgebra::{Isometry3, IsometryMatrix3, Rotation3, SMatrix, SVector, Unit, Vector3};

use crate::inertia::RigidInertia;

/// Largest number of moving joints.
pub const MOST_JOINTS: usize = 8;

/// One number per joint, from the base to the tip. Rows beyond the last joint are ignored as input and zero as output.
pub type JointVector = SVector<f64, MOST_JOINTS>;
/// Rows and columns as in [`JointVector`].
pub type JointMatrix = SMatrix<f64, MOST_JOINTS, MOST_JOINTS>;
/// Velocity of the part's origin in the world frame (m/s), then its angular velocity in the body frame (rad/s), per speed
/// of each joint. Columns as in [`JointVector`].
pub type Jacobian = SMatrix<f64, 6, MOST_JOINTS>;

/// A joint that moves, with the link behind it.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its name in the file.
    pub name: String,
    /// How it moves.
    pub kind: JointKind,
    /// Lowest position (rad, m for a prismatic joint); minus infinity without one.
    pub lower: f64,
    /// Highest position (rad or m); infinity without one.
    pub upper: f64,
    /// Largest speed (rad/s or m/s); infinity without a limit.
    pub velocity: f64,
    /// Largest torque (Nm, N for a prismatic joint); infinity without a limit.
    pub effort: f64,
    /// The joint in the frame of the link before.
    pub(crate) before: IsometryMatrix3<f64>,
    /// In the frame of the joint, and in that of its link.
    pub(crate) axis: Unit<Vector3<f64>>,
    /// Inertia of the link and everything fixed to it, in the frame of the link.
    pub(crate) link_inertia: RigidInertia,
    /// Reflected to the joint (kg m^2, kg for a prismatic joint).
    pub rotor_inertia: f64,
}

/// How a joint moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// Turns about its axis; joints without limits are of this kind too.
    Revolute,
    /// Slides along its axis.
    Prismatic,
}

impl Joint {
    /// Frame of the joint's link at a position (rad or m), in the frame of the link before.
    pub fn link_frame(&self, position: f64) -> IsometryMatrix3<f64> {
        self.before * self.kind.motion(&self.axis, position)
    }

    /// The joint's frame at position zero in the frame of the link before.
    pub fn frame(&self) -> Isometry3<f64> {
        nalgebra::convert(self.before)
    }

    /// Its axis in its own frame, and in that of its link.
    pub fn axis(&self) -> Vector3<f64> {
        self.axis.into_inner()
    }

    /// Whether a position (rad or m) is within the limits.
    pub fn allows(&self, position: f64) -> bool {
        (self.lower..=self.upper).contains(&position)
    }

    /// Distance of a position to the nearest limit (rad or m), negative beyond; infinity without limits.
    pub fn limit_distance(&self, position: f64) -> f64 {
        (position - self.lower).min(self.upper - position)
    }
}

impl JointKind {
    /// Unit of positions.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Revolute => "rad",
            Self::Prismatic => "m",
        }
    }

    /// Unit of rotor inertias.
    pub fn inertia_unit(self) -> &'static str {
        match self {
            Self::Revolute => "kg m^2",
            Self::Prismatic => "kg",
        }
    }

    /// Displacement along or about an axis by a position (m or rad).
    pub(crate) fn motion(self, axis: &Unit<Vector3<f64>>, position: f64) -> IsometryMatrix3<f64> {
        match self {
            Self::Revolute => {
                let rotation = Rotation3::from_axis_angle(axis, position);
                IsometryMatrix3::from_parts(Vector3::zeros().into(), rotation)
            }
            Self::Prismatic => IsometryMatrix3::from_parts(axis.scale(position).into(), Rotation3::identity()),
        }
    }
}

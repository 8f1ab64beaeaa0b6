//! Which offsets a plan covers.

use nalgebra::{Unit, Vector3};

/// The offsets of the part in the gripper that a plan covers; those of a disc and a ball are at most as long as the
/// offset magnitude `delta-hat`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Coverage {
    /// The convex hull of the planned offsets.
    Hull,
    /// Every offset across an axis.
    Disc {
        /// The axis (body frame), of unit length.
        axis: [f64; 3],
    },
    /// Every offset in any direction.
    Ball,
}

impl Coverage {
    /// Orthonormal vectors (body frame) that span the disc or the ball; none for a hull.
    pub fn span(&self) -> Vec<Vector3<f64>> {
        match self {
            Self::Hull => Vec::new(),
            Self::Disc { axis } => {
                let axis = Unit::new_normalize(Vector3::from(*axis));
                let first = Unit::new_normalize(axis.cross(&Vector3::ith(axis.iamin(), 1.0)));
                vec![first.into_inner(), axis.cross(&first)]
            }
            Self::Ball => (0..3).map(|axis| Vector3::ith(axis, 1.0)).collect(),
        }
    }
}

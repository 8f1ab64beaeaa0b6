//! How a part sits in the gripper, compared with what the robot believes.

use nalgebra::{UnitQuaternion, Vector3};
use task::Impedance;

use crate::reference::Reference;

/// The robot, which believes to hold the part at a pose, really holds it shifted and turned.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Grasp {
    /// Offset `q` of `P_q` (m, body frame).
    pub offset: [f64; 3],
    /// Rotation vector (rad, body frame) from the part's orientation to the believed one. Plans do not model it.
    pub turn: [f64; 3],
}

impl From<[f64; 3]> for Grasp {
    fn from(offset: [f64; 3]) -> Self {
        Self { offset, turn: [0.0; 3] }
    }
}

impl Grasp {
    fn rotation(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(Vector3::from(self.turn))
    }

    /// Pose of the part (position m, unit quaternion w x y z) where the robot believes it at the reference's start: with
    /// an offset alone `P_q^-1` of it (Sec. ocp:ocp).
    pub fn start(&self, reference: &Reference) -> [f64; 7] {
        task::pose::without_offset(&self.reference(reference).start(), &self.offset)
    }

    /// The grasps without repetitions, in their order: a rollout is deterministic, and playing it twice says nothing.
    pub fn distinct(grasps: impl IntoIterator<Item = Self>) -> Vec<Self> {
        /// Grasps closer than this (m, rad) are the same.
        const SAME: f64 = 1e-9;
        let distance = |one: [f64; 3], other: [f64; 3]| (Vector3::from(one) - Vector3::from(other)).norm();
        let mut found: Vec<Self> = Vec::new();
        for grasp in grasps {
            let is_same =
                |other: &Self| distance(grasp.offset, other.offset) < SAME && distance(grasp.turn, other.turn) < SAME;
            if !found.iter().any(is_same) {
                found.push(grasp);
            }
        }
        found
    }

    /// What the part is to do where the robot follows a reference.
    pub(crate) fn reference(&self, reference: &Reference) -> Reference {
        reference.turned(&self.rotation().inverse())
    }

    /// The impedance law in the part's body frame.
    pub(crate) fn impedance(&self, impedance: &Impedance) -> Impedance {
        let rotation = self.rotation().to_rotation_matrix();
        let rotational_damping = rotation * impedance.rotational_damping * rotation.inverse();
        Impedance { rotational_damping, ..impedance.clone() }
    }
}

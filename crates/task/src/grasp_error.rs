//! How the part in the gripper differs from what the robot believes.

use std::collections::HashMap;

use nalgebra::{Isometry3, UnitQuaternion, Vector3};

use crate::algebra::{conjugate, product};
use crate::impedance::Impedance;
use crate::pose::Pose;

/// Where the part really sits in the gripper, relative to where the robot believes it to be: the perturbation `q^` of
/// `P_q(q, q^)` (Sec. ocp:ocp). The robot believes a part at the pose `(rho, xi)` to be at
/// `(rho + R(xi) offset, xi (x) rotation)`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GraspError {
    /// Position of the believed part (m, body frame).
    pub offset: [f64; 3],
    /// Rotation vector (rad, body frame) from the part's orientation to the believed one.
    pub rotation: [f64; 3],
}

impl From<[f64; 3]> for GraspError {
    fn from(offset: [f64; 3]) -> Self {
        Self { offset, rotation: [0.0; 3] }
    }
}

/// Grasp errors closer than this (m, rad) are the same.
const SAME: f64 = 1e-9;

impl GraspError {
    /// The believed part in the frame of the part.
    pub fn believed(&self) -> Isometry3<f64> {
        Isometry3::from_parts(Vector3::from(self.offset).into(), self.quaternion())
    }

    /// From the believed part in the frame of the part.
    pub fn of_believed(believed: &Isometry3<f64>) -> Self {
        Self { offset: believed.translation.vector.into(), rotation: believed.rotation.scaled_axis().into() }
    }

    /// The pose of the believed part in the frame of the part, with a unit quaternion.
    pub fn pose(&self) -> Pose {
        Pose::from(&self.believed())
    }

    /// The inverse perturbation `P_q^-1(q, q^)` (Sec. ocp:ocp): the pose of the part when the robot believes it to be at
    /// `believed`.
    pub fn actual(&self, believed: &Pose) -> Pose {
        let quaternion = product(&believed.quaternion(), &conjugate(&self.pose()[3..]));
        let position = believed.position();
        let shift = Pose::new(position.into(), quaternion).rotation_matrix() * Vector3::from(self.offset);
        Pose::new((position - shift).into(), quaternion)
    }

    /// The offset and the rotation times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let scaled = |vector: [f64; 3]| vector.map(|component| factor * component);
        Self { offset: scaled(self.offset), rotation: scaled(self.rotation) }
    }

    /// The grasp errors without repetitions, in their order: rollouts are deterministic, so one of each is enough. The
    /// effort grows linearly with their number.
    pub fn distinct(grasps: impl IntoIterator<Item = Self>) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        // Grasp errors that are the same lie in the same cell along a direction, or in neighbouring ones.
        let mut cells: HashMap<u64, Vec<usize>> = HashMap::new();
        for grasp in grasps {
            let cell = grasp.cell();
            if !cell.is_finite() {
                // Nothing is close to a value that is not finite.
                found.push(grasp);
                continue;
            }
            let mut near = [cell - 1.0, cell, cell + 1.0].into_iter().filter_map(|cell| cells.get(&cell.to_bits()));
            if !near.any(|indices| indices.iter().any(|&index| grasp.is_same(&found[index]))) {
                cells.entry(cell.to_bits()).or_default().push(found.len());
                found.push(grasp);
            }
        }
        found
    }

    fn is_same(&self, other: &Self) -> bool {
        let distance = |one: [f64; 3], other: [f64; 3]| (Vector3::from(one) - Vector3::from(other)).norm();
        distance(self.offset, other.offset) < SAME && distance(self.rotation, other.rotation) < SAME
    }

    /// Place along a direction in which regular patterns do not coincide, in cells so wide that the places of grasp
    /// errors that are the same differ by less than one.
    fn cell(&self) -> f64 {
        /// Square roots of the first primes, scaled to unit length.
        const DIRECTION: [f64; 6] = [0.22086305, 0.27050089, 0.34921515, 0.41319690, 0.51797040, 0.56309254];
        const WIDTH: f64 = 2.0 * SAME;
        let terms = self.offset.iter().chain(&self.rotation).zip(DIRECTION);
        let place: f64 = terms.map(|(component, weight)| component * weight).sum();
        // Without negative zeros, whose bits differ.
        (place / WIDTH).floor() + 0.0
    }

    /// From the orientation of the part to the believed one.
    pub fn quaternion(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(Vector3::from(self.rotation))
    }

    /// The impedance law in the part's body frame.
    pub fn impedance(&self, impedance: &Impedance) -> Impedance {
        let rotation = self.quaternion().to_rotation_matrix();
        let rotational_damping = rotation * impedance.rotational_damping * rotation.inverse();
        Impedance { rotational_damping, ..impedance.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The believed pose of the actual pose is the pose that was believed.
    #[test]
    fn the_robot_believes_a_displaced_and_turned_part_to_be_at_the_start() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..100 {
            let mut vector = |size: f64| std::array::from_fn(|_| size * (2.0 * random.f64() - 1.0));
            let grasp = GraspError { offset: vector(0.02), rotation: vector(1.0) };
            let start = Isometry3::new(Vector3::from(vector(0.1)), Vector3::from(vector(2.0)));
            let believed = grasp.actual(&Pose::from(&start)).isometry() * grasp.believed();
            assert!((believed.translation.vector - start.translation.vector).norm() < 1e-15);
            assert!(believed.rotation.angle_to(&start.rotation) < 1e-7);
        }
    }

    #[test]
    fn without_an_error_the_part_is_where_it_is_believed() {
        let start = Pose([0.1, -0.2, 0.3, 0.6, 0.0, 0.8, 0.0]);
        assert_eq!(GraspError::default().actual(&start), start);
    }

    /// Comparing each with all others is the definition.
    #[test]
    fn repetitions_are_found_wherever_cells_end() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut step = |size: f64| std::array::from_fn(|_| size * (random.f64() - 0.5));
        let mut grasps = Vec::new();
        for _ in 0..300 {
            let (offset, rotation) = (step(0.02), step(0.1));
            for size in [0.0, 1e-10, 1e-9, 2e-9] {
                let moved = |from: [f64; 3], by: [f64; 3]| std::array::from_fn(|axis| from[axis] + by[axis]);
                grasps.push(GraspError { offset: moved(offset, step(size)), rotation: moved(rotation, step(size)) });
            }
        }
        let mut expected: Vec<GraspError> = Vec::new();
        for grasp in &grasps {
            if !expected.iter().any(|other| grasp.is_same(other)) {
                expected.push(*grasp);
            }
        }
        assert!((301..1200).contains(&expected.len()), "{}", expected.len());
        assert_eq!(GraspError::distinct(grasps), expected);
    }

    #[test]
    fn many_grasp_errors_in_a_plane_are_compared_in_no_time() {
        let grasps = (0..1_000_000).map(|index| [0.0, 1e-5 * (index % 1000) as f64, 1e-5 * (index / 1000) as f64]);
        assert_eq!(GraspError::distinct(grasps.map(GraspError::from)).len(), 1_000_000);
    }

    #[test]
    fn absurd_grasp_errors_are_compared_too() {
        let offsets = [[f64::NAN; 3], [f64::INFINITY; 3], [1e200; 3], [1e200; 3], [0.0; 3], [-0.0; 3]];
        assert_eq!(GraspError::distinct(offsets.map(GraspError::from)).len(), 4);
    }
}

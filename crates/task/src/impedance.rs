//! The Cartesian impedance controller that tracks the reference.

use nalgebra::Matrix3;

use crate::algebra::{Number, apply, conjugate, dot, product, rotation};
use crate::inertia::Inertia;
use crate::pose::{POSE, Pose};
use crate::state::{State, TWIST, Wrench};

/// Isotropic stiffness, and damping, of the Cartesian impedance controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Impedance {
    /// `k_t` (N/m).
    pub translational_stiffness: f64,
    /// `k_r` (Nm/rad).
    pub rotational_stiffness: f64,
    /// `D_t` (Ns/m), in the world frame; symmetric and positive semidefinite.
    pub translational_damping: Matrix3<f64>,
    /// `D_r` (Nms/rad), in the body frame; symmetric and positive semidefinite.
    pub rotational_damping: Matrix3<f64>,
}

/// The stiffness (N/m) that the usual settings of the homotopy are made for.
const USUAL_STIFFNESS: f64 = 50.0;

impl Impedance {
    /// Unit of contact forces in the optimal control problem (N), proportional to the stiffness. A stiffer controller
    /// pushes harder for the same error; in this unit its contact is relaxed and scaled like that of a soft one, and
    /// the same settings of the homotopy suit both.
    pub fn force_unit(&self) -> f64 {
        self.translational_stiffness / USUAL_STIFFNESS
    }

    /// Critical damping for the given inertia: `D_t = 2 sqrt(k_t m)`, or the matrix square root of a mass that differs
    /// from axis to axis, and `D_r = 2 sqrt(k_r I_jj)` per axis.
    pub fn critically_damped(translational_stiffness: f64, rotational_stiffness: f64, inertia: &Inertia) -> Self {
        let mut masses = inertia.translational().symmetric_eigen();
        masses.eigenvalues.apply(|mass| *mass = 2.0 * (translational_stiffness * *mass).sqrt());
        let rotational = inertia.rotational().diagonal().map(|axis| 2.0 * (rotational_stiffness * axis).sqrt());
        Self {
            translational_stiffness,
            rotational_stiffness,
            translational_damping: masses.recompose(),
            rotational_damping: Matrix3::from_diagonal(&rotational),
        }
    }

    /// Wrench of the controller (Eq. impedancewrench) while it tracks the state `reference` with a body in `state`. The
    /// controller believes the body to be at `P_q(q, grasp)`, of [`crate::GraspError::pose`], and damps it in the frame that
    /// it believes to be that of the body. Quaternions may have any norm; the conjugate is used as the inverse.
    pub fn wrench(&self, reference: &State, state: &State, grasp: &Pose) -> Wrench {
        Wrench(self.law(&reference[..], &state[..], &grasp[..]))
    }

    /// [`Impedance::wrench`] of expressions: two states (13 each) and a pose (7).
    pub fn law<T: Number>(&self, reference: &[T], state: &[T], grasp: &[T]) -> [T; TWIST] {
        let (offset, quaternion) = grasp.split_at(3);
        let orientation = rotation(&state[3..POSE]);
        let velocity: [T; 3] = std::array::from_fn(|axis| reference[POSE + axis] - state[POSE + axis]);
        let braking = apply(&self.translational_damping, &velocity);
        let force: [T; 3] = std::array::from_fn(|axis| {
            let tracked = state[axis] + dot(&orientation[axis], offset);
            (reference[axis] - tracked) * self.translational_stiffness + braking[axis]
        });
        // Seen from the body, the error of the orientation is xi^-1 (x) xi_r (x) xi^^-1.
        let wanted = product(&reference[3..POSE], &conjugate(quaternion));
        let [scalar, vector @ ..] = product(&conjugate(&state[3..POSE]), &wanted);
        let rotation = rotation(quaternion);
        let column = |axis: usize| [rotation[0][axis], rotation[1][axis], rotation[2][axis]];
        let angular_velocity: [T; 3] =
            std::array::from_fn(|axis| reference[POSE + 3 + axis] - dot(&column(axis), &state[POSE + 3..]));
        let braking = apply(&self.rotational_damping, &angular_velocity);
        let torque: [T; 3] = std::array::from_fn(|axis| {
            scalar * vector[axis] * (2.0 * self.rotational_stiffness) + dot(&rotation[axis], &braking)
        });
        [force[0], force[1], force[2], torque[0], torque[1], torque[2]]
    }
}

//! The Cartesian impedance controller that tracks the reference.

use nalgebra::Matrix3;

use crate::algebra::{Number, apply, dot, rotation};
use crate::inertia::Inertia;
use crate::state::{POSE, TWIST};

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

impl Impedance {
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

    /// Force (N, world frame) and torque (Nm, body frame) of the controller (Eq. impedancewrench) while it tracks the
    /// state `reference` (13 numbers) with a body in `state` (13 numbers). The controller believes the body to be at
    /// `P_q(q, offset)` (offset: 3 numbers, m, body frame). Quaternions may have any norm; the conjugate is used as the
    /// inverse.
    pub fn wrench<T: Number>(&self, reference: &[T], state: &[T], offset: &[T]) -> [T; TWIST] {
        let rotation = rotation(&state[3..POSE]);
        let velocity: [T; 3] = std::array::from_fn(|axis| reference[POSE + axis] - state[POSE + axis]);
        let braking = apply(&self.translational_damping, &velocity);
        let force: [T; 3] = std::array::from_fn(|axis| {
            let tracked = state[axis] + dot(&rotation[axis], offset);
            (reference[axis] - tracked) * self.translational_stiffness + braking[axis]
        });
        let [a, b, c, d] = [state[3], -state[4], -state[5], -state[6]];
        let [e, f, g, h] = [reference[3], reference[4], reference[5], reference[6]];
        let scalar = a * e - b * f - c * g - d * h;
        let vector = [a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
        let angular_velocity: [T; 3] = std::array::from_fn(|axis| reference[POSE + 3 + axis] - state[POSE + 3 + axis]);
        let braking = apply(&self.rotational_damping, &angular_velocity);
        let torque: [T; 3] =
            std::array::from_fn(|axis| scalar * vector[axis] * (2.0 * self.rotational_stiffness) + braking[axis]);
        [force[0], force[1], force[2], torque[0], torque[1], torque[2]]
    }
}

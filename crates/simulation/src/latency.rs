//! First-order model of the controller's latency in longer steps.

use nalgebra::{Matrix3, Matrix6};
use robot::{JointMatrix, JointVector};
use task::Impedance;

use crate::arm_terms::ArmTerms;

/// The longest step replaces at most two to this power of the shortest ones.
pub const DOUBLINGS: usize = 4;
/// Longer steps are at most this multiple of the shortest time constant of the arm: faster motions follow at once.
const FOLLOWING: f64 = 4.0;
/// Of the power iteration.
const ITERATIONS: usize = 30;
/// Longer steps need a latency of at most this part of that time constant.
const PROMPT: f64 = 0.5;

/// The fastest rate (1/s) at which damping stops a motion of the arm: the largest eigenvalue of `M^-1 J' D J`, by power
/// iteration.
fn fastest_rate(terms: &ArmTerms, impedance: &Impedance) -> f64 {
    let braking = terms.mobility.inverse * terms.of_joints(&damping(impedance));
    let mut motion = JointVector::repeat(1.0);
    for _ in 0..ITERATIONS {
        motion = (braking * motion).normalize();
    }
    (braking * motion).norm()
}

/// Damping of translations (Ns/m) and rotations (Nms/rad).
fn damping(impedance: &Impedance) -> Matrix6<f64> {
    let mut damping = Matrix6::zeros();
    damping.fixed_view_mut::<3, 3>(0, 0).copy_from(&impedance.translational_damping);
    damping.fixed_view_mut::<3, 3>(3, 3).copy_from(&impedance.rotational_damping);
    damping
}

/// The mass matrix minus damping times its latency (s), to first order.
pub fn effective_mass(terms: &ArmTerms, impedance: &Impedance, latency: f64) -> JointMatrix {
    terms.mobility.mass - terms.of_joints(&damping(impedance)) * latency
}

/// The impedance of torques with a latency (s), to first order.
pub fn late(impedance: &Impedance, latency: f64) -> Impedance {
    let less = |damping: Matrix3<f64>, stiffness: f64| damping - Matrix3::from_diagonal_element(stiffness * latency);
    Impedance {
        translational_damping: less(impedance.translational_damping, impedance.translational_stiffness),
        rotational_damping: less(impedance.rotational_damping, impedance.rotational_stiffness),
        ..impedance.clone()
    }
}

/// Largest number of doublings of the shortest step (s) of an arm whose torques have a latency (s).
pub fn doublings(terms: &ArmTerms, impedance: &Impedance, latency: f64, time_step: f64) -> usize {
    doublings_at(fastest_rate(terms, impedance), latency, time_step)
}

/// The same for an arm with a fastest rate (1/s).
fn doublings_at(rate: f64, latency: f64, time_step: f64) -> usize {
    let is_allowed = |doublings: &usize| rate * time_step * f64::from(1_u32 << doublings) <= FOLLOWING;
    if rate * latency <= PROMPT { (1..=DOUBLINGS).take_while(is_allowed).count() } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_long_where_the_arm_answers_slowly_and_its_controller_at_once() {
        assert_eq!(doublings_at(200.0, 1e-3, 2e-3), 3, "16 ms");
        assert_eq!(doublings_at(1000.0, 1e-4, 2e-3), 1, "4 ms");
        assert_eq!(doublings_at(1.0, 1e-3, 2e-3), DOUBLINGS);
        assert_eq!(doublings_at(200.0, 4e-3, 2e-3), 0, "a latency of 4 ms is too long for a time constant of 5 ms");
        assert_eq!(doublings_at(f64::NAN, 1e-3, 2e-3), 0);
    }
}

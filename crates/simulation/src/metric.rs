//! The inertia of a time step, and coordinates in which it is the identity.

use nalgebra::{Isometry3, Matrix3, Vector3};
use task::{Impedance, Inertia};

use crate::least_distance::{Halfspace, Vector6};

/// Effective inertia of a step of `h` seconds that is implicit in stiffness and damping: `M + h D + h^2 K`.
#[derive(Debug, Clone)]
pub struct Metric {
    /// Lower triangular factor of `m + h D_t + h^2 k_t`.
    linear: Matrix3<f64>,
    /// Lower triangular factor of `I + h D_r + h^2 k_r`.
    angular: Matrix3<f64>,
    /// Smallest principal values of these (kg, kg m^2).
    lightest: (f64, f64),
}

impl Metric {
    /// For steps of `time_step` seconds; `None` unless the effective inertia is positive definite and finite.
    pub fn new(time_step: f64, inertia: &Inertia, impedance: &Impedance) -> Option<Self> {
        let h = time_step;
        let effective = |inertia: Matrix3<f64>, damping: Matrix3<f64>, stiffness: f64| {
            inertia + damping * h + Matrix3::from_diagonal_element(stiffness) * (h * h)
        };
        let mass = Matrix3::from_diagonal_element(inertia.mass);
        let mass = effective(mass, impedance.translational_damping, impedance.translational_stiffness);
        let rotational = effective(inertia.rotational, impedance.rotational_damping, impedance.rotational_stiffness);
        let is_finite = mass.iter().chain(&rotational).all(|entry| entry.is_finite());
        let (linear, angular) = (mass.cholesky().filter(|_| is_finite)?.l(), rotational.cholesky()?.l());
        let lightest = (mass.symmetric_eigenvalues().min(), rotational.symmetric_eigenvalues().min());
        Some(Self { linear, angular, lightest })
    }

    /// Velocity from momentum (world frame) and angular momentum (body frame), or acceleration from force and torque,
    /// in scaled coordinates: those whose squared norm is twice the kinetic energy.
    pub fn scale(&self, momentum: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        let linear = self.linear.solve_lower_triangular_unchecked(momentum);
        let angular = self.angular.solve_lower_triangular_unchecked(angular);
        Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
    }

    /// Velocity (world frame) and angular velocity (body frame) from scaled coordinates.
    pub fn unscale(&self, scaled: &Vector6) -> (Vector3<f64>, Vector3<f64>) {
        let linear = Vector3::new(scaled[0], scaled[1], scaled[2]);
        let angular = Vector3::new(scaled[3], scaled[4], scaled[5]);
        (
            self.linear.tr_solve_lower_triangular_unchecked(&linear),
            self.angular.tr_solve_lower_triangular_unchecked(&angular),
        )
    }

    /// Upper bound on the speed (m/s) of a point at most `radius` (m) away from the body's origin, with a scaled
    /// velocity.
    pub fn fastest(&self, scaled: &Vector6, radius: f64) -> f64 {
        let (mass, inertia) = self.lightest;
        scaled.norm() * (1.0 / mass.sqrt() + radius / inertia.sqrt())
    }

    /// The scaled velocities with which a point of the body (m, world frame) moves along `direction` at a speed of at
    /// least `bound` (m/s).
    pub fn halfspace(
        &self,
        pose: &Isometry3<f64>,
        point: &Vector3<f64>,
        direction: &Vector3<f64>,
        bound: f64,
    ) -> Halfspace {
        let lever = point - pose.translation.vector;
        let torque = pose.rotation.inverse_transform_vector(&lever.cross(direction));
        Halfspace { normal: self.scale(direction, &torque), bound }
    }
}

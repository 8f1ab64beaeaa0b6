//! The inertia of a time step, and coordinates in which it is the identity.

use nalgebra::{Isometry3, Matrix3, Vector3};
use task::{Impedance, Inertia};

use crate::least_distance::Vector6;

/// Effective inertia of a step of `h` seconds that is implicit in stiffness and damping: `M + h D + h^2 K`.
#[derive(Debug, Clone)]
pub struct Metric {
    mass: Matrix3<f64>,
    rotational: Matrix3<f64>,
    /// Inverse of the lower triangular factor of `m + h D_t + h^2 k_t`.
    linear: Matrix3<f64>,
    /// Inverse of the lower triangular factor of `I + h D_r + h^2 k_r`.
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
        let (linear, angular) = (linear.try_inverse()?, angular.try_inverse()?);
        let lightest = (mass.symmetric_eigenvalues().min(), rotational.symmetric_eigenvalues().min());
        Some(Self { mass, rotational, linear, angular, lightest })
    }

    /// Momentum (world frame) and angular momentum (body frame) of the effective inertia.
    pub fn momentum(&self, velocity: &Vector3<f64>, angular_velocity: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        (self.mass * velocity, self.rotational * angular_velocity)
    }

    /// Velocity from momentum (world frame) and angular momentum (body frame), or acceleration from force and torque,
    /// in scaled coordinates: those whose squared norm is twice the kinetic energy.
    pub fn scale(&self, momentum: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        joined(&(self.linear * momentum), &(self.angular * angular))
    }

    /// Velocity (world frame) and angular velocity (body frame) from scaled coordinates.
    pub fn unscale(&self, scaled: &Vector6) -> (Vector3<f64>, Vector3<f64>) {
        let linear = Vector3::new(scaled[0], scaled[1], scaled[2]);
        let angular = Vector3::new(scaled[3], scaled[4], scaled[5]);
        (self.linear.tr_mul(&linear), self.angular.tr_mul(&angular))
    }

    /// Upper bound on the speed (m/s) of a point at most `radius` (m) away from the body's origin, with a scaled
    /// velocity.
    pub fn fastest(&self, scaled: &Vector6, radius: f64) -> f64 {
        let (mass, inertia) = self.lightest;
        scaled.norm() * (1.0 / mass.sqrt() + radius / inertia.sqrt())
    }

    /// For a body at a pose.
    pub fn placed(&self, pose: &Isometry3<f64>) -> PlacedMetric {
        let to_body = pose.rotation.to_rotation_matrix().into_inner().transpose();
        PlacedMetric { position: pose.translation.vector, linear: self.linear, angular: self.angular * to_body }
    }
}

/// A metric for a body at some pose.
#[derive(Debug, Clone)]
pub struct PlacedMetric {
    position: Vector3<f64>,
    linear: Matrix3<f64>,
    /// For angular momentum in the world frame.
    angular: Matrix3<f64>,
}

impl PlacedMetric {
    /// The vector whose product with a scaled velocity is the speed (m/s) of a point of the body (m, world frame) along
    /// a direction.
    pub fn along(&self, point: &Vector3<f64>, direction: &Vector3<f64>) -> Vector6 {
        joined(&(self.linear * direction), &(self.angular * (point - self.position).cross(direction)))
    }
}

fn joined(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
    Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
}

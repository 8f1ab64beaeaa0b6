//! The inertia of a time step, and coordinates in which it is the identity.

use std::ops::AddAssign;

use nalgebra::{Isometry3, Matrix3, Matrix6, Vector3};
use task::{Impedance, Inertia};

use crate::least_distance::Vector6;

/// Effective inertia of a step of `h` seconds that is implicit in stiffness and damping: `M + h D + h^2 K`.
#[derive(Debug, Clone)]
pub struct Metric {
    effective: Matrix6<f64>,
    /// Smallest mass (kg) and rotational inertia (kg m^2) that forces and torques meet.
    lightest: (f64, f64),
    factor: InverseFactor,
}

/// Inverse of the lower triangular factor of an inertia, in blocks: those that multiply momentum, and the one that
/// multiplies angular momentum. The upper right one is zero.
#[derive(Debug, Clone)]
struct InverseFactor {
    linear: Matrix3<f64>,
    coupling: Matrix3<f64>,
    angular: Matrix3<f64>,
}

impl InverseFactor {
    fn apply(&self, momentum: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        let [linear, angular] = [self.linear * momentum, self.coupling * momentum + self.angular * angular];
        Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
    }
}

impl Metric {
    /// For steps of `time_step` seconds; `None` unless the effective inertia is positive definite and finite.
    pub fn new(time_step: f64, inertia: &Inertia, impedance: &Impedance) -> Option<Self> {
        let h = time_step;
        let added =
            |damping: Matrix3<f64>, stiffness: f64| damping * h + Matrix3::from_diagonal_element(stiffness) * (h * h);
        let linear = added(impedance.translational_damping, impedance.translational_stiffness);
        let angular = added(impedance.rotational_damping, impedance.rotational_stiffness);
        let mut effective = *inertia.matrix();
        effective.fixed_view_mut::<3, 3>(0, 0).add_assign(linear);
        effective.fixed_view_mut::<3, 3>(3, 3).add_assign(angular);
        if !effective.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let inverse = effective.cholesky()?.l().try_inverse()?;
        let block = |row: usize, column: usize| inverse.fixed_view::<3, 3>(row, column).into_owned();
        let factor = InverseFactor { linear: block(0, 0), coupling: block(3, 0), angular: block(3, 3) };
        Some(Self { lightest: Inertia::from_matrix(effective).lightest(), effective, factor })
    }

    /// `M + h D + h^2 K`.
    pub fn effective(&self) -> &Matrix6<f64> {
        &self.effective
    }

    /// Velocity from momentum (world frame) and angular momentum (body frame), or acceleration from force and torque,
    /// in scaled coordinates: those whose squared norm is twice the kinetic energy.
    pub fn scale(&self, momentum: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        self.factor.apply(momentum, angular)
    }

    /// Velocity (world frame) and angular velocity (body frame) from scaled coordinates.
    pub fn unscale(&self, scaled: &Vector6) -> (Vector3<f64>, Vector3<f64>) {
        let linear = Vector3::new(scaled[0], scaled[1], scaled[2]);
        let angular = Vector3::new(scaled[3], scaled[4], scaled[5]);
        let InverseFactor { linear: own, coupling, angular: turning } = &self.factor;
        (own.tr_mul(&linear) + coupling.tr_mul(&angular), turning.tr_mul(&angular))
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
        let factor = InverseFactor { angular: self.factor.angular * to_body, ..self.factor.clone() };
        PlacedMetric { position: pose.translation.vector, factor }
    }
}

/// A metric for a body at some pose.
#[derive(Debug, Clone)]
pub struct PlacedMetric {
    position: Vector3<f64>,
    /// For angular momentum in the world frame.
    factor: InverseFactor,
}

impl PlacedMetric {
    /// The vector whose product with a scaled velocity is the speed (m/s) of a point of the body (m, world frame) along
    /// a direction.
    pub fn along(&self, point: &Vector3<f64>, direction: &Vector3<f64>) -> Vector6 {
        self.factor.apply(direction, &(point - self.position).cross(direction))
    }
}

//! Inertias, and coordinates in which they are the identity.

use nalgebra::{Isometry3, Matrix3, Matrix6, Vector3};
use task::{Impedance, Inertia};

use crate::least_distance::Vector6;

/// Effective inertia of a step of `h` seconds that is implicit in stiffness and damping: `M + h D + h^2 K`.
pub fn effective_inertia(time_step: f64, inertia: &Inertia, impedance: &Impedance) -> Matrix6<f64> {
    inertia.matrix() + added_inertia(time_step, impedance)
}

/// What stiffness and damping add to the inertia of a step of `h` seconds that is implicit in them: `h D + h^2 K`.
pub fn added_inertia(time_step: f64, impedance: &Impedance) -> Matrix6<f64> {
    let h = time_step;
    let added =
        |damping: Matrix3<f64>, stiffness: f64| damping * h + Matrix3::from_diagonal_element(stiffness) * (h * h);
    let mut inertia = Matrix6::zeros();
    let linear = added(impedance.translational_damping, impedance.translational_stiffness);
    let angular = added(impedance.rotational_damping, impedance.rotational_stiffness);
    inertia.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
    inertia.fixed_view_mut::<3, 3>(3, 3).copy_from(&angular);
    inertia
}

/// Kinetic energy of a body as a measure of its velocity.
#[derive(Debug, Clone)]
pub struct Metric {
    /// Lower bounds on the mass (kg) and the rotational inertia (kg m^2) that forces and torques meet.
    lightest: (f64, f64),
    factor: InverseFactor,
}

/// A pivot below this part of its diagonal entry is one of a mobility without an inverse.
const SINGULAR: f64 = 1e-12;

/// Inverse of the lower triangular factor of an inertia, in blocks: those that multiply momentum, and the one that
/// multiplies angular momentum. The upper right one is zero.
#[derive(Debug, Clone)]
struct InverseFactor {
    linear: Matrix3<f64>,
    coupling: Matrix3<f64>,
    angular: Matrix3<f64>,
}

impl InverseFactor {
    fn new(inverse: &Matrix6<f64>) -> Self {
        let block = |row: usize, column: usize| inverse.fixed_view::<3, 3>(row, column).into_owned();
        Self { linear: block(0, 0), coupling: block(3, 0), angular: block(3, 3) }
    }

    fn apply(&self, momentum: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        let [linear, angular] = [self.linear * momentum, self.coupling * momentum + self.angular * angular];
        Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
    }
}

impl Metric {
    /// Of an inertia; `None` unless it is positive definite and finite.
    pub fn of_inertia(inertia: &Matrix6<f64>) -> Option<Self> {
        if !inertia.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let inverse = inertia.cholesky()?.l().try_inverse()?;
        Some(Self { lightest: Inertia::from_matrix(*inertia).lightest(), factor: InverseFactor::new(&inverse) })
    }

    /// Of the inverse of an inertia; `None` unless it is positive definite and finite.
    pub fn of_mobility(mobility: &Matrix6<f64>) -> Option<Self> {
        // The inverse factor F of the inertia has `F' F = mobility`; its last row comes first.
        let mut inverse = Matrix6::zeros();
        for row in (0..6).rev() {
            for column in (0..=row).rev() {
                let known: f64 = (row + 1..6).map(|below| inverse[(below, row)] * inverse[(below, column)]).sum();
                let rest = mobility[(row, column)] - known;
                if column < row {
                    inverse[(row, column)] = rest / inverse[(row, row)];
                } else if rest > SINGULAR * mobility[(row, row)] && rest.is_finite() {
                    inverse[(row, row)] = rest.sqrt();
                } else {
                    return None;
                }
            }
        }
        let most = |corner: usize| mobility.fixed_view::<3, 3>(corner, corner).trace();
        Some(Self { lightest: (1.0 / most(0), 1.0 / most(3)), factor: InverseFactor::new(&inverse) })
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

    /// Scaled coordinates of a velocity (world frame) and an angular velocity (body frame).
    pub fn scale_velocity(&self, velocity: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6 {
        let InverseFactor { linear: own, coupling, angular: turning } = &self.factor;
        let angular = turning.tr_solve_lower_triangular_unchecked(angular);
        let linear = own.tr_solve_lower_triangular_unchecked(&(velocity - coupling.tr_mul(&angular)));
        Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
    }

    /// Momentum (world frame) and angular momentum (body frame) of a scaled velocity, or the impulse that changes the
    /// velocity by it.
    pub fn momentum(&self, scaled: &Vector6) -> Vector6 {
        let InverseFactor { linear: own, coupling, angular: turning } = &self.factor;
        let linear = own.solve_lower_triangular_unchecked(&scaled.fixed_rows::<3>(0).into_owned());
        let rest = scaled.fixed_rows::<3>(3) - coupling * linear;
        let angular = turning.solve_lower_triangular_unchecked(&rest);
        Vector6::from([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z])
    }

    /// Upper bound on the speed (m/s) of a point at most `radius` (m) away from the body's origin, with a scaled
    /// velocity of a norm.
    pub fn fastest(&self, norm: f64, radius: f64) -> f64 {
        let (mass, inertia) = self.lightest;
        norm * (1.0 / mass.sqrt() + radius / inertia.sqrt())
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn inertia() -> impl Strategy<Value = Matrix6<f64>> {
        proptest::collection::vec(-1.0..1.0_f64, 36).prop_map(|entries| {
            let factor = Matrix6::from_column_slice(&entries);
            factor * factor.transpose() + Matrix6::identity() * 0.1
        })
    }

    proptest! {
        #[test]
        fn a_metric_of_an_inertia_is_that_of_its_inverse(
            inertia in inertia(),
            velocity in proptest::array::uniform6(-1.0..1.0_f64),
        ) {
            let velocity = Vector6::from(velocity);
            let (linear, angular) = (velocity.fixed_rows::<3>(0).into(), velocity.fixed_rows::<3>(3).into());
            let energy = velocity.dot(&(inertia * velocity));
            let mobility = inertia.try_inverse().unwrap();
            for metric in [Metric::of_inertia(&inertia).unwrap(), Metric::of_mobility(&mobility).unwrap()] {
                let scaled = metric.scale_velocity(&linear, &angular);
                prop_assert!((scaled.norm_squared() / energy - 1.0).abs() < 1e-8);
                prop_assert!((metric.momentum(&scaled) - inertia * velocity).norm() < 1e-8);
                let (back, turning) = metric.unscale(&scaled);
                prop_assert!((back - linear).norm() + (turning - angular).norm() < 1e-8);
                prop_assert!((linear + angular.cross(&(Vector3::x() * 0.2))).norm() <= metric.fastest(scaled.norm(), 0.2));
            }
        }
    }

    #[test]
    fn a_singular_mobility_has_no_metric() {
        let mut mobility = Matrix6::identity();
        assert!(Metric::of_mobility(&mobility).is_some());
        mobility[(2, 2)] = 0.0;
        assert!(Metric::of_mobility(&mobility).is_none());
        mobility[(2, 2)] = f64::NAN;
        assert!(Metric::of_mobility(&mobility).is_none());
    }
}

//! The inertia of the moved body.

use nalgebra::{Matrix3, Matrix6};

/// Apparent inertia `M` of the body under impedance control: symmetric, positive definite and constant. It multiplies
/// the velocity of the body's origin (m/s, world frame) followed by the angular velocity (rad/s, body frame).
#[derive(Debug, Clone, PartialEq)]
pub struct Inertia {
    matrix: Matrix6<f64>,
}

impl Inertia {
    /// From a rigid body whose origin is its centre of mass: mass (kg) and rotational inertia (kg m^2, body frame).
    pub fn of_body(mass: f64, rotational: Matrix3<f64>) -> Self {
        let mut matrix = Matrix6::zeros();
        matrix.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&rotational);
        Self { matrix }
    }

    /// From a symmetric positive definite matrix, such as the apparent inertia of an arm.
    pub fn from_matrix(matrix: Matrix6<f64>) -> Self {
        Self { matrix }
    }

    /// The whole matrix.
    pub fn matrix(&self) -> &Matrix6<f64> {
        &self.matrix
    }

    /// The same inertia where forces and torques are multiples of `unit` (N, Nm).
    pub fn in_units_of(&self, unit: f64) -> Self {
        Self { matrix: self.matrix / unit }
    }

    /// The block of velocities (kg).
    pub fn translational(&self) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(0, 0).into()
    }

    /// The block of angular velocities (kg m^2).
    pub fn rotational(&self) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(3, 3).into()
    }

    /// The coupling block: momentum (world frame) per angular velocity (body frame), in kg m.
    pub fn coupling(&self) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(0, 3).into()
    }

    /// The mass (kg), if it is the same along every axis and the origin is the centre of mass, as for a free rigid body.
    pub fn mass(&self) -> Option<f64> {
        let mass = self.matrix[(0, 0)];
        (self.translational() == Matrix3::from_diagonal_element(mass) && self.is_uncoupled()).then_some(mass)
    }

    /// Mean of the masses (kg) along all axes.
    pub fn mean_mass(&self) -> f64 {
        self.translational().trace() / 3.0
    }

    /// The inverse: from force (N, world frame) and torque (Nm, body frame) to accelerations. `None` unless it exists.
    pub fn inverse(&self) -> Option<Matrix6<f64>> {
        if !self.is_uncoupled() {
            return self.matrix.try_inverse();
        }
        let mut inverse = Matrix6::zeros();
        inverse.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.translational().try_inverse()?);
        inverse.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.rotational().try_inverse()?);
        Some(inverse)
    }

    /// The smallest mass (kg) that a force meets along any direction, and the smallest rotational inertia (kg m^2) that
    /// a torque meets; not a number without an inverse.
    pub fn lightest(&self) -> (f64, f64) {
        let Some(inverse) = self.inverse() else { return (f64::NAN, f64::NAN) };
        let least = |corner: usize| 1.0 / inverse.fixed_view::<3, 3>(corner, corner).symmetric_eigenvalues().max();
        (least(0), least(3))
    }

    /// The largest mass (kg) that a force meets along any direction; not a number without an inverse.
    pub fn heaviest(&self) -> f64 {
        let Some(inverse) = self.inverse() else { return f64::NAN };
        1.0 / inverse.fixed_view::<3, 3>(0, 0).symmetric_eigenvalues().min()
    }

    fn is_uncoupled(&self) -> bool {
        self.coupling() == Matrix3::zeros()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    /// A body of 2 kg whose centre of mass is `center` in its frame.
    fn off_center(center: Vector3<f64>) -> Inertia {
        let lever = center.cross_matrix();
        let mut matrix = *Inertia::of_body(2.0, Matrix3::identity() * 0.1 - lever * lever * 2.0).matrix();
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-lever * 2.0));
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(lever * 2.0));
        Inertia::from_matrix(matrix)
    }

    #[test]
    fn the_inverse_is_one_with_coupling_and_without() {
        for inertia in [Inertia::of_body(3.0, Matrix3::identity() * 0.2), off_center(Vector3::new(0.1, 0.2, 0.3))] {
            let product = inertia.matrix() * inertia.inverse().unwrap();
            assert!((product - Matrix6::identity()).amax() < 1e-13);
        }
        assert_eq!(Inertia::of_body(0.0, Matrix3::identity()).inverse(), None);
    }

    #[test]
    fn only_a_body_about_its_centre_of_mass_has_one_mass() {
        assert_eq!(Inertia::of_body(3.0, Matrix3::identity()).mass(), Some(3.0));
        assert_eq!(off_center(Vector3::x()).mass(), None);
        assert_eq!(Inertia::from_matrix(Matrix6::from_diagonal_element(1.0) + Matrix6::identity()).mass(), Some(2.0));
    }

    /// A push beside the centre of mass rotates the body instead of moving all of its mass.
    #[test]
    fn a_body_is_lightest_beside_its_centre_of_mass() {
        let (mass, rotational) = off_center(Vector3::new(0.0, 0.0, 0.3)).lightest();
        assert!((mass - 1.0 / (1.0 / 2.0 + 0.3 * 0.3 / 0.1)).abs() < 1e-12, "{mass}");
        assert!((rotational - 0.1).abs() < 1e-12, "{rotational}");
        let heaviest = off_center(Vector3::new(0.0, 0.0, 0.3)).heaviest();
        assert!((heaviest - 2.0).abs() < 1e-12, "towards the centre of mass: {heaviest}");
    }
}

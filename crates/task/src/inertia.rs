//! The inertia of the moved body.

use nalgebra::Matrix3;

/// Mass (kg) and rotational inertia about the centre of mass in the body frame (kg m^2).
#[derive(Debug, Clone, PartialEq)]
pub struct Inertia {
    /// Mass (kg).
    pub mass: f64,
    /// Symmetric positive definite rotational inertia (kg m^2).
    pub rotational: Matrix3<f64>,
}

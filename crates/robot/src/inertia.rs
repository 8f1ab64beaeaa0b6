//! Inertias of links and payloads.

use nalgebra::{IsometryMatrix3, Matrix3, Vector3};

/// Inertia of a rigid body in a frame that is fixed to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidInertia {
    pub(crate) mass: f64,
    pub(crate) centre: Vector3<f64>,
    pub(crate) rotational: Matrix3<f64>,
}

/// Why numbers are not the inertia of a rigid body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum InertiaError {
    /// The mass is negative or no number.
    #[error("a mass of {mass} kg makes no sense: give a finite number that is not negative")]
    Mass {
        /// The given mass (kg).
        mass: f64,
    },
    /// The centre of mass is no place.
    #[error("the centre of mass has a coordinate that is not a finite number")]
    Centre,
    /// The rotational inertia is no symmetric matrix of numbers.
    #[error("the rotational inertia must be a symmetric matrix of finite numbers")]
    Symmetry,
    /// A principal moment is negative.
    #[error(
        "the rotational inertia has a principal moment of {moment:.3e} kg m^2: none may be negative; check the signs of the products of inertia"
    )]
    Moment {
        /// Smallest principal moment (kg m^2).
        moment: f64,
    },
}

/// Principal moments may be negative by this part of the largest one: files have rounded numbers.
const ROUNDING: f64 = 1e-6;

impl RigidInertia {
    /// From a mass (kg), a centre of mass (m) and a rotational inertia about that (kg m^2), along the axes of the
    /// frame.
    ///
    /// # Errors
    /// When no rigid body has this inertia. Zero is allowed.
    pub fn new(mass: f64, centre: Vector3<f64>, rotational: Matrix3<f64>) -> Result<Self, InertiaError> {
        if !(mass >= 0.0 && mass.is_finite()) {
            return Err(InertiaError::Mass { mass });
        }
        if !centre.iter().all(|coordinate| coordinate.is_finite()) {
            return Err(InertiaError::Centre);
        }
        let size = rotational.amax();
        if !rotational.iter().all(|entry| entry.is_finite())
            || (rotational - rotational.transpose()).amax() > ROUNDING * size
        {
            return Err(InertiaError::Symmetry);
        }
        let rotational = (rotational + rotational.transpose()) * 0.5;
        let moment = rotational.symmetric_eigenvalues().min();
        if moment < -ROUNDING * size {
            return Err(InertiaError::Moment { moment });
        }
        Ok(Self { mass, centre, rotational })
    }

    /// No inertia.
    pub fn zero() -> Self {
        Self { mass: 0.0, centre: Vector3::zeros(), rotational: Matrix3::zeros() }
    }

    /// Mass (kg).
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Centre of mass (m).
    pub fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// Rotational inertia about the centre of mass (kg m^2).
    pub fn rotational(&self) -> Matrix3<f64> {
        self.rotational
    }

    /// The same body, seen from a frame in which its own one is at `frame`.
    pub(crate) fn seen_from(&self, frame: &IsometryMatrix3<f64>) -> Self {
        let rotation = frame.rotation.matrix();
        Self {
            mass: self.mass,
            centre: rotation * self.centre + frame.translation.vector,
            rotational: rotation * self.rotational * rotation.transpose(),
        }
    }

    /// Both bodies as one.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        let share = if mass > 0.0 { other.mass / mass } else { 0.0 };
        let centre = self.centre.lerp(&other.centre, share);
        let about_centre = |body: &Self| body.rotational + parallel_axes(&(body.centre - centre)) * body.mass;
        Self { mass, centre, rotational: about_centre(self) + about_centre(other) }
    }
}

/// `|c|^2 1 - c c'` (m^2): times the mass, what a shift by `c` from the centre of mass adds to a rotational inertia.
pub fn parallel_axes(shift: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(shift.norm_squared()) - shift * shift.transpose()
}

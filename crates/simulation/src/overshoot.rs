//! Where a motion pushes hardest.

use nalgebra::{Isometry3, Vector3};

/// Distance from the reference, which leads into a contact, to the body, at the time of the largest contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overshoot {
    /// Time as a fraction of the duration of the reference; more than 1 while its end is held.
    pub fraction: f64,
    /// From the reference to the body (m, world frame).
    pub shift: Vector3<f64>,
    /// Rotation vector from the reference to the body (rad, body frame).
    pub rotation: Vector3<f64>,
}

impl Overshoot {
    /// At the start, without a force.
    pub const NONE: Self =
        Self { fraction: 0.0, shift: Vector3::new(0.0, 0.0, 0.0), rotation: Vector3::new(0.0, 0.0, 0.0) };

    /// At a fraction of the duration, from the poses of reference and body.
    pub fn new(fraction: f64, reference: &Isometry3<f64>, body: &Isometry3<f64>) -> Self {
        Self {
            fraction,
            shift: body.translation.vector - reference.translation.vector,
            rotation: (reference.rotation.inverse() * body.rotation).scaled_axis(),
        }
    }

    /// A part of the overshoot: with a spring, it takes away that part of the force.
    pub fn scaled(&self, part: f64) -> Self {
        Self { fraction: self.fraction, shift: self.shift * part, rotation: self.rotation * part }
    }
}

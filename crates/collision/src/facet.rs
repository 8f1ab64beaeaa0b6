//! Halfspaces that bound a polytope.

use nalgebra::Vector3;

/// A halfspace `normal p <= offset` with a unit normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facet {
    pub normal: Vector3<f64>,
    pub offset: f64,
}

impl Facet {
    /// Signed distance of a point from the plane, positive outside.
    pub fn height(&self, point: &Vector3<f64>) -> f64 {
        self.normal.dot(point) - self.offset
    }
}

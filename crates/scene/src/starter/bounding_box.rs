//! Bounding boxes of meshes.

use std::path::Path;

use mesh::{Solid, TriangleMesh};

use crate::error::SceneError;

/// A box along the axes (m).
pub struct BoundingBox {
    low: [f64; 3],
    high: [f64; 3],
}

impl BoundingBox {
    /// Of the mesh in an STL or OBJ file, whose unit is `scale` metres.
    ///
    /// # Errors
    /// When it cannot be read or is no closed surface.
    pub fn of_mesh(path: &Path, scale: f64) -> Result<Self, SceneError> {
        let solid = TriangleMesh::read(path, scale).and_then(|mesh| Solid::of(&mesh));
        let [low, high] = solid.map_err(|error| SceneError::about(path, format!("mesh: {error}")))?.bounding_box();
        Ok(Self { low, high })
    }

    /// Edge lengths (m).
    pub fn edges(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.high[axis] - self.low[axis])
    }

    /// Its middle (m).
    pub fn center(&self) -> [f64; 3] {
        std::array::from_fn(|axis| 0.5 * (self.low[axis] + self.high[axis]))
    }
}

//! Bounding boxes of meshes and links.

use std::path::Path;

use mesh::{Solid, TriangleMesh};

use crate::error::SceneError;
use crate::model::points_of_only_link;

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

    /// Of the only link with collision shapes in an SDF, URDF or MJCF file.
    ///
    /// # Errors
    /// When it cannot be read or has several such links.
    pub fn of_model(path: &Path) -> Result<Self, SceneError> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points_of_only_link(path)? {
            for axis in 0..3 {
                (low[axis], high[axis]) = (low[axis].min(point[axis]), high[axis].max(point[axis]));
            }
        }
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

//! Bounding boxes of meshes and links.

use std::path::Path;

use mesh::{Solid, TriangleMesh};
use scene::{SceneError, points_of_link};

use crate::starter::Axis;

/// A box along the axes (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    low: [f64; 3],
    high: [f64; 3],
}

impl BoundingBox {
    /// The box of the mesh in an STL or OBJ file, whose unit is `scale` metres.
    ///
    /// # Errors
    /// When it cannot be read or is not a closed surface.
    pub fn of_mesh(path: &Path, scale: f64) -> Result<Self, SceneError> {
        let solid = TriangleMesh::read(path, scale).and_then(|mesh| Solid::of(&mesh));
        let [low, high] = solid.map_err(|error| SceneError::about(path, format!("mesh: {error}")))?.bounding_box();
        Ok(Self { low, high })
    }

    /// The box of a link with collision shapes in an SDF, URDF or MJCF file: the named one, or the only one.
    ///
    /// # Errors
    /// When it cannot be read, has no such link, or several and none is named.
    pub fn of_model(path: &Path, link: Option<&str>) -> Result<Self, SceneError> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points_of_link(path, link)? {
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

    /// How far a box must move along an axis to be beyond another one (m); negative where it is so already.
    pub fn distance_apart(&self, other: &Self, axis: Axis) -> f64 {
        match axis.is_negative {
            true => self.high[axis.index] - other.low[axis.index],
            false => other.high[axis.index] - self.low[axis.index],
        }
    }
}

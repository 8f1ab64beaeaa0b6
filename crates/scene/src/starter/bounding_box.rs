//! Bounding boxes of meshes.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use crate::error::SceneError;

/// A box along the axes (m).
pub struct BoundingBox {
    low: [f64; 3],
    high: [f64; 3],
}

impl BoundingBox {
    /// Of the mesh in an STL file, whose unit is `scale` metres.
    ///
    /// # Errors
    /// When the file cannot be read, or is flat.
    pub fn of_mesh(path: &Path, scale: f64) -> Result<Self, SceneError> {
        let refuse = |reason: String| SceneError::about(path, format!("the mesh cannot be read: {reason}"));
        if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("stl")) {
            return Err(refuse("only files that end with .stl are".to_owned()));
        }
        let mut reader = BufReader::new(File::open(path).map_err(|error| refuse(error.to_string()))?);
        let mut found = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        for triangle in stl_io::create_stl_reader(&mut reader).map_err(|error| refuse(error.to_string()))? {
            let triangle = triangle.map_err(|error| refuse(error.to_string()))?;
            triangle
                .vertices
                .iter()
                .for_each(|vertex| found.add(vertex.0.map(|coordinate| scale * f64::from(coordinate))));
        }
        if found.edges().iter().all(|edge| *edge > 0.0 && edge.is_finite()) {
            Ok(found)
        } else {
            Err(refuse("it encloses no volume".to_owned()))
        }
    }

    fn add(&mut self, point: [f64; 3]) {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(point[axis]);
            self.high[axis] = self.high[axis].max(point[axis]);
        }
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

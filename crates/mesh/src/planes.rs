//! The distinct planes of a part.

use crate::cell::Bound;
use crate::geometry::{Plane, Vector};

/// Planes, each once for both of its sides.
#[derive(Debug, Clone, Default)]
pub struct Planes {
    planes: Vec<Plane>,
}

impl Planes {
    /// The bound of a plane, which is an older one if the points in the plane lie within the tolerance (m) of that.
    pub fn bound(&mut self, plane: &Plane, points: &[Vector], tolerance: f64) -> Bound {
        const ALIKE: f64 = 0.99;
        let older = self.planes.iter().position(|older| {
            older.normal.dot(&plane.normal).abs() > ALIKE
                && points.iter().all(|point| older.height(point).abs() <= tolerance)
        });
        let id = older.unwrap_or_else(|| {
            self.planes.push(*plane);
            self.planes.len() - 1
        });
        let known = self.planes[id];
        let is_flipped = known.normal.dot(&plane.normal) < 0.0;
        Bound { id, is_flipped, plane: if is_flipped { known.flipped() } else { known } }
    }

    pub fn get(&self, id: usize) -> Bound {
        Bound { id, is_flipped: false, plane: self.planes[id] }
    }

    pub fn len(&self) -> usize {
        self.planes.len()
    }
}

//! Boxes around parts.

use crate::starter::Axis;

/// A box along the axes (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    low: [f64; 3],
    high: [f64; 3],
}

impl BoundingBox {
    /// Around triangles (m).
    pub fn around(triangles: &[[[f64; 3]; 3]]) -> Self {
        let start = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        triangles.iter().flatten().fold(start, |bounds, point| Self {
            low: std::array::from_fn(|axis| bounds.low[axis].min(point[axis])),
            high: std::array::from_fn(|axis| bounds.high[axis].max(point[axis])),
        })
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

//! Planes and convex polygons.

use nalgebra::Vector3;

/// A point or direction.
pub type Vector = Vector3<f64>;

/// The halfspace `normal p <= offset` and the plane that bounds it. The normal has length one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    pub normal: Vector,
    pub offset: f64,
}

impl Plane {
    /// The plane through a point.
    pub fn through(point: &Vector, normal: Vector) -> Self {
        Self { normal, offset: normal.dot(point) }
    }

    /// Signed height of a point in front of the plane (m).
    pub fn height(&self, point: &Vector) -> f64 {
        self.normal.dot(point) - self.offset
    }

    /// Smallest and largest height of points (m).
    pub fn heights<'a>(&self, points: impl IntoIterator<Item = &'a Vector>) -> (f64, f64) {
        points
            .into_iter()
            .map(|point| self.height(point))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |range, height| (range.0.min(height), range.1.max(height)))
    }

    /// The same plane seen from the other side.
    pub fn flipped(&self) -> Self {
        Self { normal: -self.normal, offset: -self.offset }
    }

    /// The plane moved along its normal (m).
    pub fn moved(&self, distance: f64) -> Self {
        Self { offset: self.offset + distance, ..*self }
    }
}

/// The area of a polygon in space times its unit normal (m^2).
pub fn area_vector(polygon: &[Vector]) -> Vector {
    let Some(first) = polygon.first() else { return Vector::zeros() };
    let edges = polygon.windows(2).map(|pair| (pair[0] - first).cross(&(pair[1] - first)));
    0.5 * edges.sum::<Vector>()
}

/// The mean of points.
pub fn mean<'a>(points: impl IntoIterator<Item = &'a Vector>) -> Vector {
    let (sum, count) = points.into_iter().fold((Vector::zeros(), 0), |(sum, count), point| (sum + point, count + 1));
    sum / f64::from(count.max(1))
}

/// The part of a convex polygon behind a plane. Corners within the tolerance (m) of the plane count as on it; what only
/// touches the plane is empty unless all of it lies there.
pub fn clip(polygon: &[Vector], plane: &Plane, tolerance: f64) -> Vec<Vector> {
    let (low, high) = plane.heights(polygon);
    if high <= tolerance {
        return polygon.to_vec();
    }
    if low >= -tolerance {
        return Vec::new();
    }
    let mut behind = Vec::with_capacity(polygon.len() + 1);
    for (index, end) in polygon.iter().enumerate() {
        let start = &polygon[(index + polygon.len() - 1) % polygon.len()];
        let (from, to) = (plane.height(start), plane.height(end));
        if (from < -tolerance && to > tolerance) || (from > tolerance && to < -tolerance) {
            behind.push(start + (end - start) * (from / (from - to)));
        }
        if to <= tolerance {
            behind.push(*end);
        }
    }
    behind
}

/// Smallest box around points: lower and upper corner.
pub fn bounds<'a>(points: impl IntoIterator<Item = &'a Vector>) -> [Vector; 2] {
    let empty = [Vector::repeat(f64::INFINITY), Vector::repeat(f64::NEG_INFINITY)];
    points.into_iter().fold(empty, |[low, high], point| [low.inf(point), high.sup(point)])
}

/// Whether two boxes come within a distance (m) of each other along each axis.
pub fn boxes_meet([low, high]: &[Vector; 2], [other_low, other_high]: &[Vector; 2], distance: f64) -> bool {
    (0..3).all(|axis| low[axis] <= other_high[axis] + distance && other_low[axis] <= high[axis] + distance)
}

//! Inside and outside of a surface, and distances from it.

use crate::bvh::BoxTree;
use crate::geometry::{Vector, bounds};
use crate::nearest::squared_distance;
use crate::outward::Outward;
use crate::solid::Solid;
use crate::winding::Winding;

/// Error of computed distances (m).
const ROUNDING: f64 = 1e-12;

/// A solid that can be asked for distances.
pub struct Body {
    triangles: Vec<[Vector; 3]>,
    tree: BoxTree,
    winding: Winding,
    /// Where it neither crosses itself nor lies within itself.
    outward: Option<Outward>,
}

impl Body {
    /// Of a surface that may cross itself.
    pub fn new(triangles: Vec<[Vector; 3]>) -> Self {
        Self::with(triangles, None)
    }

    /// Of the surface of a solid.
    pub fn of(solid: &Solid) -> Self {
        let corners = (0..solid.triangles.len()).map(|triangle| solid.corners(triangle));
        Self::with(corners.collect(), (!solid.is_rough()).then(|| Outward::of(solid)))
    }

    fn with(triangles: Vec<[Vector; 3]>, outward: Option<Outward>) -> Self {
        let tree = BoxTree::new(&triangles.iter().map(bounds).collect::<Vec<_>>());
        Self { winding: Winding::new(triangles.clone()), triangles, tree, outward }
    }

    /// The triangle nearest to a point, and its distance (m).
    pub fn distance(&self, point: &Vector) -> (usize, f64) {
        self.distance_within(point, f64::INFINITY)
    }

    /// The same where the distance is known to be no more than this (m).
    pub fn distance_within(&self, point: &Vector, most: f64) -> (usize, f64) {
        let to = |triangle: usize, most: f64| squared_distance(point, &self.triangles[triangle], most);
        let (triangle, squared) = self.tree.nearest(point, most + ROUNDING, to);
        (triangle, squared.sqrt())
    }

    /// How often the surface runs around a point, within some hundredths.
    pub fn winding_number(&self, point: &Vector) -> f64 {
        self.winding.number(point)
    }

    /// Whether a point is outside whose nearest triangle is known: in front of that, unless the surface crosses itself.
    pub fn is_beyond(&self, point: &Vector, triangle: usize) -> bool {
        let known = |outward: &Outward| outward.is_beyond(point, triangle, &self.triangles[triangle]);
        self.outward.as_ref().and_then(known).unwrap_or_else(|| !self.contains(point))
    }

    /// Whether a point is inside: the surface runs around it more often than not.
    pub fn contains(&self, point: &Vector) -> bool {
        self.winding.number(point) > 0.5
    }

    /// Where the line from a point along a direction passes the surface, ahead and behind: coordinates along it (m, for a unit
    /// vector) in rising order, each with whether the line leaves the inside there.
    pub fn crossings(&self, point: &Vector, direction: &Vector) -> Vec<(f64, bool)> {
        let meets = |[low, high]: &[Vector; 2]| {
            let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
            for axis in 0..3 {
                let [one, other] = [low, high].map(|side| (side[axis] - point[axis]) / direction[axis]);
                from = from.max(one.min(other));
                to = to.min(one.max(other));
            }
            from <= to
        };
        let mut crossings = Vec::new();
        self.tree.visit(meets, |triangle| {
            let [a, b, c] = self.triangles[triangle].map(|corner| corner - point);
            let [u, v, w] = [a.cross(&b), b.cross(&c), c.cross(&a)].map(|normal| direction.dot(&normal));
            if (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0) {
                crossings.push((a.dot(&b.cross(&c)) / (u + v + w), u > 0.0));
            }
        });
        crossings.sort_by(|one, other| one.0.total_cmp(&other.0));
        crossings
    }

    pub fn triangles(&self) -> &[[Vector; 3]] {
        &self.triangles
    }
}

//! How far a surface can be moved past another one.

use std::collections::{HashSet, VecDeque};

use nalgebra::{Isometry3, Translation3};

use crate::body::Body;
use crate::gap::Gauge;
use crate::geometry::{Vector, bounds, mean};

/// Points of a surface at which depths are looked for are no farther apart than this share of its size, unless that makes
/// too many.
const SPACING: f64 = 0.02;
const MOST_POINTS: usize = 2000;
/// Depth (m) that is rounding.
const ROUNDING: f64 = 1e-9;
/// Shortest step along a direction, as a share of the travel that is looked at.
const STEP: f64 = 1e-2;
/// Penetration that is rounding, as a share of the same travel.
const TOUCHING: f64 = 1e-4;

/// Two surfaces in one frame, of which the first is moved without turning.
pub struct Separation {
    gauges: [Gauge; 2],
    sides: [Side; 2],
}

/// A surface, with points of it.
struct Side {
    body: Body,
    bounds: [Vector; 2],
    /// Corners of triangles and points between them.
    points: Vec<Vector>,
}

impl Separation {
    /// Of triangles (m), anticlockwise seen from outside.
    pub fn new(moved: &[[[f64; 3]; 3]], fixed: &[[[f64; 3]; 3]]) -> Self {
        Self { gauges: [moved, fixed].map(Gauge::new), sides: [moved, fixed].map(Side::new) }
    }

    /// How far the surfaces are apart when the first is moved by a vector (m): exact where they do not meet; where they do,
    /// the depth of their penetration as a negative number, of points of both surfaces.
    pub fn at(&self, by: &[f64; 3]) -> f64 {
        let by = Vector::from(*by);
        let [moved, fixed] = &self.gauges;
        let gap = fixed.gap(moved, &Isometry3::from_parts(Translation3::from(by), nalgebra::one()));
        if gap > 0.0 {
            return gap;
        }
        let [moved, fixed] = &self.sides;
        let depth = fixed.depth(moved, &by).max(moved.depth(fixed, &-by));
        if depth > ROUNDING { -depth } else { gap }
    }

    /// How far the surface is moved along a unit vector, from where it is moved by another vector (m), until it meets the
    /// other one, if it does within the longest travel that is looked at. Surfaces that penetrate each other already are
    /// moved until they do so deeper.
    pub fn travel(&self, from: &[f64; 3], direction: &[f64; 3], longest: f64) -> Option<f64> {
        if longest == 0.0 {
            return None;
        }
        let there =
            |travelled: f64| -> [f64; 3] { std::array::from_fn(|axis| from[axis] + travelled * direction[axis]) };
        let (mut travelled, mut apart) = (0.0, self.at(from));
        let floor = apart.min(0.0) - TOUCHING * longest;
        while travelled <= longest {
            let next = travelled + apart.max(STEP * longest);
            let then = self.at(&there(next));
            if then < floor {
                return Some(travelled + apart.max(0.0));
            }
            (travelled, apart) = (next, then);
        }
        None
    }
}

impl Side {
    fn new(triangles: &[[[f64; 3]; 3]]) -> Self {
        let triangles: Vec<[Vector; 3]> = triangles.iter().map(|triangle| triangle.map(Vector::from)).collect();
        let bounds = bounds(triangles.iter().flatten());
        let spacing = SPACING * (bounds[1] - bounds[0]).amax();
        Self { points: points(&triangles, spacing), body: Body::new(triangles), bounds }
    }

    /// The largest depth of points of another surface in this one, when that is moved by a vector (m).
    fn depth(&self, other: &Self, by: &Vector) -> f64 {
        let [low, high] = &self.bounds;
        let placed = other.points.iter().map(|point| point + by);
        let near = placed.filter(|point| (0..3).all(|axis| (low[axis]..=high[axis]).contains(&point[axis])));
        let inside = near.filter(|point| self.body.contains(point));
        inside.map(|point| self.body.distance(&point).1).fold(0.0, f64::max)
    }
}

/// Corners of triangles and points between them.
fn points(triangles: &[[Vector; 3]], spacing: f64) -> Vec<Vector> {
    let mut points: Vec<Vector> = triangles.iter().flatten().copied().collect();
    let mut waiting: VecDeque<[Vector; 3]> = triangles.iter().copied().collect();
    while let Some([a, b, c]) = waiting.pop_front() {
        points.push(mean(&[a, b, c]));
        let longest = [a - b, b - c, c - a].iter().map(Vector::norm).fold(0.0, f64::max);
        if longest > spacing && points.len() < MOST_POINTS {
            let (ab, bc, ca) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a));
            points.extend([ab, bc, ca]);
            waiting.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
    }
    let key = |point: &Vector| -> [i64; 3] { std::array::from_fn(|axis| (8.0 * point[axis] / spacing).floor() as i64) };
    let mut known = HashSet::new();
    points.retain(|point| known.insert(key(point)));
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hull::hull_triangles;

    fn block(low: [f64; 3], high: [f64; 3]) -> Vec<[[f64; 3]; 3]> {
        let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 0 { low[axis] } else { high[axis] });
        hull_triangles(&(0..8).map(corner).collect::<Vec<_>>())
    }

    #[test]
    fn a_block_on_a_plate_slides_and_rises_and_sinks_nowhere() {
        let plate = block([-1.0, -1.0, -0.2], [1.0, 1.0, 0.0]);
        let separation = Separation::new(&block([-0.1, -0.1, 0.0], [0.1, 0.1, 0.3]), &plate);
        assert_eq!(separation.at(&[0.0; 3]), 0.0);
        assert!((separation.at(&[0.0, 0.0, 0.25]) - 0.25).abs() < 1e-9);
        assert!((separation.at(&[0.0, 0.0, -0.05]) + 0.05).abs() < 1e-9);
        assert_eq!(separation.travel(&[0.0; 3], &[0.0, 0.0, 1.0], 2.0), None);
        assert_eq!(separation.travel(&[0.0; 3], &[1.0, 0.0, 0.0], 2.0), None);
        assert_eq!(separation.travel(&[0.0; 3], &[0.0, 0.0, -1.0], 2.0), Some(0.0));
        let travel = separation.travel(&[0.0, 0.0, 0.5], &[0.0, 0.0, -1.0], 2.0).unwrap();
        assert!((travel - 0.5).abs() < 0.005, "{travel}");
    }

    #[test]
    fn a_bar_through_a_thin_wall_is_seen_although_no_corner_is_inside() {
        let wall = block([-1.0, -1.0, -0.05], [1.0, 1.0, 0.05]);
        let separation = Separation::new(&block([-0.1, -0.1, -0.5], [0.1, 0.1, 0.5]), &wall);
        let depth = -separation.at(&[0.0; 3]);
        assert!((0.04..=0.11).contains(&depth), "{depth}");
    }
}

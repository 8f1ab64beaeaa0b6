//! How far a surface can be moved past another one.

use std::collections::{HashSet, VecDeque};
use std::ops::ControlFlow;

use nalgebra::{Isometry3, Translation3};
use workers::Workers;

use crate::body::Body;
use crate::gap::Gauge;
use crate::geometry::{Vector, bounds, boxes_meet, mean};

/// Points of a surface at which depths are looked for are no farther apart than this share of its size, unless that makes
/// too many.
const SPACING: f64 = 0.02;
const MOST_POINTS: usize = 2000;
/// Points that one thread moves together.
const CHUNK: usize = 50;
/// Depth (m) that is rounding.
const ROUNDING: f64 = 1e-9;
/// Longest step of a point inside of the other surface, as a share of the travel that is looked at.
const STEP: f64 = 1e-2;
/// Least number of steps of a point in the other surface.
const LEAST_STEPS: f64 = 8.0;
/// Penetration that is rounding, as a share of the same travel.
const TOUCHING: f64 = 1e-4;
/// By how much lines along which points travel are moved aside (sizes of a surface), so that none runs along an edge.
const ASIDE: [f64; 3] = [1.7e-7, 2.3e-7, 1.3e-7];

/// Two surfaces in one frame, of which the first is moved without turning.
pub struct Separation {
    gauges: [Gauge; 2],
    sides: [Side; 2],
    /// How far apart they are before.
    apart: f64,
    workers: Workers,
}

/// How deep two surfaces penetrate each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Penetration {
    /// Distance of the deepest point from the other surface (m), zero where none is inside.
    pub depth: f64,
    /// That point, in the frame of the surface that is not moved (m).
    pub place: [f64; 3],
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
        let (gauges, sides) = ([moved, fixed].map(Gauge::new), [moved, fixed].map(Side::new));
        let mut separation = Self { gauges, sides, apart: 0.0, workers: Workers::of_all_processors() };
        separation.apart = separation.at(&[0.0; 3]);
        separation
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
        let depth = self.penetration(&by.into()).depth;
        if depth > ROUNDING { -depth } else { gap }
    }

    /// The deepest of the points of both surfaces that are inside of the other one when the first is moved by a vector (m).
    pub fn penetration(&self, by: &[f64; 3]) -> Penetration {
        let by = Vector::from(*by);
        let [moved, fixed] = &self.sides;
        let (depth, point) = fixed.depth(moved, &by);
        let (other_depth, other_point) = moved.depth(fixed, &-by);
        if depth >= other_depth {
            Penetration { depth, place: point.into() }
        } else {
            Penetration { depth: other_depth, place: (other_point + by).into() }
        }
    }

    /// How far the surface is moved along a unit vector until it meets the other one, if it does within the longest travel
    /// (m) that is looked at. Surfaces that penetrate each other already are moved until they do so deeper.
    pub fn travel(&self, direction: &[f64; 3], longest: f64) -> Option<f64> {
        let direction = Vector::from(*direction);
        let deepest = self.deepest(longest);
        let [moved, fixed] = &self.sides;
        let travel = fixed.travel(moved, &direction, longest, deepest);
        let travel = moved.travel(fixed, &-direction, travel.unwrap_or(longest), deepest).or(travel);
        travel.map(|travel| travel.max(self.apart))
    }

    /// Whether the surface meets nothing when it is moved along a unit vector as far as this (m).
    pub fn is_free(&self, direction: &[f64; 3], longest: f64) -> bool {
        let direction = Vector::from(*direction);
        let deepest = self.deepest(longest);
        let [moved, fixed] = &self.sides;
        let is_met = |side: &Side, other: &Side, direction: &Vector| {
            let mut is_met = false;
            let meet = |points: &[Vector]| points.iter().any(|p| side.meets(p, direction, longest, deepest).is_some());
            self.workers.in_order(other.points.chunks(CHUNK), meet, |found| {
                is_met = found;
                if found { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            is_met
        };
        !is_met(fixed, moved, &direction) && !is_met(moved, fixed, &-direction)
    }

    /// How deep surfaces penetrate without meeting (m), of a travel that is looked at (m).
    fn deepest(&self, longest: f64) -> f64 {
        TOUCHING * longest - self.apart.min(0.0)
    }
}

impl Side {
    fn new(triangles: &[[[f64; 3]; 3]]) -> Self {
        let triangles: Vec<[Vector; 3]> = triangles.iter().map(|triangle| triangle.map(Vector::from)).collect();
        let bounds = bounds(triangles.iter().flatten());
        let spacing = SPACING * (bounds[1] - bounds[0]).amax();
        Self { points: points(&triangles, spacing), body: Body::new(triangles), bounds }
    }

    /// The largest depth of points of another surface in this one, when that is moved by a vector (m), and the deepest point.
    fn depth(&self, other: &Self, by: &Vector) -> (f64, Vector) {
        let [low, high] = &self.bounds;
        let is_near = |point: &Vector| (0..3).all(|axis| (low[axis]..=high[axis]).contains(&point[axis]));
        let mut deepest = (0.0, Vector::zeros());
        for point in other.points.iter().map(|point| point + by).filter(is_near) {
            let depth = self.body.distance(&point).1;
            if depth > deepest.0 && self.body.contains(&point) {
                deepest = (depth, point);
            }
        }
        deepest
    }

    /// How far points of another surface are moved along a unit vector until one of them is deeper in this surface than a
    /// limit (m), if one is within the longest travel (m).
    fn travel(&self, other: &Self, direction: &Vector, longest: f64, limit: f64) -> Option<f64> {
        let mut shortest = None;
        for point in &other.points {
            shortest = self.meets(point, direction, shortest.unwrap_or(longest), limit).or(shortest);
        }
        shortest
    }

    /// How far a point is moved along a unit vector until it meets the surface, in which it is deeper than a limit (m) then or
    /// further on, if that is within the longest travel (m).
    fn meets(&self, point: &Vector, direction: &Vector, longest: f64, limit: f64) -> Option<f64> {
        let [low, high] = &self.bounds;
        let end = point + direction * longest;
        if !boxes_meet(&[point.inf(&end), point.sup(&end)], &self.bounds, 0.0) {
            return None;
        }
        let aside = Vector::from(ASIDE) * (high - low).amax();
        let crossings = self.body.crossings(&(point + aside), direction);
        inside(&crossings).find_map(|(enters, leaves)| {
            // Nowhere is the point deeper than it is away from where it enters and leaves.
            let (first, last) = ((enters + limit).max(0.0), (leaves - limit).min(longest));
            let step = (STEP * longest).min((last - first) / LEAST_STEPS);
            let deep = self.deeper(point, direction, (first, last), limit, step)?;
            // A point that comes from outside has met the surface where it enters it.
            Some(if enters > 0.0 { enters } else { deep })
        })
    }

    /// Where on its way along a direction between two coordinates (m) a point is first deeper than a limit (m).
    fn deeper(
        &self,
        point: &Vector,
        direction: &Vector,
        (first, last): (f64, f64),
        limit: f64,
        step: f64,
    ) -> Option<f64> {
        let mut travelled = first;
        while travelled < last {
            let there = point + direction * travelled;
            let distance = self.body.distance(&there).1;
            if distance > limit && self.body.contains(&there) {
                return Some(travelled);
            }
            travelled += step.max(limit - distance);
        }
        None
    }
}

/// Where a line is inside of a surface that it crosses.
fn inside(crossings: &[(f64, bool)]) -> impl Iterator<Item = (f64, f64)> {
    let mut winding = 0;
    crossings.windows(2).filter_map(move |pair| {
        winding += if pair[0].1 { -1 } else { 1 };
        (winding > 0).then_some((pair[0].0, pair[1].0))
    })
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
        assert_eq!(separation.travel(&[0.0, 0.0, 1.0], 2.0), None);
        assert_eq!(separation.travel(&[1.0, 0.0, 0.0], 2.0), None);
        let travel = separation.travel(&[0.0, 0.0, -1.0], 2.0).unwrap();
        assert!((0.0..1e-5).contains(&travel), "{travel}");
        let above = Separation::new(&block([-0.1, -0.1, 0.5], [0.1, 0.1, 0.8]), &plate);
        let travel = above.travel(&[0.0, 0.0, -1.0], 2.0).unwrap();
        assert!((travel - 0.5).abs() < 1e-5, "{travel}");
    }

    #[test]
    fn a_thin_wall_far_away_is_met() {
        let wall = block([-1.0, -1.0, -0.002], [1.0, 1.0, 0.0]);
        let separation = Separation::new(&block([-0.1, -0.1, 1.0], [0.1, 0.1, 1.3]), &wall);
        let travel = separation.travel(&[0.0, 0.0, -1.0], 2.0).unwrap();
        assert!((travel - 1.0).abs() < 1e-5, "{travel}");
    }

    #[test]
    fn a_pin_pressed_into_a_hole_slides_out_as_deep_as_it_is() {
        // The pin is 0.02 wider than the groove, on both sides.
        let walls: Vec<[[f64; 3]; 3]> =
            [block([-1.0, -1.0, 0.0], [-0.1, 1.0, 1.0]), block([0.1, -1.0, 0.0], [1.0, 1.0, 1.0])].concat();
        let separation = Separation::new(&block([-0.12, -0.5, 0.2], [0.12, 0.5, 1.5]), &walls);
        assert!((separation.at(&[0.0; 3]) + 0.02).abs() < 1e-9);
        assert_eq!(separation.travel(&[0.0, 0.0, 1.0], 2.0), None);
        assert!(separation.travel(&[1.0, 0.0, 0.0], 2.0).unwrap() < 0.01);
    }

    #[test]
    fn a_bar_through_a_thin_wall_is_seen_although_no_corner_is_inside() {
        let wall = block([-1.0, -1.0, -0.05], [1.0, 1.0, 0.05]);
        let separation = Separation::new(&block([-0.1, -0.1, -0.5], [0.1, 0.1, 0.5]), &wall);
        let depth = -separation.at(&[0.0; 3]);
        assert!((0.04..=0.11).contains(&depth), "{depth}");
    }
}

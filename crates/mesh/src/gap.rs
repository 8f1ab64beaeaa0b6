//! The distance between two surfaces.

use nalgebra::{Isometry3, Point3};

use crate::bvh::{BoxTree, squared_gap};
use crate::geometry::{Plane, Vector, area_vector, bounds};
use crate::nearest::nearest;
use crate::solid::Solid;
use crate::winding::Winding;

/// Corners that are asked whether one surface is inside the other.
const WITNESSES: usize = 16;

/// A surface to which distances are measured.
pub struct Gauge {
    triangles: Vec<[Vector; 3]>,
    boxes: Vec<[Vector; 2]>,
    tree: BoxTree,
    winding: Winding,
}

impl Gauge {
    /// Of triangles (m).
    pub fn new(triangles: &[[[f64; 3]; 3]]) -> Self {
        let triangles: Vec<[Vector; 3]> = triangles.iter().map(|triangle| triangle.map(Vector::from)).collect();
        let boxes: Vec<[Vector; 2]> = triangles.iter().map(bounds).collect();
        Self { tree: BoxTree::new(&boxes), winding: Winding::new(triangles.clone()), triangles, boxes }
    }

    /// Of a solid.
    pub fn of(solid: &Solid) -> Self {
        Self::new(&solid.corner_triangles().collect::<Vec<_>>())
    }

    /// Distance (m) to another surface in a pose; zero where they meet or the one lies inside the other.
    pub fn gap(&self, other: &Self, pose: &Isometry3<f64>) -> f64 {
        let placed: Vec<[Vector; 3]> = other
            .triangles
            .iter()
            .map(|triangle| triangle.map(|corner| pose.transform_point(&Point3::from(corner)).coords))
            .collect();
        let boxes: Vec<[Vector; 2]> = placed.iter().map(bounds).collect();
        let gap = self.tree.least_between(&BoxTree::new(&boxes), |own, other, least| {
            let is_near = squared_gap(&self.boxes[own], &boxes[other]) < least * least;
            if is_near { distance(&self.triangles[own], &placed[other]) } else { least }
        });
        let back = |corner: Vector| pose.inverse_transform_point(&Point3::from(corner)).coords;
        if gap > 0.0
            && (self.is_around(placed.iter().map(|triangle| triangle[0]))
                || other.is_around(self.triangles.iter().map(|triangle| back(triangle[0]))))
        {
            return 0.0;
        }
        gap
    }

    /// Whether the surface is around some of the points.
    fn is_around(&self, points: impl ExactSizeIterator<Item = Vector>) -> bool {
        let stride = points.len().div_ceil(WITNESSES).max(1);
        points.step_by(stride).any(|point| self.winding.number(&point) > 0.5)
    }
}

/// Distance of two triangles (m).
fn distance(one: &[Vector; 3], other: &[Vector; 3]) -> f64 {
    if pierces(one, other) || pierces(other, one) {
        return 0.0;
    }
    let corners = |from: &[Vector; 3], to: &[Vector; 3]| {
        from.iter().map(|corner| (nearest(corner, to) - corner).norm()).fold(f64::INFINITY, f64::min)
    };
    let sides = |triangle: &[Vector; 3]| [0, 1, 2].map(|at| (triangle[at], triangle[(at + 1) % 3]));
    let edges =
        sides(one).iter().flat_map(|one| sides(other).map(|other| between(one, &other))).fold(f64::INFINITY, f64::min);
    corners(one, other).min(corners(other, one)).min(edges)
}

/// Distance of two line segments (m).
fn between((a, b): &(Vector, Vector), (c, d): &(Vector, Vector)) -> f64 {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv, uw, vw) = (u.dot(&u), u.dot(&v), v.dot(&v), u.dot(&w), v.dot(&w));
    let determinant = uu * vv - uv * uv;
    let on = |share: f64| if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    let s = on((uv * vw - vv * uw) / determinant);
    // Of the one segment the nearest to a point of the other, and back.
    let t = on((uv * s + vw) / vv);
    let s = on((uv * t - uw) / uu);
    (w + u * s - v * t).norm()
}

/// Whether a side of a triangle passes through another one.
fn pierces(triangle: &[Vector; 3], by: &[Vector; 3]) -> bool {
    let Some(normal) = area_vector(triangle).try_normalize(0.0) else { return false };
    let plane = Plane::through(&triangle[0], normal);
    let heights = by.map(|corner| plane.height(&corner));
    (0..3).map(|at| (at, (at + 1) % 3)).filter(|&(from, to)| heights[from] * heights[to] < 0.0).any(|(from, to)| {
        let point = by[from] + (by[to] - by[from]) * (heights[from] / (heights[from] - heights[to]));
        let is_left = |at: usize| {
            let (start, end) = (triangle[at], triangle[(at + 1) % 3]);
            normal.dot(&(end - start).cross(&(point - start))) >= 0.0
        };
        (0..3).all(is_left)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube(low: f64, high: f64) -> Vec<[[f64; 3]; 3]> {
        let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 0 { low } else { high });
        crate::hull::hull_triangles(&(0..8).map(corner).collect::<Vec<_>>())
    }

    #[test]
    fn gaps_between_cubes_are_those_of_faces_edges_and_corners() {
        let gauge = Gauge::new(&cube(0.0, 1.0));
        let gap = |x: f64, y: f64, z: f64| gauge.gap(&Gauge::new(&cube(0.0, 1.0)), &Isometry3::translation(x, y, z));
        assert!((gap(1.25, 0.3, 0.2) - 0.25).abs() < 1e-12);
        assert!((gap(1.3, 1.4, 0.2) - 0.5).abs() < 1e-12);
        assert!((gap(1.2, 1.4, 1.4) - 0.6).abs() < 1e-12);
        assert_eq!(gap(0.7, 0.6, 0.2), 0.0);
        // One inside the other.
        assert_eq!(gauge.gap(&Gauge::new(&cube(0.4, 0.5)), &Isometry3::identity()), 0.0);
        assert_eq!(gauge.gap(&Gauge::new(&cube(-2.0, 3.0)), &Isometry3::identity()), 0.0);
        // Edges across each other: a cube on its edge above an edge of the other.
        let turned = Isometry3::rotation(nalgebra::Vector3::x() * std::f64::consts::FRAC_PI_4);
        let above = nalgebra::Translation3::new(0.5, 0.5, 1.1) * turned;
        assert!((gauge.gap(&Gauge::new(&cube(0.0, 1.0)), &above) - 0.1).abs() < 1e-12);
    }
}

//! Triangles of simple polygons.

use std::collections::BTreeSet;

use robust::{Coord, orient2d};

use crate::bvh::BoxTree;
use crate::geometry::{Vector, area_vector, bounds, boxes_meet};

/// Triangles (indices of corners) of a simple polygon that is nearly planar, with its orientation. Of a polygon that is
/// not simple the triangles still have its boundary.
///
/// Ears are cut off, always the one with the smallest index. A corner in whose triangle a reflex corner lies waits until
/// that one is gone or reflex no more.
pub fn triangulate(polygon: &[Vector]) -> Vec<[usize; 3]> {
    let mut ring = Ring::of(polygon);
    let mut candidates: BTreeSet<usize> = (0..polygon.len()).collect();
    let mut waiting: Vec<Vec<usize>> = vec![Vec::new(); polygon.len()];
    let mut triangles = Vec::with_capacity(polygon.len().saturating_sub(2));
    for _ in 3..polygon.len() {
        let ear = loop {
            // Without an ear the polygon is degenerate or crosses itself: any triangle will do.
            let Some(candidate) = candidates.pop_first() else { break ring.first };
            if !ring.is_left[candidate] || ring.is_reflex(candidate) {
                continue;
            }
            match ring.obstacle(candidate) {
                Some(reflex) => waiting[reflex].push(candidate),
                None => break candidate,
            }
        };
        let [before, _, after] = ring.around(ear);
        triangles.push([before, ear, after]);
        ring.remove(ear);
        candidates.extend(waiting[ear].drain(..));
        for neighbor in [before, after] {
            candidates.insert(neighbor);
            if !ring.is_reflex(neighbor) {
                candidates.extend(waiting[neighbor].drain(..));
            }
        }
    }
    if polygon.len() >= 3 {
        triangles.push(ring.around(ring.next[ring.first]));
    }
    triangles
}

/// The corners of a polygon that are left.
struct Ring {
    corners: Vec<Coord<f64>>,
    tree: BoxTree,
    next: Vec<usize>,
    before: Vec<usize>,
    is_left: Vec<bool>,
    /// The one with the smallest index.
    first: usize,
}

impl Ring {
    fn of(polygon: &[Vector]) -> Self {
        let normal = area_vector(polygon);
        let dropped = normal.iamax();
        let (mut u, mut v) = ((dropped + 1) % 3, (dropped + 2) % 3);
        if normal[dropped] < 0.0 {
            std::mem::swap(&mut u, &mut v);
        }
        let count = polygon.len();
        let corners: Vec<Coord<f64>> = polygon.iter().map(|point| Coord { x: point[u], y: point[v] }).collect();
        let boxes: Vec<[Vector; 2]> = corners.iter().map(|corner| [flat(corner); 2]).collect();
        Self {
            tree: BoxTree::new(&boxes),
            corners,
            next: (0..count).map(|place| (place + 1) % count).collect(),
            before: (0..count).map(|place| (place + count - 1) % count).collect(),
            is_left: vec![true; count],
            first: 0,
        }
    }

    fn around(&self, corner: usize) -> [usize; 3] {
        [self.before[corner], corner, self.next[corner]]
    }

    fn remove(&mut self, corner: usize) {
        let [before, _, after] = self.around(corner);
        (self.next[before], self.before[after]) = (after, before);
        self.is_left[corner] = false;
        while !self.is_left[self.first] {
            self.first += 1;
        }
    }

    /// Twice the area of a triangle, positive where it runs anticlockwise.
    fn side(&self, [a, b, c]: [usize; 3]) -> f64 {
        orient2d(self.corners[a], self.corners[b], self.corners[c])
    }

    /// Whether a corner is not strictly convex.
    fn is_reflex(&self, corner: usize) -> bool {
        self.side(self.around(corner)) <= 0.0
    }

    /// A reflex corner in the triangle of a convex one. If any corner is in it, then one of these.
    fn obstacle(&self, corner: usize) -> Option<usize> {
        let [a, b, c] = self.around(corner);
        let triangle = bounds(&[a, b, c].map(|corner| flat(&self.corners[corner])));
        let is_corner = |point: usize| [a, b, c].iter().any(|&other| self.corners[other] == self.corners[point]);
        let is_inside =
            |point: usize| [[a, b, point], [b, c, point], [c, a, point]].iter().all(|&s| self.side(s) >= 0.0);
        let is_obstacle =
            |&point: &usize| self.is_left[point] && !is_corner(point) && is_inside(point) && self.is_reflex(point);
        self.tree.find_map(|near| boxes_meet(near, &triangle, 0.0), |point| Some(point).filter(is_obstacle))
    }
}

fn flat(corner: &Coord<f64>) -> Vector {
    Vector::new(corner.x, corner.y, 0.0)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::triangulate;
    use crate::geometry::{Vector, area_vector};

    /// A star whose corners are in turns at two distances from its centre.
    fn star(corners: usize) -> Vec<Vector> {
        let corner = |index: usize| {
            let angle = TAU * index as f64 / corners as f64;
            Vector::new(angle.cos(), angle.sin(), 0.3) * if index.is_multiple_of(2) { 2.0 } else { 1.0 }
        };
        (0..corners).map(corner).map(|corner| Vector::new(corner.x, corner.y, 0.3)).collect()
    }

    #[test]
    fn triangles_have_the_orientation_and_area_of_the_polygon() {
        for corners in [4, 10, 100, 20_000] {
            let polygon = star(corners);
            let triangles = triangulate(&polygon);
            assert_eq!(triangles.len(), corners - 2);
            let areas = triangles.iter().map(|triangle| area_vector(&triangle.map(|corner| polygon[corner])).z);
            assert!(areas.clone().all(|area| area > 0.0));
            let area = area_vector(&polygon).z;
            assert!((areas.sum::<f64>() - area).abs() < 1e-9 * area, "{corners}");
        }
    }

    #[test]
    fn polygons_that_cross_themselves_keep_their_boundary() {
        let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]].map(|[x, y]| Vector::new(x, y, 0.0));
        let mut edges: Vec<[usize; 2]> =
            triangulate(&bow).iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        edges.retain({
            let all = edges.clone();
            move |&[from, to]| !all.contains(&[to, from])
        });
        edges.sort_unstable();
        assert_eq!(edges, [[0, 1], [1, 2], [2, 3], [3, 0]]);
    }
}

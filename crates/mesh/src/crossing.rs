//! Triangles that cross each other.

use robust::{Coord3D, orient3d};

use crate::bvh::BoxTree;
use crate::edges::edges;
use crate::error::MeshError;
use crate::geometry::{Plane, Vector, area_vector, bounds, boxes_meet};
use crate::surface::Surface;

/// Refuses a surface whose triangles properly cross: an edge of one passes through the inside of another by more than
/// the tolerance (m), which is that of the vertices; or one is folded back onto its neighbour. Signs are exact.
///
/// # Errors
/// With the place of a crossing and the number of them.
pub fn refuse_crossings(surface: &Surface, scale: f64, tolerance: f64) -> Result<(), MeshError> {
    let corners = |triangle: &[usize; 3]| triangle.map(|corner| surface.vertices[corner]);
    let triangles: Vec<[Vector; 3]> = surface.triangles.iter().map(corners).collect();
    let boxes: Vec<[Vector; 2]> = triangles.iter().map(bounds).collect();
    let tree = BoxTree::new(&boxes);
    let mut places = folds(surface, &triangles, tolerance);
    for (index, triangle) in triangles.iter().enumerate() {
        tree.near(&boxes[index], 0.0, |other| {
            if other > index && boxes_meet(&boxes[index], &boxes[other], 0.0) {
                let crossing = pierced(triangle, &triangles[other], tolerance);
                places.extend(crossing.or_else(|| pierced(&triangles[other], triangle, tolerance)));
            }
        });
    }
    let crossing = |place: &Vector| MeshError::SelfIntersecting { place: (place / scale).into(), count: places.len() };
    places.first().map_or(Ok(()), |place| Err(crossing(place)))
}

/// Middles of the edges at which a triangle lies on its only neighbour.
fn folds(surface: &Surface, triangles: &[[Vector; 3]], tolerance: f64) -> Vec<Vector> {
    let mut folds = Vec::new();
    for ((from, to), sides) in edges(&surface.triangles) {
        let [one, other] = sides[..] else { continue };
        let [one, other] = [one.triangle, other.triangle];
        let areas = [one, other].map(|triangle| area_vector(&triangles[triangle]));
        let is_wide = [one, other].map(|triangle| crate::cell::is_wide(&triangles[triangle], 2.0 * tolerance));
        let plane = Plane::through(&triangles[one][0], areas[0].try_normalize(0.0).unwrap_or_default());
        let is_flat = triangles[other].iter().all(|corner| plane.height(corner).abs() <= tolerance);
        if is_wide == [true; 2] && is_flat && areas[0].dot(&areas[1]) < 0.0 {
            folds.push(0.5 * (surface.vertices[from] + surface.vertices[to]));
        }
    }
    folds
}

/// A point in which an edge of one triangle passes through the other.
fn pierced(triangle: &[Vector; 3], other: &[Vector; 3], tolerance: f64) -> Option<Vector> {
    (0..3).find_map(|at| passes(&other[at], &other[(at + 1) % 3], triangle, tolerance))
}

fn passes(from: &Vector, to: &Vector, triangle: &[Vector; 3], tolerance: f64) -> Option<Vector> {
    let exact = |point: &Vector| Coord3D { x: point.x, y: point.y, z: point.z };
    let side = |a: &Vector, b: &Vector, c: &Vector, d: &Vector| orient3d(exact(a), exact(b), exact(c), exact(d));
    let [a, b, c] = triangle;
    if side(a, b, c, from) * side(a, b, c, to) >= 0.0 {
        return None;
    }
    let around = [side(from, to, a, b), side(from, to, b, c), side(from, to, c, a)];
    if !(around.iter().all(|side| *side > 0.0) || around.iter().all(|side| *side < 0.0)) {
        return None;
    }
    let normal = area_vector(triangle);
    let plane = Plane::through(a, normal / normal.norm());
    let (start, end) = (plane.height(from), plane.height(to));
    let point = from + (to - from) * (start / (start - end));
    let inside = (0..3)
        .map(|at| {
            let along = (triangle[(at + 1) % 3] - triangle[at]).normalize();
            plane.normal.cross(&along).dot(&(point - triangle[at]))
        })
        .fold(f64::INFINITY, f64::min);
    (start.abs().min(end.abs()).min(inside) > tolerance).then_some(point)
}

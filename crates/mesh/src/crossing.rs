//! Triangles that cross each other.

use robust::{Coord3D, orient3d};

use crate::bvh::BoxTree;
use crate::error::MeshError;
use crate::geometry::{Plane, Vector, area_vector, bounds};

/// Refuses a surface whose triangles properly cross: an edge of one passes through the inside of another by more than
/// the tolerance (m), which is that of the vertices. Signs are exact.
///
/// # Errors
/// With a crossing and the number of them.
pub fn refuse_crossings(triangles: &[[Vector; 3]], scale: f64, tolerance: f64) -> Result<(), MeshError> {
    let boxes: Vec<[Vector; 2]> = triangles.iter().map(bounds).collect();
    let tree = BoxTree::new(&boxes);
    let mut count = 0;
    let mut place = None;
    for (index, triangle) in triangles.iter().enumerate() {
        tree.near(&boxes[index], 0.0, |other| {
            if other > index && crate::geometry::boxes_meet(&boxes[index], &boxes[other], 0.0) {
                let crossing = pierced(triangle, &triangles[other], tolerance)
                    .or_else(|| pierced(&triangles[other], triangle, tolerance));
                count += usize::from(crossing.is_some());
                place = place.or(crossing);
            }
        });
    }
    place.map_or(Ok(()), |place| Err(MeshError::SelfIntersecting { place: (place / scale).into(), count }))
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

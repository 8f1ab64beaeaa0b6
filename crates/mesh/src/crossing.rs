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
/// With the place of the first crossing.
pub fn refuse_crossings(surface: &Surface, scale: f64, tolerance: f64) -> Result<(), MeshError> {
    let corners = |triangle: &[usize; 3]| triangle.map(|corner| surface.vertices[corner]);
    let triangles: Vec<[Vector; 3]> = surface.triangles.iter().map(corners).collect();
    let planes: Vec<Plane> = triangles.iter().map(plane).collect();
    let boxes: Vec<[Vector; 2]> = triangles.iter().map(bounds).collect();
    let tree = BoxTree::new(&boxes);
    let inner = inner_sides(surface, &triangles, &planes, tolerance);
    let pierced = |one: usize, by: usize| pierced(&triangles[one], &planes[one], inner[one], &triangles[by], tolerance);
    let crossing = |one: usize| {
        let is_near = |other: &[Vector; 2]| boxes_meet(&boxes[one], other, 0.0);
        tree.find_map(is_near, |other| {
            let is_new = other > one && is_near(&boxes[other]);
            is_new.then(|| pierced(one, other).or_else(|| pierced(other, one))).flatten()
        })
    };
    let place = fold(surface, &triangles, tolerance).or_else(|| (0..triangles.len()).find_map(crossing));
    place.map_or(Ok(()), |place| Err(MeshError::SelfIntersecting { place: (place / scale).into() }))
}

fn plane(triangle: &[Vector; 3]) -> Plane {
    Plane::through(&triangle[0], area_vector(triangle).try_normalize(0.0).unwrap_or_default())
}

/// The middle of an edge at which a triangle lies on its only neighbour.
fn fold(surface: &Surface, triangles: &[[Vector; 3]], tolerance: f64) -> Option<Vector> {
    edges(&surface.triangles).iter().find_map(|((from, to), sides)| {
        let [one, other] = sides[..] else { return None };
        let [one, other] = [one.triangle, other.triangle];
        let areas = [one, other].map(|triangle| area_vector(&triangles[triangle]));
        let is_wide = [one, other].map(|triangle| crate::cell::is_wide(&triangles[triangle], 2.0 * tolerance));
        let plane = plane(&triangles[one]);
        let is_flat = triangles[other].iter().all(|corner| plane.height(corner).abs() <= tolerance);
        let is_folded = is_wide == [true; 2] && is_flat && areas[0].dot(&areas[1]) < 0.0;
        is_folded.then(|| 0.5 * (surface.vertices[from] + surface.vertices[to]))
    })
}

/// Which sides of each triangle lie within a flat face: what passes through such a side passes through the face.
fn inner_sides(surface: &Surface, triangles: &[[Vector; 3]], planes: &[Plane], tolerance: f64) -> Vec<[bool; 3]> {
    let mut inner = vec![[false; 3]; triangles.len()];
    for ((from, to), sides) in edges(&surface.triangles).iter() {
        let [one, other] = sides[..] else { continue };
        let [one, other] = [one.triangle, other.triangle];
        let is_flat = triangles[other].iter().all(|corner| planes[one].height(corner).abs() <= tolerance);
        if is_flat && planes[one].normal.dot(&planes[other].normal) > 0.0 {
            for triangle in [one, other] {
                let corners = surface.triangles[triangle];
                let is_side = |at: usize| {
                    let (start, end) = (corners[at], corners[(at + 1) % 3]);
                    (start, end) == (from, to) || (start, end) == (to, from)
                };
                (0..3).filter(|&at| is_side(at)).for_each(|at| inner[triangle][at] = true);
            }
        }
    }
    inner
}

/// A point in which an edge of another triangle passes through a triangle in a plane, or through one of its inner sides.
fn pierced(
    triangle: &[Vector; 3],
    plane: &Plane,
    inner: [bool; 3],
    by: &[Vector; 3],
    tolerance: f64,
) -> Option<Vector> {
    // Most neighbours are on one side of the plane, or touch it: they need no exact signs.
    let heights = by.map(|corner| plane.height(&corner));
    let passing = (0..3).map(|at| (at, (at + 1) % 3)).filter(|&(from, to)| {
        let [from, to] = [heights[from], heights[to]];
        from * to < 0.0 && from.abs().min(to.abs()) > tolerance
    });
    let mut points = passing.filter_map(|(from, to)| {
        let point = by[from] + (by[to] - by[from]) * (heights[from] / (heights[from] - heights[to]));
        let is_inside = depth(&point, triangle, plane, inner) > tolerance;
        (is_inside && is_crossed(&by[from], &by[to], triangle, inner)).then_some(point)
    });
    points.next()
}

/// Whether a line segment passes through a triangle or one of its inner sides, exactly.
fn is_crossed(from: &Vector, to: &Vector, [a, b, c]: &[Vector; 3], inner: [bool; 3]) -> bool {
    let exact = |point: &Vector| Coord3D { x: point.x, y: point.y, z: point.z };
    let side = |a: &Vector, b: &Vector, c: &Vector, d: &Vector| orient3d(exact(a), exact(b), exact(c), exact(d));
    side(a, b, c, from) * side(a, b, c, to) < 0.0 && {
        let around = [(a, b), (b, c), (c, a)].map(|(start, end)| side(from, to, start, end));
        let all = |sign: f64| around.iter().zip(inner).all(|(side, inner)| sign * side > 0.0 || inner && *side == 0.0);
        all(1.0) || all(-1.0)
    }
}

/// How deep a point is between the sides of a triangle (m) that are not inner ones.
fn depth(point: &Vector, triangle: &[Vector; 3], plane: &Plane, inner: [bool; 3]) -> f64 {
    let from_side = |at: usize| {
        let along = (triangle[(at + 1) % 3] - triangle[at]).normalize();
        plane.normal.cross(&along).dot(&(point - triangle[at]))
    };
    (0..3).filter(|&at| !inner[at]).map(from_side).fold(f64::INFINITY, f64::min)
}

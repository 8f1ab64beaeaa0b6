//! Triangles of simple polygons.

use robust::{Coord, orient2d};

use crate::geometry::{Vector, area_vector};

/// A polygon with more corners takes too long.
const MOST_CORNERS: usize = 2000;

/// Triangles (indices of corners) of a simple polygon that is nearly planar, with its orientation. Of a polygon that is
/// not simple, or of very many corners, the triangles still have its boundary.
pub fn triangulate(polygon: &[Vector]) -> Vec<[usize; 3]> {
    if polygon.len() > MOST_CORNERS {
        return (2..polygon.len()).map(|place| [0, place - 1, place]).collect();
    }
    let normal = area_vector(polygon);
    let dropped = normal.iamax();
    let (mut u, mut v) = ((dropped + 1) % 3, (dropped + 2) % 3);
    if normal[dropped] < 0.0 {
        std::mem::swap(&mut u, &mut v);
    }
    let flat: Vec<Coord<f64>> = polygon.iter().map(|point| Coord { x: point[u], y: point[v] }).collect();
    let mut left: Vec<usize> = (0..polygon.len()).collect();
    let mut triangles = Vec::with_capacity(polygon.len().saturating_sub(2));
    while left.len() > 3 {
        // Without an ear the polygon is degenerate or crosses itself: any triangle will do.
        let ear = (0..left.len()).find(|&place| is_ear(&flat, &left, place)).unwrap_or(0);
        triangles.push(corner(&left, ear));
        left.remove(ear);
    }
    if left.len() == 3 {
        triangles.push([left[0], left[1], left[2]]);
    }
    triangles
}

fn corner(left: &[usize], place: usize) -> [usize; 3] {
    let count = left.len();
    [left[(place + count - 1) % count], left[place], left[(place + 1) % count]]
}

fn is_ear(flat: &[Coord<f64>], left: &[usize], place: usize) -> bool {
    let [a, b, c] = corner(left, place);
    let side = |from: usize, to: usize, point: usize| orient2d(flat[from], flat[to], flat[point]);
    if side(a, b, c) <= 0.0 {
        return false;
    }
    let is_inside = |point: usize| side(a, b, point) >= 0.0 && side(b, c, point) >= 0.0 && side(c, a, point) >= 0.0;
    let is_corner = |point: usize| [a, b, c].iter().any(|&other| flat[other] == flat[point]);
    !left.iter().any(|&point| !is_corner(point) && is_inside(point))
}

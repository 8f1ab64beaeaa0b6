//! Planar regions of a triangle mesh.

use std::collections::BTreeMap;

use crate::edges::{Edges, directed, undirected};
use crate::geometry::{Plane, Vector, area_vector, mean};

/// A planar region.
#[derive(Debug, Clone)]
pub struct Face {
    /// Its plane, normal outward.
    pub plane: Plane,
    /// Its triangles (indices).
    pub triangles: Vec<usize>,
    /// Corners (indices of vertices) of its outline, anticlockwise and without those in the middle of straight lines.
    /// Empty when the outline is not a single loop.
    pub corners: Vec<usize>,
}

/// The planar regions of a mesh and the region of each triangle; slivers that belong to none have `usize::MAX`.
#[derive(Debug, Clone)]
pub struct Faces {
    pub faces: Vec<Face>,
    pub of_triangle: Vec<usize>,
}

pub const NONE: usize = usize::MAX;

impl Faces {
    /// Regions grow from their largest triangle over neighbours whose corners are within a tolerance (m) of the plane.
    pub fn of(vertices: &[Vector], triangles: &[[usize; 3]], edges: &Edges, tolerance: f64) -> Self {
        let corners = |triangle: usize| triangles[triangle].map(|corner| vertices[corner]);
        let areas: Vec<Vector> = (0..triangles.len()).map(|triangle| area_vector(&corners(triangle))).collect();
        let is_sliver: Vec<bool> = (0..triangles.len())
            .map(|triangle| {
                let [a, b, c] = corners(triangle);
                let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
                2.0 * areas[triangle].norm() <= 2.0 * tolerance * longest
            })
            .collect();
        let mut order: Vec<usize> = (0..triangles.len()).filter(|&triangle| !is_sliver[triangle]).collect();
        order.sort_by(|one, other| areas[*other].norm().total_cmp(&areas[*one].norm()));
        let mut grown = Self { faces: Vec::new(), of_triangle: vec![NONE; triangles.len()] };
        for seed in order {
            if grown.of_triangle[seed] != NONE {
                continue;
            }
            let face = grown.faces.len();
            let mut plane = Plane::through(&corners(seed)[0], areas[seed].normalize());
            let mut region = vec![seed];
            grown.of_triangle[seed] = face;
            // A larger region knows its plane better and may go on.
            loop {
                let count = region.len();
                let belongs = |triangle: usize| {
                    let (low, high) = plane.heights(&corners(triangle));
                    let is_alike = is_sliver[triangle] || areas[triangle].dot(&plane.normal) > 0.0;
                    low.abs().max(high.abs()) <= tolerance && is_alike
                };
                grown.grow(face, &mut region, triangles, edges, belongs);
                if region.len() == count {
                    break;
                }
                let area: Vector = region.iter().map(|&triangle| areas[triangle]).sum();
                let points: Vec<Vector> = region.iter().flat_map(|&triangle| corners(triangle)).collect();
                let refined = Plane::through(&mean(&points), area.normalize());
                let (low, high) = refined.heights(&points);
                if low.abs().max(high.abs()) > tolerance {
                    break;
                }
                plane = refined;
            }
            let corners = outline(&region, face, &grown.of_triangle, vertices, triangles, edges, tolerance);
            grown.faces.push(Face { plane, triangles: region, corners });
        }
        grown
    }

    fn grow(
        &mut self,
        face: usize,
        region: &mut Vec<usize>,
        triangles: &[[usize; 3]],
        edges: &Edges,
        belongs: impl Fn(usize) -> bool,
    ) {
        let mut next = 0;
        while let Some(&triangle) = region.get(next) {
            next += 1;
            for edge in directed(triangles[triangle]) {
                for side in edges.at(undirected(edge)) {
                    if self.of_triangle[side.triangle] == NONE && belongs(side.triangle) {
                        self.of_triangle[side.triangle] = face;
                        region.push(side.triangle);
                    }
                }
            }
        }
    }
}

/// Corners of a region's outline if it is one loop.
fn outline(
    region: &[usize],
    face: usize,
    of_triangle: &[usize],
    vertices: &[Vector],
    triangles: &[[usize; 3]],
    edges: &Edges,
    tolerance: f64,
) -> Vec<usize> {
    let mut next = BTreeMap::new();
    for &triangle in region {
        for edge in directed(triangles[triangle]) {
            let is_inner = |side: &crate::edges::Side| side.triangle != triangle && of_triangle[side.triangle] == face;
            if !edges.at(undirected(edge)).iter().any(is_inner) && next.insert(edge.0, edge.1).is_some() {
                return Vec::new();
            }
        }
    }
    let Some((&first, _)) = next.first_key_value() else { return Vec::new() };
    let mut outline = vec![first];
    while let Some(&end) = outline.last().and_then(|last| next.get(last)) {
        if end == first || outline.len() > next.len() {
            break;
        }
        outline.push(end);
    }
    if outline.len() != next.len() {
        return Vec::new();
    }
    // Each corner is compared with the corner kept before it, not with a neighbour on the same line.
    let is_corner = |before: usize, at: usize, after: usize| {
        let along = vertices[after] - vertices[before];
        along.cross(&(vertices[at] - vertices[before])).norm() > 2.0 * tolerance * along.norm()
    };
    let count = outline.len();
    let Some(start) =
        (0..count).find(|&at| is_corner(outline[(at + count - 1) % count], outline[at], outline[(at + 1) % count]))
    else {
        return Vec::new();
    };
    outline.rotate_left(start);
    let mut corners = vec![outline[0]];
    for at in 1..count {
        if is_corner(corners[corners.len() - 1], outline[at], outline[(at + 1) % count]) {
            corners.push(outline[at]);
        }
    }
    corners
}

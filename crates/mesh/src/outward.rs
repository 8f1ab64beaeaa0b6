//! On which side of a sound surface points are, by the normals where they are nearest to it.

use crate::edges::{directed, edges, undirected};
use crate::faces::NONE;
use crate::geometry::{Vector, area_vector};
use crate::solid::Solid;

/// Heights that are a smaller share of the distance tell no side.
const UNCERTAIN: f64 = 1e-3;

/// Outward directions of each triangle: its normal, and at each of its sides and corners the sums over the triangles that
/// meet there, which at corners count by their angles. They tell the side of all points that are nearest to these.
/// Where slivers meet, whose normals are rounding, nothing is known.
pub struct Outward {
    triangles: Vec<Directions>,
}

#[derive(Clone, Copy)]
struct Directions {
    normal: Vector,
    /// From each corner to the next one.
    sides: [Vector; 3],
    corners: [Vector; 3],
}

impl Outward {
    pub fn of(solid: &Solid) -> Self {
        let normal = |triangle: usize| {
            let is_known = solid.faces.of_triangle[triangle] != NONE;
            let area = area_vector(&solid.corners(triangle)).try_normalize(0.0).filter(|_| is_known);
            area.unwrap_or(Vector::repeat(f64::NAN))
        };
        let normals: Vec<Vector> = (0..solid.triangles.len()).map(normal).collect();
        let mut around = vec![Vector::zeros(); solid.vertices.len()];
        for (triangle, normal) in normals.iter().enumerate() {
            let corners = solid.corners(triangle);
            for at in 0..3 {
                let to = [1, 2].map(|step| corners[(at + step) % 3] - corners[at]);
                around[solid.triangles[triangle][at]] += normal * to[0].angle(&to[1]);
            }
        }
        let edges = edges(&solid.triangles);
        let directions = |(triangle, normal): (usize, &Vector)| {
            let own = solid.triangles[triangle];
            let sides =
                directed(own).map(|edge| edges.at(undirected(edge)).iter().map(|side| normals[side.triangle]).sum());
            Directions { normal: *normal, sides, corners: own.map(|corner| around[corner]) }
        };
        Self { triangles: normals.iter().enumerate().map(directions).collect() }
    }

    /// Whether a point is in front of the triangle that is nearest to it, if that is certain.
    pub fn is_beyond(&self, point: &Vector, triangle: usize, corners: &[Vector; 3]) -> Option<bool> {
        let Directions { normal, sides, corners: around } = &self.triangles[triangle];
        let outer = |at: usize| {
            let (from, along) = (corners[at], corners[(at + 1) % 3] - corners[at]);
            let is_inner = normal.cross(&along).dot(&(point - from)) > 0.0;
            (!is_inner).then(|| (at, from, along, along.dot(&(point - from)) / along.norm_squared()))
        };
        let nearest = |(at, from, along, share): (usize, Vector, Vector, f64)| match share {
            share if share <= 0.0 => (from, around[at]),
            share if share >= 1.0 => (from + along, around[(at + 1) % 3]),
            share => (from + along * share, sides[at]),
        };
        let apart = |(place, _): &(Vector, Vector)| (point - place).norm_squared();
        let outer = (0..3).filter_map(outer).map(nearest).min_by(|one, other| apart(one).total_cmp(&apart(other)));
        let (place, direction) = outer.unwrap_or((corners[0], *normal));
        let (height, away) = (direction.dot(&(point - place)), (point - place).norm() * direction.norm());
        // Inside of a triangle any height tells the side.
        let least = if outer.is_some() { UNCERTAIN * away } else { 0.0 };
        (height.abs() > least).then_some(height > 0.0)
    }
}

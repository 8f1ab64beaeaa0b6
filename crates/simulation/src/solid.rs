//! Polytopes with their facets, edges and corners, the features that can touch.

use std::collections::{BTreeMap, BTreeSet};

use collision::Polytope;
use nalgebra::{Rotation3, Vector3};

/// A convex polytope at some pose.
#[derive(Debug, Clone)]
pub struct Solid {
    /// Its corners (m).
    pub vertices: Vec<Vector3<f64>>,
    /// One per halfspace.
    pub facets: Vec<Facet>,
    /// Each once.
    pub edges: Vec<Edge>,
    /// The facets that meet in each vertex.
    pub meeting: Vec<Vec<usize>>,
    /// The next vertices along the facets that meet in each vertex, one after the other, and where those of a vertex end.
    neighbours: (Vec<usize>, Vec<usize>),
}

/// A facet `{p | normal p = offset}` with its corners, counter-clockwise as seen from outside.
#[derive(Debug, Clone)]
pub struct Facet {
    /// Unit normal, outwards.
    pub normal: Vector3<f64>,
    /// Distance of its plane from the origin along the normal (m).
    pub offset: f64,
    /// Indices of vertices.
    pub corners: Vec<usize>,
}

/// Two vertices and the two facets that meet between them.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// Indices of its vertices.
    pub ends: [usize; 2],
    /// Indices of its facets.
    pub facets: [usize; 2],
}

/// A vertex is a corner of a facet if its distance from the facet's plane is a smaller fraction of the part's size.
const CORNER_TOLERANCE: f64 = 1e-6;

impl Solid {
    /// The polytope in its own frame.
    pub fn new(shape: &Polytope) -> Self {
        let vertices: Vec<Vector3<f64>> = shape.vertices().iter().map(|vertex| Vector3::from(*vertex)).collect();
        let tolerance = CORNER_TOLERANCE * shape.size();
        let facets: Vec<Facet> = shape
            .normals()
            .iter()
            .zip(shape.offsets())
            .map(|(normal, &offset)| {
                let normal = Vector3::from(*normal);
                Facet { normal, offset, corners: corners(&vertices, &normal, offset, tolerance) }
            })
            .collect();
        let edges = edges(&facets);
        let meet = |vertex: usize| (0..facets.len()).filter(|&facet| facets[facet].corners.contains(&vertex)).collect();
        let meeting = (0..vertices.len()).map(meet).collect();
        let neighbours = neighbours(vertices.len(), &facets);
        Self { vertices, facets, edges, meeting, neighbours }
    }

    /// Largest distance of a vertex from a point (m).
    pub fn radius(&self, point: &Vector3<f64>) -> f64 {
        self.vertices.iter().map(|vertex| (vertex - point).norm_squared()).fold(0.0, f64::max).sqrt()
    }

    /// Places this polytope where `other`, rotated and then shifted, lies; both must be of the same shape.
    pub fn place(&mut self, other: &Self, rotation: &Rotation3<f64>, position: &Vector3<f64>) {
        for (placed, vertex) in self.vertices.iter_mut().zip(&other.vertices) {
            *placed = rotation * vertex + position;
        }
        for (placed, facet) in self.facets.iter_mut().zip(&other.facets) {
            placed.normal = rotation * facet.normal;
            placed.offset = facet.offset + placed.normal.dot(position);
        }
    }

    /// The lowest vertex along a direction (the support of the opposite one), and its height along the direction. Of
    /// vertices of the same height it is the first.
    pub fn lowest(&self, direction: &Vector3<f64>) -> (usize, f64) {
        let heights = self.vertices.iter().map(|vertex| direction.dot(vertex)).enumerate();
        heights.fold((0, f64::INFINITY), |lowest, next| if next.1 < lowest.1 { next } else { lowest })
    }

    /// The lowest vertex along a direction and its height, found from a vertex near it by descending along edges.
    pub fn descend(&self, vertex: usize, direction: &Vector3<f64>) -> (usize, f64) {
        let height = |vertex: usize| direction.dot(&self.vertices[vertex]);
        let mut lowest = (vertex, height(vertex));
        loop {
            let from = lowest;
            for &next in self.neighbours(from.0) {
                let height = height(next);
                if height < lowest.1 {
                    lowest = (next, height);
                }
            }
            if lowest.0 == from.0 {
                return lowest;
            }
        }
    }

    fn neighbours(&self, vertex: usize) -> &[usize] {
        let (neighbours, ends) = &self.neighbours;
        let begin = if vertex == 0 { 0 } else { ends[vertex - 1] };
        &neighbours[begin..ends[vertex]]
    }

    /// The corner of a facet that is nearest to a point.
    pub fn nearest_corner(&self, facet: usize, point: &Vector3<f64>) -> Vector3<f64> {
        let corners = self.facets[facet].corners.iter().map(|&corner| self.vertices[corner]);
        let distance = |corner: &Vector3<f64>| (corner - point).norm_squared();
        corners.min_by(|one, other| distance(one).total_cmp(&distance(other))).unwrap_or(self.vertices[0])
    }

    /// A corner of a facet, and the direction in its plane that points out of it at the side from there to the next corner, as
    /// long as the side (m).
    pub fn side(&self, facet: usize, side: usize) -> (Vector3<f64>, Vector3<f64>) {
        let Facet { normal, corners, .. } = &self.facets[facet];
        let next = if side + 1 < corners.len() { side + 1 } else { 0 };
        let corner = self.vertices[corners[side]];
        (corner, (self.vertices[corners[next]] - corner).cross(normal))
    }

    /// The facet whose normal is most opposed to `normal`, of those that meet in a vertex.
    pub fn facing_facet(&self, vertex: usize, normal: &Vector3<f64>) -> Option<usize> {
        let component = |facet: &usize| self.facets[*facet].normal.dot(normal);
        self.meeting[vertex].iter().copied().min_by(|one, other| component(one).total_cmp(&component(other)))
    }

    /// End points of an edge.
    pub fn segment(&self, edge: &Edge) -> [Vector3<f64>; 2] {
        edge.ends.map(|end| self.vertices[end])
    }
}

/// The vertices in a plane, counter-clockwise about its normal.
fn corners(vertices: &[Vector3<f64>], normal: &Vector3<f64>, offset: f64, tolerance: f64) -> Vec<usize> {
    let mut corners: Vec<usize> =
        (0..vertices.len()).filter(|&index| (normal.dot(&vertices[index]) - offset).abs() <= tolerance).collect();
    let center = corners.iter().map(|&index| vertices[index]).sum::<Vector3<f64>>() / corners.len() as f64;
    let Some(&corner) = corners.first() else { return corners };
    let first = vertices[corner] - center;
    let second = normal.cross(&first);
    let angle = |&index: &usize| {
        let arm = vertices[index] - center;
        arm.dot(&second).atan2(arm.dot(&first))
    };
    corners.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
    corners
}

/// The vertices before and after each of some vertices on the facets that meet in it, each once, one vertex after the other,
/// and where those of a vertex end.
fn neighbours(count: usize, facets: &[Facet]) -> (Vec<usize>, Vec<usize>) {
    let mut pairs = BTreeSet::new();
    for Facet { corners, .. } in facets {
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            pairs.extend([(from, to), (to, from)]);
        }
    }
    let pairs: Vec<(usize, usize)> = pairs.into_iter().collect();
    let ends = (0..count).map(|vertex| pairs.partition_point(|pair| pair.0 <= vertex)).collect();
    (pairs.into_iter().map(|(_, to)| to).collect(), ends)
}

/// The edges in which two facets meet.
fn edges(facets: &[Facet]) -> Vec<Edge> {
    let mut sides: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
    for (index, facet) in facets.iter().enumerate() {
        for (&from, &to) in facet.corners.iter().zip(facet.corners.iter().cycle().skip(1)) {
            sides.entry([from.min(to), from.max(to)]).or_default().push(index);
        }
    }
    let shared = |(ends, facets): ([usize; 2], Vec<usize>)| Some(Edge { ends, facets: facets.try_into().ok()? });
    sides.into_iter().filter_map(shared).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn euler_counts_vertices_edges_and_facets() {
        let roof =
            [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.1, 0.1, 0.0], [0.0, 0.05, 0.1], [0.1, 0.05, 0.1]];
        for shape in [Polytope::from_box([0.1, 0.2, 0.3]).unwrap(), Polytope::from_vertices(&roof).unwrap()] {
            let solid = Solid::new(&shape);
            assert_eq!(solid.vertices.len() + solid.facets.len(), solid.edges.len() + 2);
            for facet in &solid.facets {
                let [a, b, c] = [0, 1, 2].map(|corner| solid.vertices[facet.corners[corner]]);
                assert!((b - a).cross(&(c - b)).dot(&facet.normal) > 0.0, "counter-clockwise");
            }
        }
    }
}

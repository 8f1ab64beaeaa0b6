//! Contact points of the pairs that can touch within a step.

use nalgebra::{Isometry3, Vector3};
use task::ContactPair;

use crate::axis::{Axis, Feature, separate};
use crate::solid::Solid;

/// A point where a pair touches or may touch within the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Index of the pair.
    pub pair: usize,
    /// Position (m, world frame).
    pub point: Vector3<f64>,
    /// Unit vector from the environment to the body (world frame).
    pub normal: Vector3<f64>,
    /// Width of the gap (m), negative where the parts overlap.
    pub gap: f64,
}

/// Finds the contacts of a body as it moves. A pair is examined only when the body may have crossed the gap that the
/// pair had when it was last examined.
#[derive(Debug, Clone)]
pub struct ContactFinder {
    pairs: Vec<Pair>,
    last: Isometry3<f64>,
    /// Contacts at the last pose.
    pub contacts: Vec<Contact>,
    polygon: Vec<Vector3<f64>>,
    clipped: Vec<Vector3<f64>>,
}

#[derive(Debug, Clone)]
struct Pair {
    body: Solid,
    radius: f64,
    placed: Solid,
    environment: Solid,
    /// Lower bound on the gap (m).
    clearance: f64,
}

impl ContactFinder {
    /// For the pairs of a task.
    pub fn new(pairs: &[ContactPair]) -> Self {
        let pair = |pair: &ContactPair| {
            let body = Solid::new(pair.shapes.body());
            let environment = Solid::new(pair.shapes.environment());
            Pair { radius: body.radius(), placed: body.clone(), body, environment, clearance: f64::NEG_INFINITY }
        };
        Self {
            pairs: pairs.iter().map(pair).collect(),
            last: Isometry3::identity(),
            contacts: Vec::new(),
            polygon: Vec::new(),
            clipped: Vec::new(),
        }
    }

    /// Largest distance of a point of the body from its origin (m).
    pub fn radius(&self) -> f64 {
        self.pairs.iter().map(|pair| pair.radius).fold(0.0, f64::max)
    }

    /// Finds all contacts with gaps up to `reach` (m) at a pose. Returns the smallest separation (m) of the pairs that
    /// were examined.
    pub fn find(&mut self, pose: &Isometry3<f64>, reach: f64) -> f64 {
        let shift = (pose.translation.vector - self.last.translation.vector).norm();
        let turn = pose.rotation.angle_to(&self.last.rotation);
        self.last = *pose;
        self.contacts.clear();
        let rotation = pose.rotation.to_rotation_matrix();
        let mut smallest = f64::INFINITY;
        for index in 0..self.pairs.len() {
            let pair = &mut self.pairs[index];
            pair.clearance -= shift + pair.radius * turn;
            if pair.clearance > reach {
                continue;
            }
            pair.placed.place(&pair.body, &rotation, &pose.translation.vector);
            let axis = separate(&pair.placed, &pair.environment, reach);
            pair.clearance = axis.separation;
            smallest = smallest.min(axis.separation);
            if axis.separation <= reach {
                self.add(index, &axis, reach);
            }
        }
        smallest
    }

    fn add(&mut self, index: usize, axis: &Axis, reach: f64) {
        let Self { pairs, contacts, polygon, clipped, .. } = self;
        let (body, environment) = (&pairs[index].placed, &pairs[index].environment);
        let before = contacts.len();
        let mut found = |point: Vector3<f64>, gap: f64| {
            if gap <= reach {
                contacts.push(Contact { pair: index, point, normal: axis.normal, gap });
            }
        };
        match axis.feature {
            Feature::EnvironmentFacet(facet) => facet_contacts(environment, facet, body, (polygon, clipped), found),
            Feature::BodyFacet(facet) => facet_contacts(body, facet, environment, (polygon, clipped), found),
            Feature::Edges(first, second) => {
                let first = body.segment(&body.edges[first]);
                let second = environment.segment(&environment.edges[second]);
                edge_point(&first, &second).into_iter().for_each(|point| found(point, axis.separation));
            }
        }
        if contacts.len() == before && axis.separation < 0.0 {
            // The touching features overlap without facing each other: the deepest vertex is the contact.
            let deepest = body.vertices[body.lowest(&axis.normal).0];
            contacts.push(Contact { pair: index, point: deepest, normal: axis.normal, gap: axis.separation });
        }
    }
}

/// Clips the facing facet of `other` to the prism over a facet of `solid`, and reports the remaining corners and their
/// gaps.
fn facet_contacts(
    solid: &Solid,
    facet: usize,
    other: &Solid,
    (polygon, clipped): (&mut Vec<Vector3<f64>>, &mut Vec<Vector3<f64>>),
    mut found: impl FnMut(Vector3<f64>, f64),
) {
    let facet = &solid.facets[facet];
    polygon.clear();
    polygon.extend(facing_facet(other, &facet.normal));
    for (&from, &to) in facet.corners.iter().zip(facet.corners.iter().cycle().skip(1)) {
        let corner = solid.vertices[from];
        let outward = (solid.vertices[to] - corner).cross(&facet.normal);
        clip(polygon, clipped, |point| outward.dot(&(point - corner)));
        std::mem::swap(polygon, clipped);
    }
    for point in polygon.iter() {
        found(*point, facet.normal.dot(point) - facet.offset);
    }
}

/// Corners of the facet whose normal is most opposed to `normal`, of the facets that meet in the lowest vertex.
fn facing_facet<'solid>(solid: &'solid Solid, normal: &Vector3<f64>) -> impl Iterator<Item = Vector3<f64>> + 'solid {
    let (lowest, _) = solid.lowest(normal);
    let touching = solid.facets.iter().filter(|facet| facet.corners.contains(&lowest));
    let facing = touching.min_by(|one, other| one.normal.dot(normal).total_cmp(&other.normal.dot(normal)));
    facing.into_iter().flat_map(|facet| facet.corners.iter().map(|&corner| solid.vertices[corner]))
}

/// The region of a polygon where `height` is not positive (Sutherland and Hodgman).
fn clip(polygon: &[Vector3<f64>], kept: &mut Vec<Vector3<f64>>, height: impl Fn(&Vector3<f64>) -> f64) {
    kept.clear();
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (before, after) = (height(from), height(to));
        if before <= 0.0 {
            kept.push(*from);
        }
        if (before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0) {
            kept.push(from + (to - from) * (before / (before - after)));
        }
    }
}

/// The point of the first edge that is closest to the second edge; `None` when the closest points of the two lines lie
/// beyond the ends of an edge.
fn edge_point(first: &[Vector3<f64>; 2], second: &[Vector3<f64>; 2]) -> Option<Vector3<f64>> {
    let (along, across) = (first[1] - first[0], second[1] - second[0]);
    let between = first[0] - second[0];
    let (a, b, c) = (along.norm_squared(), along.dot(&across), across.norm_squared());
    let (d, e) = (along.dot(&between), across.dot(&between));
    let determinant = a * c - b * b;
    let (s, t) = ((b * e - c * d) / determinant, (a * e - b * d) / determinant);
    let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    inside.then(|| first[0] + along * s)
}

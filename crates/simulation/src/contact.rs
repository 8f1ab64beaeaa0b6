//! Contact points of the pairs that can touch within a step.

use collision::Polytope;
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use task::ContactPair;

use crate::axis::{Axis, Feature, PREFERENCE};
use crate::candidates::{Candidates, StillEdge, Travel, edge_point, known_edges};
use crate::patch::Patch;
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
    /// Width of the gap (m), negative where the parts penetrate.
    pub gap: f64,
}

/// The shapes of a task's pairs.
#[derive(Debug, Clone)]
pub struct Shapes {
    /// The different parts of the body, in its frame.
    bodies: Vec<Solid>,
    pairs: Vec<PairShapes>,
}

#[derive(Debug, Clone)]
struct PairShapes {
    /// Index of the part of the body.
    body: usize,
    /// Largest distance of a point of that part from the body's origin (m).
    radius: f64,
    environment: Solid,
    /// Edges of the environment.
    edges: Vec<StillEdge>,
}

impl Shapes {
    /// For the pairs of a task.
    pub fn new(pairs: &[ContactPair]) -> Self {
        let mut parts: Vec<&Polytope> = Vec::new();
        let mut shapes = Self { bodies: Vec::new(), pairs: Vec::new() };
        for ContactPair { shapes: pair, .. } in pairs {
            let known = parts.iter().position(|&part| part == pair.body());
            let body = known.unwrap_or(parts.len());
            if known.is_none() {
                parts.push(pair.body());
                shapes.bodies.push(Solid::new(pair.body()));
            }
            let radius = shapes.bodies[body].radius(&Vector3::zeros());
            let environment = Solid::new(pair.environment());
            let edges = StillEdge::of(&environment);
            shapes.pairs.push(PairShapes { body, radius, environment, edges });
        }
        shapes
    }
}

/// Finds the contacts of a body as it moves. A pair is examined only when the body may have crossed the gap that the
/// pair had when it was last examined: between the planes that were the farthest apart then.
#[derive(Debug, Clone)]
pub struct ContactFinder<'shapes> {
    shapes: &'shapes Shapes,
    /// Radius of edges (m).
    edge_radius: f64,
    /// Of every pair.
    gaps: Vec<Gap>,
    /// The last edges of every pair that were better than the best facet.
    edges: Vec<Option<(usize, usize)>>,
    travel: Travel,
    /// The last pose, the reach (m) there, and the smallest separation (m) of the pairs that were examined.
    last: Isometry3<f64>,
    reach: f64,
    smallest: f64,
    /// Contacts at the last pose.
    pub contacts: Vec<Contact>,
    memory: Memory,
}

/// What makes the search faster, but no contact depends on. It is large: a copy begins without it.
#[derive(Debug, Default)]
struct Memory {
    bodies: Vec<PlacedBody>,
    /// Of every pair.
    candidates: Vec<Candidates>,
    patch: Patch,
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Memory {
    /// Is filled before its first use.
    fn fill(&mut self, shapes: &Shapes) {
        if self.candidates.len() < shapes.pairs.len() {
            let placed = |solid: &Solid| PlacedBody { solid: solid.clone(), is_current: false };
            self.bodies = shapes.bodies.iter().map(placed).collect();
            self.candidates = vec![Candidates::default(); shapes.pairs.len()];
        }
    }
}

/// A part of the body, placed when a pair is examined.
#[derive(Debug, Clone)]
struct PlacedBody {
    solid: Solid,
    is_current: bool,
}

/// The gap between two parallel planes, of which one moves with the body.
#[derive(Debug, Clone, Copy)]
struct Gap {
    /// Unit normal from the environment to the body (world frame).
    normal: Vector3<f64>,
    /// Its width (m), less what the body's origin adds, plus what rotation has taken.
    offset: f64,
    /// Largest distance of a point of the part of the body from the body's origin (m).
    radius: f64,
}

impl Gap {
    /// Not known yet.
    fn unknown(radius: f64) -> Self {
        Self { normal: Vector3::zeros(), offset: f64::NEG_INFINITY, radius }
    }

    /// Along an axis, for a body at a position (m).
    fn new(axis: &Axis, radius: f64, position: &Vector3<f64>, travel: Travel) -> Self {
        let offset = axis.separation - axis.normal.dot(position) + radius * travel.rotation;
        Self { normal: axis.normal, offset, radius }
    }

    /// Lower bound on its width (m) after the body has moved.
    fn least(&self, position: &Vector3<f64>, travel: Travel) -> f64 {
        self.offset + self.normal.dot(position) - self.radius * travel.rotation
    }
}

impl<'shapes> ContactFinder<'shapes> {
    /// For the shapes of a task with edges of a radius (m).
    pub fn new(shapes: &'shapes Shapes, edge_radius: f64) -> Self {
        Self {
            gaps: shapes.pairs.iter().map(|pair| Gap::unknown(pair.radius)).collect(),
            edges: vec![None; shapes.pairs.len()],
            travel: Travel::default(),
            shapes,
            edge_radius,
            last: Isometry3::identity(),
            reach: f64::NEG_INFINITY,
            smallest: f64::INFINITY,
            contacts: Vec::new(),
            memory: Memory::default(),
        }
    }

    /// Largest distance of a point of the body from its origin (m).
    pub fn radius(&self) -> f64 {
        self.shapes.pairs.iter().map(|pair| pair.radius).fold(0.0, f64::max)
    }

    /// Finds all contacts with gaps up to `reach` (m) at a pose; those that were found at the same pose with a longer
    /// reach stay. Returns the smallest separation (m) of the pairs that were examined.
    pub fn find(&mut self, pose: &Isometry3<f64>, reach: f64) -> f64 {
        if *pose == self.last && reach <= self.reach {
            return self.smallest;
        }
        let position = &pose.translation.vector;
        self.travel.shift += (position - self.last.translation.vector).norm();
        self.travel.rotation += largest_rotation(&pose.rotation, &self.last.rotation);
        (self.last, self.reach) = (*pose, reach);
        self.contacts.clear();
        let shapes = self.shapes;
        self.memory.fill(shapes);
        self.memory.bodies.iter_mut().for_each(|body| body.is_current = false);
        let mut smallest = f64::INFINITY;
        for index in 0..self.gaps.len() {
            let gap = self.gaps[index];
            if gap.least(position, self.travel) > reach + ROUNDING {
                continue;
            }
            let body = shapes.pairs[index].body;
            let placed = &mut self.memory.bodies[body];
            if !placed.is_current {
                placed.solid.place(&shapes.bodies[body], &pose.rotation.to_rotation_matrix(), position);
                placed.is_current = true;
            }
            let before = self.contacts.len();
            let axis = self.examine(index, position, reach);
            self.gaps[index] = Gap::new(&axis, gap.radius, position, self.travel);
            // Without a contact, rounded edges would penetrate.
            if axis.separation >= 0.0 || self.contacts.len() > before {
                smallest = smallest.min(axis.separation);
            }
        }
        self.smallest = smallest;
        smallest
    }

    /// The part of a shift (m, world frame) that no contact at the last pose blocks.
    pub fn unblocked(&self, way: &Vector3<f64>) -> Vector3<f64> {
        let slide = |way: Vector3<f64>, contact: &Contact| way - contact.normal * contact.normal.dot(&way).min(0.0);
        // What one contact allows, another may block.
        (0..SLIDES).fold(*way, |way, _| self.contacts.iter().fold(way, slide))
    }

    /// Adds the contacts of a pair whose body is placed. Returns the pair's best axis.
    fn examine(&mut self, index: usize, position: &Vector3<f64>, reach: f64) -> Axis {
        let PairShapes { body, environment, edges, .. } = &self.shapes.pairs[index];
        let Self { contacts, edge_radius, travel, edges: known, memory, .. } = self;
        let Memory { bodies, candidates, patch } = memory;
        let (body, candidates, known) = (&bodies[*body].solid, &mut candidates[index], &mut known[index]);
        let mut axis = candidates.best_facet(body, position, *travel, environment, reach);
        if axis.separation > reach {
            return axis;
        }
        patch.clear();
        let mut better = known.and_then(|known| known_edges(known, body, edges, &axis));
        if better.is_none() {
            match axis.feature {
                Feature::EnvironmentFacet { facet, vertex } => {
                    let (sides, margin) = candidates.environment_sides();
                    patch.fill(environment, facet, body, vertex, sides, margin);
                }
                Feature::BodyFacet { facet, vertex } => {
                    let (sides, margin) = candidates.body_sides();
                    patch.fill(body, facet, environment, vertex, sides, margin);
                }
                Feature::Edges(..) => {}
            }
            // No axis separates the parts by more than the distance of two of their points.
            let is_best = patch.distance() < axis.separation + PREFERENCE - ROUNDING;
            better = if is_best { None } else { candidates.better_edges(body, environment, edges, &axis) };
            if let Some(Axis { feature: Feature::Edges(edge, opposite), .. }) = better {
                *known = Some((edge, opposite));
            }
        }
        let is_round = *edge_radius > 0.0 && better.is_none() && axis.separation > -*edge_radius;
        if is_round && patch.is_narrower(*edge_radius, &axis.normal) {
            return axis;
        }
        if let Some(better) = better {
            axis = better;
            patch.clear();
            if let Feature::Edges(edge, opposite) = axis.feature {
                let point = edge_point(&body.segment(&body.edges[edge]), &edges[opposite].segment);
                patch.points.extend(point.map(|point| (point, axis.separation)));
            }
        }
        let before = contacts.len();
        let near = patch.points.iter().filter(|(_, gap)| *gap <= reach);
        contacts.extend(near.map(|&(point, gap)| Contact { pair: index, point, normal: axis.normal, gap }));
        if contacts.len() == before && axis.separation < 0.0 {
            // The touching features penetrate without facing each other: the deepest vertex is the contact.
            let deepest = body.vertices[body.lowest(&axis.normal).0];
            contacts.push(Contact { pair: index, point: deepest, normal: axis.normal, gap: axis.separation });
        }
        axis
    }
}

/// Rounding errors of gaps are smaller (m).
const ROUNDING: f64 = 1e-12;

/// Number of passes over all contacts that project a shift.
const SLIDES: usize = 3;

/// Upper bound on the distance by which a rotation from one orientation to the other moves a point at a distance of
/// one; it is tight for small rotations.
fn largest_rotation(one: &UnitQuaternion<f64>, other: &UnitQuaternion<f64>) -> f64 {
    let (one, other) = (one.as_vector(), other.as_vector());
    2.0 * (one - other).norm_squared().min((one + other).norm_squared()).sqrt()
}

#[cfg(test)]
mod tests;

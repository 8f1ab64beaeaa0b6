//! The best separating axis of two convex parts: the direction of the widest gap, or of the smallest overlap.
//!
//! Two polytopes are disjoint if and only if a separating plane is parallel to a facet of one of them or to an edge of
//! each. The zero level of the separation is that of the growth distance (Eq. sdfopt), found without smoothing and
//! together with the features that touch. Few pairs of edges matter: only those whose arcs cross on the Gauss map form
//! a facet of the Minkowski difference.

use nalgebra::Vector3;

use crate::solid::{Edge, Solid};

/// The best separating direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Width of the gap along the normal (m), negative where the parts overlap.
    pub separation: f64,
    /// Unit vector from the environment to the body.
    pub normal: Vector3<f64>,
    /// The features that define the direction.
    pub feature: Feature,
}

/// The features that touch, or would touch first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// A facet of the environment.
    EnvironmentFacet(usize),
    /// A facet of the body.
    BodyFacet(usize),
    /// An edge of the body and an edge of the environment.
    Edges(usize, usize),
}

/// By how much (m) the separation of another feature must exceed that of a facet of the environment. It keeps rounding
/// from replacing the facet of a flat contact, and thereby from changing the number of contact points.
const PREFERENCE: f64 = 1e-6;

/// The best axis. Edges are not examined when a facet alone separates the parts by more than `reach` (m).
pub fn separate(body: &Solid, environment: &Solid, reach: f64) -> Axis {
    let (facet, separation) = best_facet(environment, body);
    let normal = environment.facets[facet].normal;
    let mut best = Axis { separation, normal, feature: Feature::EnvironmentFacet(facet) };
    let (facet, separation) = best_facet(body, environment);
    if separation > best.separation + PREFERENCE {
        best = Axis { separation, normal: -body.facets[facet].normal, feature: Feature::BodyFacet(facet) };
    }
    if best.separation > reach {
        return best;
    }
    match best_edges(body, environment) {
        Some(edges) if edges.separation > best.separation + PREFERENCE => edges,
        _ => best,
    }
}

/// The facet of `first` with the widest gap to `second`, and the width of that gap (m).
fn best_facet(first: &Solid, second: &Solid) -> (usize, f64) {
    let mut best = (0, f64::NEG_INFINITY);
    for (index, facet) in first.facets.iter().enumerate() {
        let separation = second.lowest(&facet.normal).1 - facet.offset;
        if separation > best.1 {
            best = (index, separation);
        }
    }
    best
}

fn best_edges(body: &Solid, environment: &Solid) -> Option<Axis> {
    let mut best: Option<Axis> = None;
    let arcs: Vec<Arc> = environment.edges.iter().map(|edge| Arc::new(environment, edge).reversed()).collect();
    for (body_index, body_edge) in body.edges.iter().enumerate() {
        let body_arc = Arc::new(body, body_edge);
        for (index, arc) in arcs.iter().enumerate() {
            if !body_arc.crosses(arc) {
                continue;
            }
            let Some(normal) = common_normal(&body_arc, arc) else { continue };
            let gap = body.vertices[body_edge.ends[0]] - environment.vertices[environment.edges[index].ends[0]];
            let separation = normal.dot(&gap);
            if best.is_none_or(|best| separation > best.separation) {
                best = Some(Axis { separation, normal, feature: Feature::Edges(body_index, index) });
            }
        }
    }
    best
}

/// The outward normals of an edge: an arc on the Gauss map from one facet's normal to the other's.
struct Arc {
    ends: [Vector3<f64>; 2],
    /// Normal of the plane of the arc, along the edge.
    pole: Vector3<f64>,
}

impl Arc {
    fn new(solid: &Solid, edge: &Edge) -> Self {
        let ends = edge.facets.map(|facet| solid.facets[facet].normal);
        Self { ends, pole: ends[0].cross(&ends[1]) }
    }

    fn reversed(self) -> Self {
        Self { ends: self.ends.map(|normal| -normal), pole: self.pole }
    }

    fn crosses(&self, other: &Self) -> bool {
        let [a, b] = other.ends.map(|end| end.dot(&self.pole));
        if a * b >= 0.0 {
            return false;
        }
        let [c, d] = self.ends.map(|end| end.dot(&other.pole));
        // The last product distinguishes the crossing from its antipode.
        c * d < 0.0 && a * d > 0.0
    }
}

/// Unit vector normal to both edges and against the body's outward normals; `None` for parallel edges.
fn common_normal(body: &Arc, environment: &Arc) -> Option<Vector3<f64>> {
    const PARALLEL: f64 = 1e-6;
    let cross = body.pole.cross(&environment.pole);
    let length = cross.norm();
    if length < PARALLEL * body.pole.norm() * environment.pole.norm() {
        return None;
    }
    let normal = cross / length;
    let outward = normal.dot(&(body.ends[0] + body.ends[1]));
    Some(if outward > 0.0 { -normal } else { normal })
}

#[cfg(test)]
mod tests {
    use collision::{Pair, Polytope};
    use proptest::prelude::*;

    use super::*;

    fn shape() -> impl Strategy<Value = Polytope> {
        let vertex = proptest::array::uniform3(-0.1..0.1_f64);
        let hull = |vertices: Vec<[f64; 3]>| Polytope::from_vertices(&vertices).ok();
        proptest::collection::vec(vertex, 6..20).prop_filter_map("flat", hull)
    }

    proptest! {
        /// The planner's distance is an independent oracle: its sign is that of the separation.
        #[test]
        fn separation_has_the_sign_of_the_exact_distance(
            (body, environment) in (shape(), shape()),
            shift in proptest::array::uniform3(-0.2..0.2_f64),
            orientation in proptest::array::uniform4(0.1..1.0_f64),
        ) {
            let placed = body.placed(shift, orientation);
            let axis = separate(&Solid::new(&placed), &Solid::new(&environment), f64::INFINITY);
            let distance = Pair::new(placed, environment).exact_distance(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
            prop_assume!(distance.abs() > 2.0 * PREFERENCE);
            prop_assert!(axis.separation * distance > 0.0, "{} and {}", axis.separation, distance);
            prop_assert!((axis.normal.norm() - 1.0).abs() < 1e-12);
        }
    }
}

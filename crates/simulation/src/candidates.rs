//! The few features of a pair that can define its best axis while the body moves little.
//!
//! Most facets and edges of two parts are far from touching, and remain so for a while. When the body moves by no more
//! than a skin, no separation changes by more than that: a feature that is worse than the best one by twice the skin
//! cannot become the best. These are left out; the others give exactly the same result. The vertex that is nearest to a
//! facet is found by descending along edges from its last place.

use nalgebra::Vector3;

use crate::arc::Arc;
use crate::axis::{Axis, Feature, PREFERENCE};
use crate::patch::Sides;
use crate::solid::{Edge, Solid};

/// Candidates of a pair, valid until the body has moved by more than the skin.
#[derive(Debug, Clone, Default)]
pub struct Candidates {
    environment_facets: Facets,
    body_facets: Facets,
    /// Edges of the body and of the environment, found when facets alone do not show the distance of the parts.
    edges: Vec<(usize, usize)>,
    edges_are_found: bool,
    /// Of facets of the environment, and of the body.
    sides: [Sides; 2],
    /// How far the body may move from where the candidates were found (m).
    skin: f64,
    /// How far it had moved then.
    found: Travel,
    /// Until then no vertex of either part is further from the body's origin (m).
    lever: f64,
}

/// How far a body has moved so far: lengths of all shifts (m) and angles of all rotations (rad).
#[derive(Debug, Clone, Copy, Default)]
pub struct Travel {
    pub shift: f64,
    pub rotation: f64,
}

/// An edge of the environment, and its inward normals.
#[derive(Debug, Clone, Copy)]
pub struct StillEdge {
    pub segment: [Vector3<f64>; 2],
    reversed: Arc,
}

impl StillEdge {
    /// The edges of a part of the environment, in their order.
    pub fn of(environment: &Solid) -> Vec<Self> {
        let still =
            |edge: &Edge| Self { segment: environment.segment(edge), reversed: Arc::new(environment, edge).reversed() };
        environment.edges.iter().map(still).collect()
    }
}

/// Facets of one solid, each with the vertex of another one that was the nearest when it was last measured.
#[derive(Debug, Clone, Default)]
struct Facets {
    facets: Vec<(usize, usize)>,
    /// The same of all facets that were measured, with their separations (m).
    measured: Vec<(usize, usize, f64)>,
}

/// Rounding errors of separations are smaller (m), and so are those of products on the Gauss map.
const ROUNDING: f64 = 1e-9;
/// Smallest number of steps for which the candidates last, if only the reach of a step limits them. More candidates are
/// found less often, and are more to examine.
const STEPS: f64 = 16.0;

impl Candidates {
    /// The best axis of all facets, for a body whose origin is at `position`. A step moves the body by about `reach`
    /// (m).
    pub fn best_facet(
        &mut self,
        body: &Solid,
        position: &Vector3<f64>,
        travel: Travel,
        environment: &Solid,
        reach: f64,
    ) -> Axis {
        let moved = travel.shift - self.found.shift + self.lever * (travel.rotation - self.found.rotation);
        // A pose that is not finite makes it NaN.
        let are_valid = moved < self.skin;
        if !are_valid {
            self.skin = STEPS * reach;
            self.found = travel;
            self.lever = body.radius(position).max(environment.radius(position)) + self.skin;
            self.find_facets(body, environment);
            self.edges_are_found = false;
            self.sides.iter_mut().for_each(Sides::clear);
        }
        // At least one facet was chosen.
        let of_environment = self.environment_facets.better(f64::NEG_INFINITY, environment, body);
        let least = of_environment.map_or(f64::NEG_INFINITY, |best| best.2 + PREFERENCE);
        if let Some((facet, vertex, separation)) = self.body_facets.better(least, body, environment) {
            let normal = -body.facets[facet].normal;
            return Axis { separation, normal, feature: Feature::BodyFacet { facet, vertex } };
        }
        let (facet, vertex, separation) = of_environment.unwrap_or((0, 0, f64::NEG_INFINITY));
        let normal = environment.facets[facet].normal;
        Axis { separation, normal, feature: Feature::EnvironmentFacet { facet, vertex } }
    }

    /// The best axis of all pairs of edges, if it is better than that of the best facet, which has just been found.
    pub fn better_edges(
        &mut self,
        body: &Solid,
        environment: &Solid,
        edges: &[StillEdge],
        facet: &Axis,
    ) -> Option<Axis> {
        if !self.edges_are_found {
            self.find_edges(body, edges, &touching(body, environment, facet), facet.separation);
            self.edges_are_found = true;
        }
        best_of(&self.edges, body, edges, facet.separation + PREFERENCE)
    }

    /// Sides of facets of the environment, and how far points move at most between two poses for which they are valid (m).
    pub fn environment_sides(&mut self) -> (&mut Sides, f64) {
        (&mut self.sides[0], 2.0 * self.skin + ROUNDING)
    }

    /// The same of the body's facets.
    pub fn body_sides(&mut self) -> (&mut Sides, f64) {
        (&mut self.sides[1], 2.0 * self.skin + ROUNDING)
    }

    fn find_facets(&mut self, body: &Solid, environment: &Solid) {
        let margin = 2.0 * self.skin + ROUNDING + PREFERENCE;
        let best = self.environment_facets.measure(environment, body, f64::NEG_INFINITY, margin);
        let best = self.body_facets.measure(body, environment, best, margin);
        self.environment_facets.choose(best - margin);
        self.body_facets.choose(best - margin);
    }

    /// Finds the pairs of edges that can become better than the best facet, whose separation is `facet` (m). Of each part a
    /// vertex is given that is near to the other one.
    fn find_edges(&mut self, body: &Solid, environment: &[StillEdge], near: &[Vector3<f64>; 2], facet: f64) {
        let rotation = self.skin / self.lever + ROUNDING;
        // Components along an arc are bounded by those along its ends only if they are negative.
        let least = (facet - 2.0 * self.skin - ROUNDING).min(0.0);
        // A separation along a common normal is at most the component of a gap between any two vertices along a normal
        // of either arc. The arc of the body rotates with it: components of the gap, which is no longer than two
        // levers, change by two more skins.
        let (is_still_below, is_body_below) = (
            |still: &StillEdge, end: &Vector3<f64>| still.reversed.is_below(&(still.segment[0] - end), least),
            |arc: &Arc, gap: &Vector3<f64>| arc.is_below(gap, least - 2.0 * self.skin),
        );
        let [of_body, of_environment] = near;
        let reachable = |&edge: &usize| !is_still_below(&environment[edge], of_body);
        let opposites: Vec<usize> = (0..environment.len()).filter(reachable).collect();
        self.edges.clear();
        for (index, edge) in body.edges.iter().enumerate() {
            let (arc, end) = (Arc::new(body, edge), body.vertices[edge.ends[0]]);
            if is_body_below(&arc, &(of_environment - end)) {
                continue;
            }
            for &opposite in &opposites {
                let still = &environment[opposite];
                if arc.may_cross(&still.reversed, rotation)
                    && !is_still_below(still, &end)
                    && !is_body_below(&arc, &(still.segment[0] - end))
                {
                    self.edges.push((index, opposite));
                }
            }
        }
    }
}

/// The axis of two edges, if it is better than that of the best facet and better than all others.
pub fn known_edges(
    (edge, opposite): (usize, usize),
    body: &Solid,
    environment: &[StillEdge],
    facet: &Axis,
) -> Option<Axis> {
    // No axis separates the parts by more than the distance of two of their points.
    let least = (facet.separation + PREFERENCE).max(-0.25 * PREFERENCE);
    let axis = best_of(&[(edge, opposite)], body, environment, least)?;
    edge_point(&body.segment(&body.edges[edge]), &environment[opposite].segment).map(|_| axis)
}

/// The vertices of body and environment that define the axis of a facet.
fn touching(body: &Solid, environment: &Solid, facet: &Axis) -> [Vector3<f64>; 2] {
    match facet.feature {
        Feature::EnvironmentFacet { facet, vertex } => {
            let vertex = body.vertices[vertex];
            [vertex, environment.nearest_corner(facet, &vertex)]
        }
        Feature::BodyFacet { facet, vertex } => {
            let vertex = environment.vertices[vertex];
            [body.nearest_corner(facet, &vertex), vertex]
        }
        Feature::Edges(edge, opposite) => {
            [body.vertices[body.edges[edge].ends[0]], environment.vertices[environment.edges[opposite].ends[0]]]
        }
    }
}

/// The best axis of some pairs of edges, if its separation is more than `least` (m).
fn best_of(pairs: &[(usize, usize)], body: &Solid, environment: &[StillEdge], mut least: f64) -> Option<Axis> {
    let mut best = None;
    for pairs in pairs.chunk_by(|one, other| one.0 == other.0) {
        let edge = &body.edges[pairs[0].0];
        let (arc, end) = (Arc::new(body, edge), body.vertices[edge.ends[0]]);
        for &(index, opposite) in pairs {
            let StillEdge { segment, reversed } = &environment[opposite];
            if arc.crosses(reversed)
                && let Some((separation, normal)) = arc.separation(reversed, &(end - segment[0]), least)
            {
                least = separation;
                best = Some(Axis { separation, normal, feature: Feature::Edges(index, opposite) });
            }
        }
    }
    best
}

/// The point of the first edge that is closest to the second edge; `None` when the closest points of the two lines lie
/// beyond the ends of an edge.
pub fn edge_point(first: &[Vector3<f64>; 2], second: &[Vector3<f64>; 2]) -> Option<Vector3<f64>> {
    let (along, across) = (first[1] - first[0], second[1] - second[0]);
    let between = first[0] - second[0];
    let (a, b, c) = (along.norm_squared(), along.dot(&across), across.norm_squared());
    let (d, e) = (along.dot(&between), across.dot(&between));
    let determinant = a * c - b * b;
    let (s, t) = ((b * e - c * d) / determinant, (a * e - b * d) / determinant);
    let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    inside.then(|| first[0] + along * s)
}

impl Facets {
    /// Measures the separations of the facets of `solid` from `other` that may be at most `margin` (m) less than the largest
    /// and than `best` (m). Returns the larger of both.
    fn measure(&mut self, solid: &Solid, other: &Solid, mut best: f64, margin: f64) -> f64 {
        let mut nearest = 0;
        self.measured.clear();
        for (index, facet) in solid.facets.iter().enumerate() {
            // No vertex is lower than the lowest.
            if facet.normal.dot(&other.vertices[nearest]) - facet.offset < best - margin {
                continue;
            }
            let height;
            (nearest, height) = other.descend(nearest, &facet.normal);
            let separation = height - facet.offset;
            best = best.max(separation);
            self.measured.push((index, nearest, separation));
        }
        best
    }

    /// Chooses the measured facets whose separation is at least `least` (m).
    fn choose(&mut self, least: f64) {
        self.facets.clear();
        // The widest gaps come first, so that the others need not be measured again.
        self.measured.sort_by(|one, other| other.2.total_cmp(&one.2));
        let wide = self.measured.iter().take_while(|measured| measured.2 >= least);
        self.facets.extend(wide.map(|&(facet, nearest, _)| (facet, nearest)));
    }

    /// The facet of `solid` with the widest gap to `other`, the vertex that is nearest to it, and the width of the gap
    /// (m), if that is more than `least`.
    fn better(&mut self, least: f64, solid: &Solid, other: &Solid) -> Option<(usize, usize, f64)> {
        let mut best = (None, least);
        for (index, nearest) in &mut self.facets {
            let facet = &solid.facets[*index];
            // No vertex is lower than the lowest.
            if facet.normal.dot(&other.vertices[*nearest]) - facet.offset <= best.1 {
                continue;
            }
            let height;
            (*nearest, height) = other.descend(*nearest, &facet.normal);
            if height - facet.offset > best.1 {
                best = (Some((*index, *nearest)), height - facet.offset);
            }
        }
        best.0.map(|(facet, nearest)| (facet, nearest, best.1))
    }
}

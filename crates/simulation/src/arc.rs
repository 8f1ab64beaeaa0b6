//! Edges on the Gauss map.

use nalgebra::Vector3;

use crate::solid::{Edge, Solid};

/// The outward normals of an edge: an arc on the Gauss map from one facet's normal to the other's.
#[derive(Debug, Clone, Copy)]
pub struct Arc {
    ends: [Vector3<f64>; 2],
    /// Normal of the plane of the arc, along the edge.
    pole: Vector3<f64>,
}

impl Arc {
    pub fn new(solid: &Solid, edge: &Edge) -> Self {
        let ends = edge.facets.map(|facet| solid.facets[facet].normal);
        Self { ends, pole: ends[0].cross(&ends[1]) }
    }

    /// The arc of the opposite normals.
    pub fn reversed(self) -> Self {
        Self { ends: self.ends.map(|normal| -normal), pole: self.pole }
    }

    /// Whether two arcs have a normal in common.
    pub fn crosses(&self, other: &Self) -> bool {
        let [a, b] = other.ends.map(|end| end.dot(&self.pole));
        if a * b >= 0.0 {
            return false;
        }
        let [c, d] = self.ends.map(|end| end.dot(&other.pole));
        // The last product distinguishes the crossing from its antipode.
        c * d < 0.0 && a * d > 0.0
    }

    /// Whether two arcs may cross after a rotation of one of them by at most `rotation` (rad) about any axis.
    pub fn may_cross(&self, other: &Self, rotation: f64) -> bool {
        // Every product below changes by at most the rotation, as no pole is longer than one.
        let opposite = |one: f64, other: f64| one.min(other) <= rotation && one.max(other) >= -rotation;
        let [a, b] = other.ends.map(|end| end.dot(&self.pole));
        if !opposite(a, b) {
            return false;
        }
        let [c, d] = self.ends.map(|end| end.dot(&other.pole));
        opposite(c, d) && opposite(a, -d)
    }

    /// Whether the components of a vector along all normals of the arc are less than `height`, which is not positive.
    pub fn is_below(&self, vector: &Vector3<f64>, height: f64) -> bool {
        // Normals are sums of multiples of both ends, whose factors add up to at least one.
        self.ends.iter().all(|end| end.dot(vector) < height)
    }

    /// The component of `gap` along the unit vector that is normal to both edges and against this one's normals, and
    /// that vector; `None` unless the component exceeds `least`, and for parallel edges.
    pub fn separation(&self, other: &Self, gap: &Vector3<f64>, least: f64) -> Option<(f64, Vector3<f64>)> {
        const PARALLEL: f64 = 1e-6;
        let cross = self.pole.cross(&other.pole);
        let length = cross.norm_squared();
        let is_outward = cross.dot(&(self.ends[0] + self.ends[1])) > 0.0;
        let component = if is_outward { -cross.dot(gap) } else { cross.dot(gap) };
        // Most pairs of edges end here, without a root.
        if component * component.abs() <= least * least.abs() * length
            || length < PARALLEL * PARALLEL * self.pole.norm_squared() * other.pole.norm_squared()
        {
            return None;
        }
        let scale = if is_outward { -1.0 } else { 1.0 } / length.sqrt();
        Some((component * scale.abs(), cross * scale))
    }
}

//! The best separating axis of two convex parts: the direction of the widest gap, or of the smallest penetration.
//!
//! Two polytopes are disjoint if and only if a separating plane is parallel to a facet of one of them or to an edge of
//! each. The zero level of the separation is that of the growth distance (Eq. sdfopt), found without smoothing and
//! together with the features that touch. Few pairs of edges matter: only those whose arcs cross on the Gauss map form
//! a facet of the Minkowski difference.

use nalgebra::Vector3;

/// The best separating direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Width of the gap along the normal (m), negative where the parts penetrate.
    pub separation: f64,
    /// Unit vector from the environment to the body.
    pub normal: Vector3<f64>,
    /// The features that define the direction.
    pub feature: Feature,
}

/// The features that touch, or would touch first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// A facet of the environment and the nearest vertex of the body.
    EnvironmentFacet { facet: usize, vertex: usize },
    /// A facet of the body and the nearest vertex of the environment.
    BodyFacet { facet: usize, vertex: usize },
    /// An edge of the body and an edge of the environment.
    Edges(usize, usize),
}

/// How much (m) larger than that of a facet of the environment the separation of another feature must be to replace it.
/// Without this, rounding could replace the facet of a flat contact and change the number of contact points.
pub const PREFERENCE: f64 = 1e-6;

//! What callers are told about curved surfaces.

use std::f64::consts::{PI, TAU};

use crate::curved::Curved;

/// Cylinder or cone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurvedKind {
    /// One radius.
    Cylinder,
    /// A radius that changes along the axis.
    Cone,
}

/// A curved surface of a mesh, as large as it is in the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvedSurface {
    /// Cylinder or cone.
    pub kind: CurvedKind,
    /// Whether the material is inside of it: a peg, not a hole.
    pub is_convex: bool,
    /// Points of the axis (m) where the surface begins and ends.
    pub axis: [[f64; 3]; 2],
    /// Radii there (m). Vertices of the mesh lie at them.
    pub radii: [f64; 2],
    /// Extent around the axis (rad), 2 pi for a full turn.
    pub angle: f64,
    /// Facets of the mesh, and the distance between them and the surface (m).
    pub mesh_facets: usize,
    /// Largest distance between the facets of the mesh and the surface (m).
    pub mesh_error: f64,
}

impl CurvedSurface {
    pub(crate) fn of(curved: &Curved) -> Self {
        let cone = &curved.cone;
        let radii = curved.heights.map(|height| cone.radius_at(height).max(0.0));
        Self {
            kind: if cone.slope == 0.0 { CurvedKind::Cylinder } else { CurvedKind::Cone },
            is_convex: curved.is_convex,
            axis: curved.heights.map(|height| (cone.origin + cone.axis * height).into()),
            radii,
            angle: curved.extent.min(TAU),
            mesh_facets: (curved.extent / curved.widest()).round() as usize,
            mesh_error: curved.radius() * (1.0 - (0.5 * curved.widest()).cos()) + curved.deviation,
        }
    }

    /// Largest distance (m) between the surface and `facets` facets per full turn: of those around a convex surface the
    /// corners, of those inside of a concave one the middles. A concave surface is inscribed in the mesh where its own
    /// facets do not have corners at the same angles, which adds at most the error of the mesh.
    pub fn error(&self, facets: usize) -> f64 {
        let radius = self.radii[0].max(self.radii[1]);
        let cosine = (PI / facets as f64).cos();
        if self.is_convex { radius * (1.0 / cosine - 1.0) } else { radius * (1.0 - cosine) }
    }
}

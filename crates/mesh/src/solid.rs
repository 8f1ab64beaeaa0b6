//! A closed surface with what is known about it.

use crate::curved::{Curved, Mesh, recognise};
use crate::curved_surface::CurvedSurface;
use crate::decide::decide;
use crate::edges::edges;
use crate::error::MeshError;
use crate::faces::Faces;
use crate::geometry::{Vector, bounds};
use crate::mass::MassProperties;
use crate::read::TriangleMesh;
use crate::repair::{SAME, repair};
use crate::surface::{Repair, Surface};

/// A closed, consistently oriented mesh with its planar faces and curved surfaces.
#[derive(Debug, Clone)]
pub struct Solid {
    pub(crate) vertices: Vec<Vector>,
    pub(crate) triangles: Vec<[usize; 3]>,
    pub(crate) faces: Faces,
    pub(crate) curved: Vec<Curved>,
    /// Distance (m) within which points of the file are on the same plane.
    pub(crate) tolerance: f64,
    /// Why its surface is not that of a solid everywhere: only winding numbers say what is inside.
    pub(crate) undecided: Option<MeshError>,
    repairs: Vec<Repair>,
    mass_properties: MassProperties,
}

impl Solid {
    /// Repairs a mesh where it is certain how and recognises its surfaces.
    ///
    /// # Errors
    /// When the surface does not separate inside from outside.
    pub fn of(mesh: &TriangleMesh) -> Result<Self, MeshError> {
        let Closed { surface, undecided, tolerance } = close(mesh)?;
        let corners: Vec<[Vector; 3]> =
            surface.triangles.iter().map(|triangle| triangle.map(|corner| surface.vertices[corner])).collect();
        let edges = edges(&surface.triangles);
        let faces = Faces::of(&surface.vertices, &surface.triangles, &edges, tolerance);
        let mesh = Mesh {
            vertices: &surface.vertices,
            triangles: &surface.triangles,
            edges: &edges,
            faces: &faces,
            tolerance,
        };
        let curved = if undecided.is_none() { recognise(&mesh) } else { Vec::new() };
        let mass_properties =
            if undecided.is_none() { MassProperties::of(&corners) } else { MassProperties::along_lines(&corners) };
        if !(mass_properties.volume > 0.0) {
            return Err(undecided.unwrap_or(MeshError::Flat));
        }
        Ok(Self {
            faces,
            curved,
            tolerance,
            undecided,
            repairs: surface.repairs,
            mass_properties,
            vertices: surface.vertices,
            triangles: surface.triangles,
        })
    }

    /// What was changed in the mesh.
    pub fn repairs(&self) -> &[Repair] {
        &self.repairs
    }

    /// Number of triangles after repairs.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Number of planar regions, those of curved surfaces included.
    pub fn face_count(&self) -> usize {
        self.faces.faces.len()
    }

    /// Cylinders and cones, full turns first.
    pub fn curved_surfaces(&self) -> Vec<CurvedSurface> {
        self.curved.iter().map(CurvedSurface::of).collect()
    }

    /// Volume, centre and inertia of the mesh.
    pub fn mass_properties(&self) -> &MassProperties {
        &self.mass_properties
    }

    /// Corners of its triangles (m).
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        self.vertices.iter().map(|vertex| (*vertex).into())
    }

    /// Whether its surface crosses itself or has cracks, so that [`Cover::of`](crate::Cover::of) refuses it and only
    /// [`Cover::touching`](crate::Cover::touching) covers it.
    pub fn is_rough(&self) -> bool {
        self.undecided.is_some()
    }

    /// Its triangles (m), anticlockwise seen from outside.
    pub fn corner_triangles(&self) -> impl Iterator<Item = [[f64; 3]; 3]> {
        (0..self.triangles.len()).map(|triangle| self.corners(triangle).map(Into::into))
    }

    /// Lower and upper corner (m).
    pub fn bounding_box(&self) -> [[f64; 3]; 2] {
        self.bounds().map(Into::into)
    }

    pub(crate) fn bounds(&self) -> [Vector; 2] {
        bounds(self.triangles.iter().flatten().map(|&corner| &self.vertices[corner]))
    }

    pub(crate) fn corners(&self, triangle: usize) -> [Vector; 3] {
        self.triangles[triangle].map(|corner| self.vertices[corner])
    }
}

/// The surface of a mesh between inside and outside.
struct Closed {
    surface: Surface,
    /// Why only winding numbers tell both apart.
    undecided: Option<MeshError>,
    /// Distance (m) within which points are the same.
    tolerance: f64,
}

/// Closes a mesh with the precision that its digits show, or else with the finest with which it is closed: vertices may be
/// less precise than they are written. Where it never is, winding numbers decide, with the coarsest that they can.
fn close(mesh: &TriangleMesh) -> Result<Closed, MeshError> {
    let roundings = mesh.roundings();
    let with = |rounding: f64| TriangleMesh { rounding, ..mesh.clone() };
    let closed = |surface: Surface, rounding: f64, undecided| Closed { surface, undecided, tolerance: SAME * rounding };
    let reason = match repair(mesh) {
        Err(reason) if reason.is_undecided() => reason,
        surface => return Ok(closed(surface?, mesh.rounding, None)),
    };
    if matches!(reason, MeshError::Open { .. }) {
        let coarser = roundings.iter().skip(1);
        let mut repaired = coarser.filter_map(|&rounding| Some((repair(&with(rounding)).ok()?, rounding)));
        if let Some((mut surface, rounding)) = repaired.next() {
            surface.repairs.push(Repair::Welded { distance: SAME * rounding });
            return Ok(closed(surface, rounding, None));
        }
    }
    // Walls that cross or touch each other do so within what CAD takes as equal, not within the last digit.
    let mut decided = roundings
        .into_iter()
        .rev()
        .filter_map(|rounding| Some((decide(&with(rounding), reason.clone()).ok()?, rounding)));
    let (surface, rounding) = decided.next().ok_or_else(|| reason.clone())?;
    Ok(closed(surface, rounding, Some(reason)))
}

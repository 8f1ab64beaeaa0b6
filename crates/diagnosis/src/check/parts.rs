//! Parts, and the convex parts of meshes.

use mesh::{CurvedKind, Deviation};
use nalgebra::Point3;
use scene::{MeshPart, Part};
use serde::Serialize;

/// A convex part.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PartReport {
    /// Its name.
    pub name: String,
    /// Longest edge of its bounding box.
    pub size_m: f64,
    /// Smallest distance between a facet and the corner farthest from it.
    pub thickness_m: f64,
    /// Its volume.
    pub volume_m3: f64,
    /// Its halfspaces.
    pub facets: usize,
    /// Its corners.
    pub corners: usize,
}

/// Edges (m) of the box along the axes around some parts and whole meshes, of which only pieces may be among the parts.
pub fn edges(parts: &[Part], meshes: &[MeshPart]) -> [f64; 3] {
    let corners = meshes.iter().flat_map(|mesh| {
        let bounds = mesh.solid.bounding_box();
        let corner =
            move |index: usize| Point3::new(bounds[index & 1][0], bounds[index >> 1 & 1][1], bounds[index >> 2 & 1][2]);
        (0..8).map(move |index| mesh.placement * corner(index))
    });
    let vertices = parts.iter().flat_map(|part| part.shape.vertices()).map(|vertex| Point3::from(*vertex));
    let points: Vec<Point3<f64>> = vertices.chain(corners).collect();
    std::array::from_fn(|axis| {
        let coordinates = points.iter().map(|point| point[axis]);
        let (low, high) = coordinates
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    })
}

impl From<&Part> for PartReport {
    fn from(part: &Part) -> Self {
        Self {
            name: part.name.clone(),
            size_m: part.shape.size(),
            thickness_m: part.shape.thickness(),
            volume_m3: part.shape.volume(),
            facets: part.shape.normals().len(),
            corners: part.shape.vertices().len(),
        }
    }
}

/// A part whose shape is a mesh, or one of the shapes of a link, and how well its convex parts stand for it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeshReport {
    /// Name of the part.
    pub name: String,
    /// The file.
    pub file: String,
    /// Name of the link's shape; null for a mesh.
    pub shape: Option<String>,
    /// Its triangles, after repairs.
    pub triangles: usize,
    /// Repairs, in words.
    pub repairs: Vec<String>,
    /// Volume of the whole mesh.
    pub volume_m3: f64,
    /// Its round surfaces.
    pub round_surfaces: Vec<RoundSurface>,
    /// Length by which its surfaces were moved into the material.
    pub clearance_m: f64,
    /// Convex parts; none where other shapes of the link contain it.
    pub pieces: usize,
    /// Convex parts that were thinner than the precision of the file.
    pub pieces_dropped: usize,
    /// How far convex parts reach beyond facets that were left out to have fewer.
    pub growth_m: f64,
    /// Comparison of the convex parts with the mesh, made independently.
    pub deviation: DeviationReport,
}

/// A cylinder or cone of a mesh, or a sector of one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundSurface {
    /// `cylinder` or `cone`.
    pub kind: &'static str,
    /// Whether the material is inside of it.
    pub is_convex: bool,
    /// Radii at both ends.
    pub radii_m: [f64; 2],
    /// Points of the axis at both ends, in the part's own frame.
    pub axis_m: [[f64; 3]; 2],
    /// Extent around the axis.
    pub angle_rad: f64,
    /// Facets per full turn of its prism.
    pub facets_per_turn: usize,
    /// Largest distance of these from it.
    pub error_m: f64,
    /// Largest distance of the mesh from it.
    pub mesh_error_m: f64,
}

/// Distances and volumes between a mesh and its convex parts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DeviationReport {
    /// Largest distance of the mesh from the surface of the convex parts.
    pub mesh_to_parts_m: f64,
    /// Largest distance of that from the mesh.
    pub parts_to_mesh_m: f64,
    /// Largest distance of the mesh from convex parts that do not contain it.
    pub uncovered_m: f64,
    /// Volume of the mesh outside of the convex parts.
    pub missing_m3: f64,
    /// Volume of the convex parts outside of the mesh.
    pub outside_m3: f64,
    /// Standard deviation of both volumes, which are estimated at points.
    pub volume_error_m3: f64,
}

impl From<&MeshPart> for MeshReport {
    fn from(part: &MeshPart) -> Self {
        let (solid, cover) = (&part.solid, &part.cover);
        let round = |&(surface, facets): &(mesh::CurvedSurface, usize)| RoundSurface {
            kind: match surface.kind {
                CurvedKind::Cylinder => "cylinder",
                CurvedKind::Cone => "cone",
            },
            is_convex: surface.is_convex,
            radii_m: surface.radii,
            axis_m: surface.axis,
            angle_rad: surface.angle,
            facets_per_turn: facets,
            error_m: surface.error(facets),
            mesh_error_m: surface.mesh_error,
        };
        Self {
            name: part.name.clone(),
            file: part.file.display().to_string(),
            shape: part.shape.clone(),
            triangles: solid.triangle_count(),
            repairs: solid.repairs().iter().map(ToString::to_string).collect(),
            volume_m3: solid.mass_properties().volume,
            round_surfaces: cover.curved_surfaces().iter().map(round).collect(),
            clearance_m: part.settings.clearance,
            pieces: part.parts.len(),
            pieces_dropped: cover.vanished(),
            growth_m: cover.growth(),
            deviation: Deviation::measure(solid, cover).into(),
        }
    }
}

impl From<Deviation> for DeviationReport {
    fn from(deviation: Deviation) -> Self {
        Self {
            mesh_to_parts_m: deviation.mesh_to_cover,
            parts_to_mesh_m: deviation.cover_to_mesh,
            uncovered_m: deviation.uncovered,
            missing_m3: deviation.missing_volume,
            outside_m3: deviation.outside_volume,
            volume_error_m3: deviation.volume_error,
        }
    }
}

//! Parts whose shape is a triangle mesh: convex parts that cover it.

use std::fmt::Display;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use collision::Polytope;
use mesh::{Cover, CoverSettings, MeshError, Place, Solid, TriangleMesh};
use nalgebra::Isometry3;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::keys::UNITS;
use crate::motion_region::MotionRegion;
use crate::part::{Part, corners_of};
use crate::table::Table;

/// Keys that only a mesh has.
pub const MESH_KEYS: [&str; 4] = ["unit", "facets", "clearance", "density"];

/// The units of lengths (m), in the order of their names.
pub const SCALES: [f64; 4] = [1.0, 0.01, 0.001, 0.0254];
const _: () = assert!(SCALES.len() == UNITS.len());

/// Share of the error of curved surfaces by which pieces may grow so that they have fewer facets.
const COARSENING: f64 = 0.5;

/// A part whose shape is a mesh, and the convex parts that stand for it.
#[derive(Debug, Clone)]
pub struct MeshPart {
    /// Name in the scene. The convex parts are called `name.1`, `name.2` and so on; one alone has the name itself.
    pub name: String,
    /// The mesh file.
    pub file: PathBuf,
    /// Its surface, in the part's own frame (m).
    pub solid: Arc<Solid>,
    /// The convex pieces that cover it, likewise.
    pub cover: Arc<Cover>,
    /// How they were made.
    pub settings: CoverSettings,
    /// From its own frame to its parent's.
    pub placement: Isometry3<f64>,
    /// Indices of its convex parts among those of its parent.
    pub parts: Range<usize>,
}

/// A mesh as the scene gives it.
pub struct GivenMesh<'text> {
    /// Place of the file's name.
    entry: Entry<'text>,
    file: PathBuf,
    pub solid: Arc<Solid>,
    pub facets: Option<usize>,
    pub clearance: f64,
    /// kg/m^3
    pub density: Option<f64>,
}

impl<'text> GivenMesh<'text> {
    /// Reads the keys of a mesh and its file, whose name is relative to the scene.
    pub fn read(table: &Table<'text>) -> Result<Self, SceneError> {
        let entry = table.require("mesh")?;
        let name = entry.text()?;
        if name.is_empty() {
            return Err(entry.refuse(format!("{} is empty", entry.path())));
        }
        let Some(unit) = table.find("unit") else {
            return Err(entry.refuse(format!("a mesh needs its `unit`: one of \"{}\"", UNITS.join("\", \""))));
        };
        let scale = SCALES[unit.choice()?];
        let facets = table.find("facets").map(|facets| facets.integer()).transpose()?;
        let clearance = table.find("clearance").map_or(Ok(0.0), |clearance| clearance.length())?;
        let density = table.find("density").map(|density| density.number()).transpose()?;
        let scene = entry.source().file;
        let file = scene.parent().unwrap_or(scene).join(name);
        let solid = TriangleMesh::read(&file, scale).and_then(|mesh| Solid::of(&mesh));
        let solid = Arc::new(solid.map_err(|error| refused(&entry, &file, error))?);
        let facets = facets.map(|facets| facets as usize);
        Ok(Self { entry, file, solid, facets, clearance, density })
    }

    /// Corners of its bounding box (m).
    pub fn corners(&self) -> [[f64; 3]; 8] {
        corners_of(&self.solid.bounding_box())
    }

    /// Longest edge of its bounding box (m).
    pub fn size(&self) -> f64 {
        let [low, high] = self.solid.bounding_box();
        (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max)
    }

    /// An error about the mesh.
    pub fn refuse(&self, message: &str) -> SceneError {
        refused(&self.entry, &self.file, message)
    }

    /// The convex parts that stand for the mesh: curved surfaces with `facets` per full turn unless the scene says how
    /// many; where there is a region of motion, only what has surface there.
    pub fn cover(
        &self,
        name: &str,
        placement: &Isometry3<f64>,
        facets: usize,
        region: Option<&MotionRegion>,
    ) -> Result<(MeshPart, Vec<Part>), SceneError> {
        let facets = self.facets.unwrap_or(facets);
        let errors = self.solid.curved_surfaces().into_iter().map(|surface| surface.error(facets));
        let settings = CoverSettings {
            facets,
            tolerance: COARSENING * errors.reduce(f64::min).unwrap_or(0.0),
            crop: region.map(|region| in_frame(&region.extent, placement)),
            clearance: self.clearance,
        };
        let places = region.iter().flat_map(|region| region.places.iter().flatten());
        let places: Vec<Place> = places.map(|place| place_in_frame(place, placement)).collect();
        let cover = match Cover::facing(&self.solid, &settings, &places) {
            // No motion comes near: all of it is there, and its pairs are left out.
            Err(MeshError::NothingLeft) if region.is_some() => {
                Cover::of(&self.solid, &CoverSettings { crop: None, ..settings })
            }
            cover => cover,
        };
        let cover = cover.map_err(|error| refused(&self.entry, &self.file, error))?;
        let count = cover.pieces().len();
        let part = |(number, piece): (usize, &mesh::Piece)| {
            let shape = Polytope::from_halfspaces(&piece.normals, &piece.offsets)
                .map_err(|error| self.refuse(&format!("piece {number}: {error}")))?;
            let name = if count == 1 { name.to_owned() } else { format!("{name}.{number}") };
            let rotation = placement.rotation.quaternion();
            let orientation = [rotation.w, rotation.i, rotation.j, rotation.k];
            Ok(Part { name, shape: shape.placed(placement.translation.vector.into(), orientation) })
        };
        let parts: Vec<Part> = (1..).zip(cover.pieces()).map(part).collect::<Result<_, SceneError>>()?;
        let mesh = MeshPart {
            name: name.to_owned(),
            file: self.file.clone(),
            solid: Arc::clone(&self.solid),
            cover: Arc::new(cover),
            settings,
            placement: *placement,
            parts: 0..count,
        };
        Ok((mesh, parts))
    }
}

fn refused(entry: &Entry, file: &Path, problem: impl Display) -> SceneError {
    entry.refuse(format!("mesh {}: {problem}", file.display()))
}

/// The smallest box along the axes of a frame that holds a box of its parent.
fn in_frame(parent: &[[f64; 3]; 2], placement: &Isometry3<f64>) -> [[f64; 3]; 2] {
    let mut frame = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for corner in corners_of(parent) {
        let point = placement.inverse_transform_point(&corner.into());
        for axis in 0..3 {
            frame[0][axis] = frame[0][axis].min(point[axis]);
            frame[1][axis] = frame[1][axis].max(point[axis]);
        }
    }
    frame
}

/// The halfspaces of a place of the parent.
fn place_in_frame(place: &Polytope, placement: &Isometry3<f64>) -> Place {
    let back = placement.inverse();
    let rotation = back.rotation.quaternion();
    let place = place.placed(back.translation.vector.into(), [rotation.w, rotation.i, rotation.j, rotation.k]);
    place.normals().iter().copied().zip(place.offsets().iter().copied()).collect()
}

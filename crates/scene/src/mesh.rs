//! Parts whose shape is a triangle mesh or one of a link: convex parts that cover it.

use std::fmt::Display;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use collision::Polytope;
use mesh::{Budget, Cover, CoverSettings, MeshError, Passage, Place, Solid};
use nalgebra::Isometry3;

use crate::boxes::{corners_of, in_frame};
use crate::entry::Entry;
use crate::error::SceneError;
use crate::facets::ChosenFacets;
use crate::keys::{SCALES, UNITS};
use crate::known_meshes::KnownMeshes;
use crate::motion_region::MotionRegion;
use crate::table::Table;

/// Share of the error of curved surfaces by which pieces may grow so that they have fewer facets.
const COARSENING: f64 = 0.5;

/// A part whose shape is a mesh or one of a link's, and the convex parts that stand for it.
#[derive(Debug, Clone)]
pub struct MeshPart {
    /// Name in the scene. The convex parts are called `name.1`, `name.2` and so on; one alone has the name itself. All
    /// shapes of a link have the same name, and their convex parts go on counting.
    pub name: String,
    /// The file of the mesh or link.
    pub file: PathBuf,
    /// Name of the shape among those of its link; none for a mesh.
    pub shape: Option<String>,
    /// Its surface, in the part's own frame (m).
    pub solid: Arc<Solid>,
    /// The convex pieces that cover it.
    pub cover: Arc<Cover>,
    /// How they were made.
    pub settings: CoverSettings,
    /// From its own frame to its parent's.
    pub placement: Isometry3<f64>,
    /// Indices of its convex parts among those of its parent; none where other shapes of its link contain it.
    pub parts: Range<usize>,
}

/// A mesh or a shape of a link as the scene gives it.
pub struct GivenMesh<'text> {
    /// Place of the file's name.
    pub entry: Entry<'text>,
    pub file: PathBuf,
    /// Name of a link's shape.
    pub shape: Option<String>,
    pub solid: Arc<Solid>,
    pub making: Making,
}

/// Settings of the scene for a mesh: its convex parts and its material.
#[derive(Debug, Clone, Copy)]
pub struct Making {
    pub facets: Option<usize>,
    /// m
    pub clearance: f64,
    /// kg/m^3
    pub density: Option<f64>,
}

impl Making {
    /// Reads it from the table of a part.
    pub fn read(table: &Table) -> Result<Self, SceneError> {
        let facets = table.find("facets").map(|facets| facets.integer()).transpose()?;
        let clearance = table.find("clearance").map_or(Ok(0.0), |clearance| clearance.length())?;
        let density = table.find("density").map(|density| density.number()).transpose()?;
        Ok(Self { facets: facets.map(|facets| facets as usize), clearance, density })
    }
}

impl<'text> GivenMesh<'text> {
    /// Reads the keys of a mesh and its file, whose name is relative to the scene, unless it is known.
    pub fn read(table: &Table<'text>, known: &KnownMeshes) -> Result<Self, SceneError> {
        let entry = table.require("mesh")?;
        let file = entry.file()?;
        let Some(unit) = table.find("unit") else {
            return Err(entry.refuse(format!("a mesh needs its `unit`: one of \"{}\"", UNITS.join("\", \""))));
        };
        let scale = SCALES[unit.choice()?];
        let making = Making::read(table)?;
        let solid = known.solid(&file, scale);
        let solid = solid.map_err(|error| entry.refuse(format!("mesh {}: {error}", file.display())))?;
        Ok(Self { entry, file, shape: None, solid, making })
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
    pub fn refuse(&self, problem: impl Display) -> SceneError {
        let file = self.file.display();
        self.entry.refuse(match &self.shape {
            None => format!("mesh {file}: {problem}"),
            Some(shape) => format!("model {file}, shape `{shape}`: {problem}"),
        })
    }

    /// The convex parts of the mesh, with the facets that the scene gives or else chosen ones; with a region of motion,
    /// only pieces with surface in it.
    pub fn cover(
        &self,
        name: &str,
        placement: &Isometry3<f64>,
        chosen: ChosenFacets,
        region: Option<&MotionRegion>,
        most_cells: usize,
    ) -> Result<(MeshPart, Vec<Polytope>), SceneError> {
        let ChosenFacets { facets, error } =
            self.making.facets.map_or(chosen, |facets| ChosenFacets { facets, error: 0.0 });
        let errors = self.solid.curved_surfaces().into_iter().map(|surface| surface.error(facets));
        let settings = CoverSettings {
            facets,
            error,
            tolerance: COARSENING * errors.reduce(f64::min).unwrap_or(0.0),
            crop: region.map(|region| in_frame(&region.extent, placement)),
            clearance: self.making.clearance,
            most_cells,
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
        self.made(name, placement, settings, cover.map_err(|error| self.refuse(error))?)
    }

    /// The convex parts that stand for the mesh where the other side passes it.
    pub fn touching_cover(
        &self,
        name: &str,
        placement: &Isometry3<f64>,
        passages: &[Passage],
        budget: Budget,
    ) -> Result<(MeshPart, Vec<Polytope>), SceneError> {
        let cover = Cover::touching(&self.solid, passages, budget).map_err(|error| self.refuse(error))?;
        self.made(name, placement, CoverSettings::default(), cover)
    }

    /// A part of a cover.
    fn made(
        &self,
        name: &str,
        placement: &Isometry3<f64>,
        settings: CoverSettings,
        cover: Cover,
    ) -> Result<(MeshPart, Vec<Polytope>), SceneError> {
        let rotation = placement.rotation.quaternion();
        let orientation = [rotation.w, rotation.i, rotation.j, rotation.k];
        let piece = |(number, piece): (usize, &mesh::Piece)| {
            // Halfspaces of a thin piece may be too alike to tell its corners, which are known.
            let shape = Polytope::from_halfspaces(&piece.normals, &piece.offsets)
                .or_else(|_| Polytope::from_vertices(&piece.vertices))
                .map_err(|error| self.refuse(format!("piece {number}: {error}")))?;
            Ok(shape.placed(placement.translation.vector.into(), orientation))
        };
        let pieces: Vec<Polytope> = (1..).zip(cover.pieces()).map(piece).collect::<Result<_, SceneError>>()?;
        let mesh = MeshPart {
            name: name.to_owned(),
            file: self.file.clone(),
            shape: self.shape.clone(),
            solid: Arc::clone(&self.solid),
            cover: Arc::new(cover),
            settings,
            placement: *placement,
            parts: 0..pieces.len(),
        };
        Ok((mesh, pieces))
    }
}

/// The halfspaces of a place of the parent.
fn place_in_frame(place: &Polytope, placement: &Isometry3<f64>) -> Place {
    let back = placement.inverse();
    let rotation = back.rotation.quaternion();
    let place = place.placed(back.translation.vector.into(), [rotation.w, rotation.i, rotation.j, rotation.k]);
    place.normals().iter().copied().zip(place.offsets().iter().copied()).collect()
}

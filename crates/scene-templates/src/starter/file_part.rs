//! Parts of files that a scene is made of.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use mesh::Solid;
use scene::{KnownMeshes, SCALES, SceneError, UNITS, USUAL_SIZES, triangles_of_link};

use crate::draft::DraftShape;
use crate::starter::BoundingBox;
use crate::starter::relative::relative_path;

/// Extensions of model files.
const MODELS: [&str; 3] = ["sdf", "urdf", "xml"];

/// Body and environment, in the frame of both files.
#[derive(Debug, Clone)]
pub struct PartPair {
    /// The body.
    pub body: FilePart,
    /// The environment.
    pub environment: FilePart,
}

impl PartPair {
    /// The meshes that were read.
    pub fn meshes(&self) -> KnownMeshes {
        let mut known = KnownMeshes::default();
        for part in [&self.body, &self.environment] {
            if let Kind::Mesh(unit, solid) = &part.kind {
                known.add(&part.file, SCALES[*unit], Arc::clone(solid));
            }
        }
        known
    }
}

/// A part that is a file.
#[derive(Debug, Clone)]
pub struct FilePart {
    file: PathBuf,
    kind: Kind,
    triangles: Vec<[[f64; 3]; 3]>,
}

#[derive(Debug, Clone)]
enum Kind {
    /// A mesh in one of the units, and its surface.
    Mesh(usize, Arc<Solid>),
    /// A link of a model: the one of a name, or the only one.
    Link(Option<String>),
}

impl FilePart {
    /// Reads a mesh, or the link of a model.
    pub(super) fn read(file: &Path, link: Option<&str>, unit: Option<&str>) -> Result<Self, SceneError> {
        let extension = file.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        if extension.is_some_and(|extension| MODELS.contains(&extension.as_str())) {
            let triangles = triangles_of_link(file, link)?;
            return Ok(Self { file: file.to_owned(), kind: Kind::Link(link.map(str::to_owned)), triangles });
        }
        if let Some(link) = link {
            let problem = format!("a mesh has no links, such as `{link}`: name a model, or no link");
            return Err(SceneError::about(file, problem));
        }
        let unit = mesh_unit(file, unit)?;
        let solid = KnownMeshes::default().solid(file, SCALES[unit]);
        let solid = solid.map_err(|error| SceneError::about(file, format!("mesh: {error}")))?;
        let triangles = solid.corner_triangles().collect();
        let part = Self { file: file.to_owned(), kind: Kind::Mesh(unit, solid), triangles };
        let size = part.bounds().edges().into_iter().fold(0.0, f64::max);
        if USUAL_SIZES.contains(&size) {
            return Ok(part);
        }
        let problem = format!("the mesh is {} m long: is `--unit {}` right?", (1e9 * size).round() / 1e9, UNITS[unit]);
        Err(SceneError::about(file, problem))
    }

    /// Triangles of its surface (m), anticlockwise seen from outside.
    pub fn triangles(&self) -> &[[[f64; 3]; 3]] {
        &self.triangles
    }

    /// The box around it.
    pub fn bounds(&self) -> BoundingBox {
        BoundingBox::around(&self.triangles)
    }

    /// How the scene in a file names it.
    pub(super) fn shape(&self, scene: &Path) -> Result<DraftShape, SceneError> {
        let file = relative_path(&self.file, scene)?;
        Ok(match &self.kind {
            Kind::Mesh(unit, _) => DraftShape::Mesh(file, UNITS[*unit]),
            Kind::Link(link) => DraftShape::Model(file, link.clone()),
        })
    }
}

/// Index of the unit of a mesh.
fn mesh_unit(file: &Path, unit: Option<&str>) -> Result<usize, SceneError> {
    let Some(unit) = unit else {
        return Err(SceneError::about(file, format!("a mesh needs its unit (--unit): {}", UNITS.join(", "))));
    };
    let known = UNITS.iter().position(|known| *known == unit);
    known.ok_or_else(|| SceneError::about(file, format!("unknown unit `{unit}`: choose one of {}", UNITS.join(", "))))
}

//! Triangle meshes from STL and OBJ files.

use std::path::Path;

use crate::error::MeshError;
use crate::geometry::Vector;
use crate::{obj, precision, stl};

/// Larger meshes are refused.
pub const MOST_TRIANGLES: usize = 200_000;
/// Larger files (bytes) hold more triangles than that.
const LARGEST_FILE: u64 = 1 << 28;
/// Larger coordinates (m) are a mistake.
const LARGEST_COORDINATE: f64 = 1e6;

/// Formats of mesh files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// STL, as text or binary.
    Stl,
    /// Wavefront OBJ.
    Obj,
}

/// What a file holds, in its own unit.
pub struct Triangles {
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[usize; 3]>,
    /// How far coordinates may be from those that were meant.
    pub rounding: f64,
}

/// The triangles of a file as they are, in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct TriangleMesh {
    pub(crate) vertices: Vec<Vector>,
    pub(crate) triangles: Vec<[usize; 3]>,
    pub(crate) scale: f64,
    pub(crate) rounding: f64,
}

impl TriangleMesh {
    /// Reads an STL (binary or ASCII) or OBJ file whose unit is `scale` metres.
    ///
    /// # Errors
    /// When the file cannot be read, is something else, empty, too long or cut off, or has a line that is wrong: nothing of
    /// a file is left out but what has no shape.
    pub fn read(path: &Path, scale: f64) -> Result<Self, MeshError> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        let format = match extension.as_deref() {
            Some("stl") => Format::Stl,
            Some("obj") => Format::Obj,
            other => return Err(MeshError::Format { extension: other.unwrap_or_default().to_owned() }),
        };
        Self::parse(&input::read(path, LARGEST_FILE).map_err(unreadable)?, format, scale)
    }

    /// The same for the content of a file.
    ///
    /// # Errors
    /// As for [`TriangleMesh::read`].
    pub fn parse(bytes: &[u8], format: Format, scale: f64) -> Result<Self, MeshError> {
        let Triangles { vertices, triangles, rounding } = match format {
            Format::Stl => stl::read(bytes)?,
            Format::Obj => obj::read(bytes)?,
        };
        Self::new(&vertices, &triangles, scale, rounding)
    }

    /// Triangles of `vertices` in a unit of `scale` metres whose coordinates are known to `rounding` (in that unit).
    ///
    /// # Errors
    /// When there are no triangles or too many, a coordinate is not a finite number or an index out of range.
    pub fn new(vertices: &[[f64; 3]], triangles: &[[usize; 3]], scale: f64, rounding: f64) -> Result<Self, MeshError> {
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(MeshError::Scale { scale });
        }
        if triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        if triangles.len() > MOST_TRIANGLES {
            return Err(MeshError::TooManyTriangles { most: MOST_TRIANGLES });
        }
        if let Some(index) = triangles.iter().position(|corners| corners.iter().any(|&corner| corner >= vertices.len()))
        {
            return Err(MeshError::Vertex { index: index + 1 });
        }
        let is_length = |coordinate: &f64| (coordinate * scale).abs() <= LARGEST_COORDINATE;
        if let Some(index) = vertices.iter().position(|vertex| !vertex.iter().all(is_length)) {
            return Err(MeshError::Coordinate { index: index + 1 });
        }
        let vertices: Vec<Vector> = vertices.iter().map(|vertex| Vector::from(*vertex) * scale).collect();
        let rounding = precision::reasonable(rounding * scale, &vertices);
        Ok(Self { vertices, triangles: triangles.to_vec(), scale, rounding })
    }

    /// Its corners (m), some of them several times.
    pub fn corners(&self) -> impl Iterator<Item = [f64; 3]> {
        self.triangles.iter().flatten().map(|&corner| self.vertices[corner].into())
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Roundings (m) that coordinates may have: that of the file, and coarser ones.
    pub(crate) fn roundings(&self) -> Vec<f64> {
        let coarsest = precision::coarsest(&self.vertices);
        let coarser = (1..).map(|power| self.rounding * 10f64.powi(power)).take_while(|rounding| *rounding < coarsest);
        std::iter::once(self.rounding).chain(coarser).chain((self.rounding < coarsest).then_some(coarsest)).collect()
    }

    /// How far a coordinate of the file may be from the one that was meant (m).
    pub fn rounding(&self) -> f64 {
        self.rounding
    }
}

fn unreadable(error: impl std::fmt::Display) -> MeshError {
    MeshError::Read { reason: error.to_string() }
}

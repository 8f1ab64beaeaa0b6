//! Triangle meshes from STL and OBJ files.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use crate::error::MeshError;
use crate::geometry::Vector;
use crate::precision;
use crate::triangulate::triangulate;

/// Larger meshes are refused.
pub const MOST_TRIANGLES: usize = 200_000;
/// Larger files (bytes) hold more triangles than that.
const LARGEST_FILE: u64 = 1 << 28;
/// Larger coordinates (m) are a mistake.
const LARGEST_COORDINATE: f64 = 1e6;
/// Binary STL: a header with the number of triangles, then that many records.
const STL_HEADER: usize = 84;
const STL_RECORD: usize = 50;

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
    /// When the file cannot be read, is empty or too long, or has coordinates that are no finite numbers.
    pub fn read(path: &Path, scale: f64) -> Result<Self, MeshError> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        let bytes = || -> Result<Vec<u8>, MeshError> {
            let file = File::open(path).map_err(unreadable)?;
            if file.metadata().map_err(unreadable)?.len() > LARGEST_FILE {
                return Err(MeshError::Read { reason: "the file is larger than 256 MiB".to_owned() });
            }
            let mut bytes = Vec::new();
            file.take(LARGEST_FILE).read_to_end(&mut bytes).map_err(unreadable)?;
            Ok(bytes)
        };
        match extension.as_deref() {
            Some("stl") => Self::from_stl(&bytes()?, scale),
            Some("obj") => Self::from_obj(&bytes()?, scale),
            other => Err(MeshError::Format { extension: other.unwrap_or_default().to_owned() }),
        }
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
            return Err(MeshError::TooManyTriangles { count: triangles.len(), most: MOST_TRIANGLES });
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

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// How far a coordinate of the file may be from the one that was meant (m).
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    fn from_stl(bytes: &[u8], scale: f64) -> Result<Self, MeshError> {
        let count = bytes.get(80..STL_HEADER).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
        // Some programs begin binary files with the word that marks ASCII ones; the length is the safer sign.
        let is_binary =
            count.is_some_and(|count| bytes.len() as u64 == STL_HEADER as u64 + STL_RECORD as u64 * u64::from(count));
        let mut bytes = std::borrow::Cow::Borrowed(bytes);
        if is_binary {
            bytes.to_mut()[..STL_HEADER - 4].fill(0);
        }
        let mut reader = std::io::Cursor::new(&bytes);
        let triangles = stl_io::create_stl_reader(&mut reader).map_err(unreadable)?;
        let mut vertices = Vec::new();
        for triangle in triangles {
            vertices.extend(triangle.map_err(unreadable)?.vertices.map(|vertex| vertex.0.map(f64::from)));
            if vertices.len() > 3 * MOST_TRIANGLES {
                return Err(MeshError::TooManyTriangles { count: vertices.len() / 3, most: MOST_TRIANGLES });
            }
        }
        let triangles: Vec<[usize; 3]> =
            (0..vertices.len() / 3).map(|first| [3 * first, 3 * first + 1, 3 * first + 2]).collect();
        let digits = if is_binary { 0.0 } else { precision::of_text(&bytes, "vertex") };
        Self::new(&vertices, &triangles, scale, digits.max(precision::single(&vertices)))
    }

    fn from_obj(bytes: &[u8], scale: f64) -> Result<Self, MeshError> {
        let options = tobj::LoadOptions { ignore_points: true, ignore_lines: true, ..Default::default() };
        // Materials do not matter.
        let (models, _) =
            tobj::load_obj_buf(&mut BufReader::new(bytes), &options, |_| Ok(Default::default())).map_err(unreadable)?;
        let mut vertices: Vec<[f64; 3]> = Vec::new();
        let mut triangles = Vec::new();
        for tobj::Model { mesh, .. } in &models {
            let first = vertices.len();
            vertices.extend(mesh.positions.chunks_exact(3).map(|point| [point[0], point[1], point[2]]));
            let mut indices = mesh.indices.iter().map(|&index| first + index as usize);
            // Without a list of arities all faces are triangles.
            let arities = if mesh.face_arities.is_empty() {
                vec![3; mesh.indices.len() / 3]
            } else {
                mesh.face_arities.iter().map(|&arity| arity as usize).collect()
            };
            for arity in arities {
                let corners: Vec<usize> = indices.by_ref().take(arity).collect();
                if corners.iter().any(|&corner| corner >= vertices.len()) {
                    return Err(MeshError::Vertex { index: triangles.len() + 1 });
                }
                // Faces may have any shape: a fan from the first corner would overlap itself.
                let points: Vec<Vector> = corners.iter().map(|&corner| Vector::from(vertices[corner])).collect();
                triangles.extend(triangulate(&points).into_iter().map(|triangle| triangle.map(|place| corners[place])));
                if triangles.len() > MOST_TRIANGLES {
                    return Err(MeshError::TooManyTriangles { count: triangles.len(), most: MOST_TRIANGLES });
                }
            }
        }
        Self::new(&vertices, &triangles, scale, precision::of_text(bytes, "v"))
    }
}

fn unreadable(error: impl std::fmt::Display) -> MeshError {
    MeshError::Read { reason: error.to_string() }
}

//! Meshes that were read before the scene that names them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use mesh::{MeshError, Solid, TriangleMesh};

/// Surfaces of mesh files. Whoever makes a scene from files that it has read passes them on, so that they are neither read
/// nor repaired again.
#[derive(Debug, Clone, Default)]
pub struct KnownMeshes(Vec<KnownMesh>);

#[derive(Debug, Clone)]
struct KnownMesh {
    file: PathBuf,
    scale: f64,
    solid: Arc<Solid>,
}

impl KnownMeshes {
    /// Adds the surface of a file whose unit has a length of `scale` (m).
    pub fn add(&mut self, file: &Path, scale: f64, solid: Arc<Solid>) {
        self.0.extend(file.canonicalize().map(|file| KnownMesh { file, scale, solid }));
    }

    /// The surface of a file whose unit has a length of `scale` (m), from the file unless it is known.
    ///
    /// # Errors
    /// When the file cannot be read, or inside and outside of its surface cannot be decided.
    pub fn solid(&self, file: &Path, scale: f64) -> Result<Arc<Solid>, MeshError> {
        let is_asked =
            |known: &&KnownMesh| known.scale == scale && file.canonicalize().is_ok_and(|file| file == known.file);
        match self.0.iter().find(is_asked) {
            Some(known) => Ok(Arc::clone(&known.solid)),
            None => TriangleMesh::read(file, scale).and_then(|mesh| Solid::of(&mesh)).map(Arc::new),
        }
    }
}

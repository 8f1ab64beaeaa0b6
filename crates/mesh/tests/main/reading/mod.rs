//! Files as other programs write them, and as they should not be.

mod hostile;
mod mutations;
mod random;
mod writers;
mod written;

use mesh::{Format, MeshError, Solid, TriangleMesh};

/// Volume (in the unit of the file cubed) of what a file holds.
fn volume(content: &[u8], format: Format) -> Result<f64, MeshError> {
    let solid = Solid::of(&TriangleMesh::parse(content, format, 1e-3)?)?;
    Ok(1e9 * solid.mass_properties().volume)
}

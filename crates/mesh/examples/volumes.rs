//! Reads mesh files in mm and prints for each its volume (mm^3), or why it is refused: `volumes FILE...`.

use std::path::Path;

use mesh::{Solid, TriangleMesh};

fn main() {
    for file in std::env::args().skip(1) {
        let solid = TriangleMesh::read(Path::new(&file), 1e-3).and_then(|mesh| Solid::of(&mesh));
        match solid {
            Ok(solid) => println!("{file}\t{}", 1e9 * solid.mass_properties().volume),
            Err(error) => println!("{file}\t{error}"),
        }
    }
}

//! Convex meshes from STL files.

use std::fs::File;
use std::io::BufReader;

use collision::Polytope;
use toml::Spanned;

use crate::error::{SceneError, Source};

/// A vertex this far inside the hull, relative to the part's size, makes a mesh not convex.
const CONVEXITY_TOLERANCE: f64 = 1e-3;

/// Vertices (m) of a convex mesh whose file name is relative to the scene.
pub fn vertices(source: Source, mesh: &Spanned<String>, scale: f64) -> Result<Vec<[f64; 3]>, SceneError> {
    let path = source.file.parent().unwrap_or(source.file).join(mesh.get_ref());
    let refuse = |reason: String| source.error(mesh.span(), format!("mesh {}: {reason}", path.display()));
    let file = File::open(&path).map_err(|error| refuse(error.to_string()))?;
    let mesh = stl_io::read_stl(&mut BufReader::new(file)).map_err(|error| refuse(error.to_string()))?;
    let vertices: Vec<[f64; 3]> =
        mesh.vertices.iter().map(|vertex| std::array::from_fn(|axis| f64::from(vertex[axis]) * scale)).collect();
    let hull = Polytope::from_vertices(&vertices).map_err(|error| refuse(error.to_string()))?;
    let depth = vertices.iter().map(|vertex| depth(&hull, vertex)).fold(0.0, f64::max);
    if depth > CONVEXITY_TOLERANCE * hull.size() {
        return Err(refuse(format!(
            "not convex: a vertex lies {:.3} mm inside the convex hull; split it into convex parts",
            1e3 * depth
        )));
    }
    Ok(vertices)
}

/// Distance of a point inside from the nearest facet (m).
fn depth(hull: &Polytope, point: &[f64; 3]) -> f64 {
    let facets = hull.normals().iter().zip(hull.offsets());
    facets
        .map(|(normal, offset)| offset - normal.iter().zip(point).map(|(n, p)| n * p).sum::<f64>())
        .fold(f64::INFINITY, f64::min)
}

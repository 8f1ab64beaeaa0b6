//! Convex meshes from STL files.

use std::fs::File;
use std::io::BufReader;

use collision::Polytope;
use toml::Spanned;

use crate::error::{SceneError, Source};

/// A surface this far inside the convex hull, relative to the part's size, makes a mesh not convex.
const CONVEXITY_TOLERANCE: f64 = 1e-4;

/// Distance, relative to the largest coordinate, below which the single precision of the file says nothing: points are
/// rounded by up to half of `f32::EPSILON` along each axis.
const ROUNDING: f64 = 2.0 * f32::EPSILON as f64;

/// Longer files are refused.
const MOST_TRIANGLES: usize = 200_000;

type Triangle = [[f64; 3]; 3];

/// The shape (m) of a closed convex mesh whose file name is relative to the scene and whose unit is `scale` metres.
///
/// # Errors
/// When the file cannot be read, is too long, or its surface is not that of its convex hull.
pub fn shape(source: Source, mesh: &Spanned<String>, scale: f64) -> Result<Polytope, SceneError> {
    let path = source.file.parent().unwrap_or(source.file).join(mesh.get_ref());
    let refuse = |reason: String| source.error(mesh.span(), format!("mesh {}: {reason}", path.display()));
    let file = File::open(&path).map_err(|error| refuse(error.to_string()))?;
    let triangles = triangles(file).map_err(refuse)?;
    let vertices: Vec<[f64; 3]> =
        triangles.iter().flatten().map(|vertex| vertex.map(|coordinate| coordinate * scale)).collect();
    let farthest = vertices.as_flattened().iter().fold(0.0, |farthest: f64, coordinate| farthest.max(coordinate.abs()));
    let hull =
        Polytope::from_vertices_within(&vertices, ROUNDING * farthest).map_err(|error| refuse(error.to_string()))?;
    let (depth, place) = deepest(&hull, &triangles, scale);
    if depth > CONVEXITY_TOLERANCE * hull.size() {
        let [x, y, z] = place;
        return Err(refuse(format!(
            "not convex: at ({x:.4}, {y:.4}, {z:.4}) in the unit of the file, its surface lies {:.3} mm inside its \
             convex hull; split it into convex parts",
            1e3 * depth
        )));
    }
    Ok(hull)
}

/// The triangles in the unit of the file.
fn triangles(mut file: File) -> Result<Vec<Triangle>, String> {
    if file.metadata().is_ok_and(|metadata| metadata.len() == 0) {
        return Err("the file is empty".to_owned());
    }
    let mut reader = BufReader::new(&mut file);
    let mut triangles = Vec::new();
    for triangle in stl_io::create_stl_reader(&mut reader).map_err(|error| error.to_string())? {
        let vertices = triangle.map_err(|error| error.to_string())?.vertices;
        if triangles.len() == MOST_TRIANGLES {
            return Err(format!("more than {MOST_TRIANGLES} triangles; simplify it"));
        }
        let triangle: Triangle = vertices.map(|vertex| vertex.0.map(f64::from));
        if triangle.as_flattened().iter().any(|coordinate| !coordinate.is_finite()) {
            return Err(format!("triangle {} has a coordinate that is not a finite number", triangles.len() + 1));
        }
        triangles.push(triangle);
    }
    if triangles.is_empty() {
        return Err("it has no triangles".to_owned());
    }
    Ok(triangles)
}

/// How far the surface lies inside the hull (m), and where it does so most, in the unit of the file.
///
/// A closed mesh is convex when each of its triangles lies in a facet of the hull. Unlike its vertices, the centre of a
/// triangle lies there only if all of it does. Slivers have a centre but no reliable plane: nothing else is asked of them.
fn deepest(hull: &Polytope, triangles: &[Triangle], scale: f64) -> (f64, [f64; 3]) {
    let center = |[a, b, c]: &Triangle| -> [f64; 3] { std::array::from_fn(|axis| (a[axis] + b[axis] + c[axis]) / 3.0) };
    let places = triangles.iter().flat_map(|triangle| [center(triangle), triangle[0], triangle[1], triangle[2]]);
    let depths = places.map(|place| (depth(hull, &place.map(|coordinate| coordinate * scale)), place));
    depths.fold((0.0, [0.0; 3]), |deepest, next| if next.0 > deepest.0 { next } else { deepest })
}

/// Distance of a point inside from the nearest facet (m).
fn depth(hull: &Polytope, point: &[f64; 3]) -> f64 {
    let facets = hull.normals().iter().zip(hull.offsets());
    facets
        .map(|(normal, offset)| offset - normal.iter().zip(point).map(|(n, p)| n * p).sum::<f64>())
        .fold(f64::INFINITY, f64::min)
}

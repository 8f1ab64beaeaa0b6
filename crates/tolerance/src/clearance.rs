//! Parts with another clearance.

use collision::{Polytope, PolytopeError};
use nalgebra::Vector3;
use scene::{Part, Scene};
use task::Pose;

/// A scene whose body is thinner by `more` (m) from side to side across the insertion, so that its clearance is larger by that;
/// a negative value makes the body thicker. Each halfspace moves as if the body were shrunk by a disc across the insertion:
/// lengths along the insertion stay, slopes keep their angles. Where convex parts of the body meet, their faces stay.
///
/// # Errors
/// With the name of the part of which nothing is left.
pub fn widened(scene: &Scene, out: &Vector3<f64>, more: f64) -> Result<Scene, (String, PolytopeError)> {
    let axis = Pose::isometry(&scene.goal).rotation.inverse() * out;
    let body = scene.body.iter().enumerate().map(|(index, part)| {
        let others = || scene.body.iter().enumerate().filter(move |(other, _)| *other != index).map(|(_, part)| part);
        let shape = &part.shape;
        let offset = |(normal, offset): (&[f64; 3], &f64)| {
            let across = Vector3::from(*normal).cross(&axis).norm();
            if is_covered(shape, normal, *offset, others) { *offset } else { offset - 0.5 * more * across }
        };
        let offsets: Vec<f64> = shape.normals().iter().zip(shape.offsets()).map(offset).collect();
        let moved = Polytope::from_halfspaces(shape.normals(), &offsets);
        Ok(Part { name: part.name.clone(), shape: moved.map_err(|error| (part.name.clone(), error))? })
    });
    Ok(Scene { body: body.collect::<Result<_, _>>()?, ..scene.clone() })
}

/// Distance from a face at which another part covers it (m).
const BEYOND: f64 = 1e-6;
/// Share of the way from the middle of a face to its corners where it is looked at.
const TOWARDS_CORNERS: f64 = 0.95;

/// Whether other parts lie against a whole face.
fn is_covered<'part, Others: Iterator<Item = &'part Part>>(
    shape: &Polytope,
    normal: &[f64; 3],
    offset: f64,
    others: impl Fn() -> Others,
) -> bool {
    let normal = Vector3::from(*normal);
    let vertices = shape.vertices().iter().copied().map(Vector3::from);
    let corners: Vec<_> = vertices.filter(|vertex| (normal.dot(vertex) - offset).abs() < BEYOND).collect();
    if corners.is_empty() {
        return false;
    }
    let middle = corners.iter().sum::<Vector3<f64>>() / corners.len() as f64;
    let points = corners.iter().map(|corner| middle.lerp(corner, TOWARDS_CORNERS)).chain([middle]);
    points.map(|point| point + 2.0 * BEYOND * normal).all(|point| others().any(|other| contains(&other.shape, &point)))
}

fn contains(shape: &Polytope, point: &Vector3<f64>) -> bool {
    let mut faces = shape.normals().iter().zip(shape.offsets());
    faces.all(|(normal, offset)| Vector3::from(*normal).dot(point) <= offset + BEYOND)
}

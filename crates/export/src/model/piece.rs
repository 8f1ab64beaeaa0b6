//! Convex pieces with their faces.

use collision::Polytope;
use nalgebra::Vector3;

/// Largest distance of a corner from the plane of its face, relative to the size of the piece.
const IN_PLANE: f64 = 1e-6;

/// A convex piece.
pub struct Piece {
    /// Its name in the scene, without control characters.
    pub name: String,
    /// Corners (m), in the frame of the body, or of the world for the environment.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each face, counterclockwise seen from outside.
    pub faces: Vec<Vec<usize>>,
}

impl Piece {
    /// Of a polytope.
    pub fn new(name: String, shape: &Polytope) -> Self {
        let planes = shape.normals().iter().zip(shape.offsets());
        let faces = planes.map(|(normal, offset)| face(shape, &Vector3::from(*normal), *offset));
        Self { name, vertices: shape.vertices().to_vec(), faces: faces.filter(|face| face.len() > 2).collect() }
    }

    /// As a Wavefront OBJ file.
    pub fn obj(&self) -> String {
        let vertices = self.vertices.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
        let corners = |face: &Vec<usize>| face.iter().map(|corner| format!(" {}", corner + 1)).collect::<String>();
        let faces = self.faces.iter().map(|face| format!("f{}\n", corners(face)));
        vertices.chain(faces).collect()
    }
}

/// The corners in a plane, in order around their middle.
fn face(shape: &Polytope, normal: &Vector3<f64>, offset: f64) -> Vec<usize> {
    let point = |index: usize| Vector3::from(shape.vertices()[index]);
    let is_in_plane = |index: &usize| (normal.dot(&point(*index)) - offset).abs() <= IN_PLANE * shape.size();
    let mut corners: Vec<usize> = (0..shape.vertices().len()).filter(is_in_plane).collect();
    let middle = corners.iter().map(|index| point(*index)).sum::<Vector3<f64>>() / corners.len().max(1) as f64;
    let across = Vector3::ith(normal.iamin(), 1.0).cross(normal).normalize();
    let up = normal.cross(&across);
    let angle = |index: &usize| {
        let arm = point(*index) - middle;
        arm.dot(&up).atan2(arm.dot(&across))
    };
    corners.sort_by(|first, second| angle(first).total_cmp(&angle(second)));
    corners
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    /// A closed surface passes each edge once in each direction, and encloses the volume of the shape.
    #[test]
    fn faces_close_around_the_volume() {
        let wedge =
            [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0], [2.0, 0.0, 3.0], [0.0, 1.0, 3.0]];
        let piece = Piece::new("wedge".to_owned(), &Polytope::from_vertices(&wedge).unwrap());
        assert_eq!(piece.faces.len(), 5);
        let mut edges: BTreeMap<[usize; 2], i32> = BTreeMap::new();
        let mut volume = 0.0;
        let point = |index: usize| Vector3::from(piece.vertices[index]);
        for face in &piece.faces {
            for (index, &corner) in face.iter().enumerate() {
                let next = face[(index + 1) % face.len()];
                *edges.entry([corner.min(next), corner.max(next)]).or_default() += if corner < next { 1 } else { -1 };
            }
            for pair in face[1..].windows(2) {
                volume += point(face[0]).dot(&point(pair[0]).cross(&point(pair[1]))) / 6.0;
            }
        }
        assert!(edges.values().all(|sum| *sum == 0) && edges.len() == 9);
        assert!((volume - 3.0).abs() < 1e-12);
        assert_eq!(piece.obj().lines().count(), 6 + 5);
    }
}

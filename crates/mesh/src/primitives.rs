//! Meshes of boxes and cylinders.

use std::f64::consts::TAU;

use crate::error::MeshError;
use crate::read::TriangleMesh;

/// Sides of the prism that is the mesh of a cylinder: its volume is that of the cylinder within 4e-4.
const SIDES: usize = 144;

impl TriangleMesh {
    /// A box around the origin with edge lengths (m) along the axes.
    ///
    /// # Errors
    /// When a length is not finite or larger than a part.
    pub fn cuboid(edges: [f64; 3]) -> Result<Self, MeshError> {
        let [x, y, z] = edges.map(|edge| 0.5 * edge);
        prism(&[[x, y], [-x, y], [-x, -y], [x, -y]], z)
    }

    /// A cylinder around the z axis with the origin in its middle, of a radius and a length (m). All vertices lie on it.
    ///
    /// # Errors
    /// As for [`TriangleMesh::cuboid`].
    pub fn cylinder(radius: f64, length: f64) -> Result<Self, MeshError> {
        let corner = |side: usize| {
            let (sine, cosine) = (TAU * side as f64 / SIDES as f64).sin_cos();
            [radius * cosine, radius * sine]
        };
        prism(&(0..SIDES).map(corner).collect::<Vec<_>>(), 0.5 * length)
    }
}

/// A prism over a convex polygon that runs anticlockwise, between two heights of this size (m).
fn prism(polygon: &[[f64; 2]], half: f64) -> Result<TriangleMesh, MeshError> {
    let count = polygon.len();
    let at = |height: f64| polygon.iter().map(move |&[x, y]| [x, y, height]);
    let vertices: Vec<[f64; 3]> = at(-half).chain(at(half)).collect();
    let caps = (1..count - 1).flat_map(|side| [[0, side + 1, side], [count, count + side, count + side + 1]]);
    let sides = (0..count).flat_map(|side| {
        let next = (side + 1) % count;
        [[side, next, count + next], [side, count + next, count + side]]
    });
    TriangleMesh::new(&vertices, &caps.chain(sides).collect::<Vec<_>>(), 1.0, 0.0)
}

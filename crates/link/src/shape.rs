//! Collision shapes.

use std::ops::Range;
use std::path::PathBuf;

use nalgebra::Isometry3;

/// A collision shape of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkShape {
    /// Its name, or the element and its number among the link's, such as `geom 3`.
    pub name: String,
    /// From its own frame to that of the link (m).
    pub pose: Isometry3<f64>,
    /// The geometry in its own frame.
    pub geometry: Geometry,
    /// Place of its element in the file (bytes).
    pub span: Range<usize>,
}

/// Geometry of a collision shape in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// A box around the origin.
    Box {
        /// Edge lengths (m).
        edges: [f64; 3],
    },
    /// A cylinder around the z axis with the origin in its middle.
    Cylinder {
        /// Radius (m).
        radius: f64,
        /// Length (m).
        length: f64,
    },
    /// A triangle mesh.
    Mesh {
        /// Its file, which need not be there.
        file: PathBuf,
        /// Unit of the file (m).
        scale: f64,
    },
}

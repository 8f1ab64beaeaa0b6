//! The surface of a mesh as triangles, and the repairs that closed it and wound it consistently.

use crate::edges::{components, edges};
use crate::error::MeshError;
use crate::geometry::Vector;

/// What was changed in a mesh. Places are in the unit of the file.
#[derive(Debug, Clone, PartialEq)]
pub enum Repair {
    /// Vertices are less precise than the file writes them: those within a distance were taken as one.
    Welded {
        /// That distance (m).
        distance: f64,
    },
    /// Triangles without area within the precision of the file, that join nothing, were dropped.
    Collapsed {
        /// Number of triangles.
        triangles: usize,
    },
    /// Copies of triangles that are there several times were dropped, wound alike or not, and walls between bodies.
    Duplicates {
        /// Number of triangles.
        triangles: usize,
    },
    /// Triangles wound against their neighbours were turned around.
    Rewound {
        /// Number of triangles.
        triangles: usize,
    },
    /// Shells whose outside was inside were turned around.
    Inverted {
        /// Number of shells.
        shells: usize,
    },
    /// Closed shells that enclose nothing within the precision of the file were dropped.
    Flat {
        /// Number of shells.
        shells: usize,
    },
    /// A gap of zero width, beside a corner in the middle of an edge, was closed.
    Sewn {
        /// Middle of the gap's corners.
        place: [f64; 3],
        /// Number of its edges.
        edges: usize,
    },
    /// A small planar hole was closed. Whether it is a lost triangle or the mouth of a pocket that was lost, nobody can
    /// tell.
    Capped {
        /// Middle of the hole's corners.
        place: [f64; 3],
        /// Number of its edges.
        edges: usize,
        /// Its area (m^2).
        area: f64,
    },
    /// A sheet without thickness across a hole, or inside of the material, was dropped.
    Sheet {
        /// Middle of its corners.
        place: [f64; 3],
        /// Number of triangles.
        triangles: usize,
    },
    /// Two rims that lie side by side were joined.
    Joined {
        /// Middle of one of them.
        place: [f64; 3],
        /// Number of its edges.
        edges: usize,
        /// How far the other one was moved at most (m).
        moved: f64,
    },
    /// The surface crosses itself or does not quite close. Winding numbers say what is inside; no surface was moved.
    Decided {
        /// Why the surface cannot be taken as it is.
        reason: Box<MeshError>,
        /// Edges at which it does not close.
        open: usize,
        /// Cracks there are narrower than this (m).
        crack: f64,
        /// Triangles that separate nothing, and were dropped.
        hidden: usize,
    },
}

impl std::fmt::Display for Repair {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Welded { distance } => write!(formatter, "vertices within {:.6} mm welded", 1e3 * distance),
            Self::Collapsed { triangles } => write!(formatter, "{triangles} triangles without area dropped"),
            Self::Duplicates { triangles } => write!(formatter, "{triangles} duplicate triangles dropped"),
            Self::Rewound { triangles } => write!(formatter, "{triangles} triangles with reversed winding flipped"),
            Self::Inverted { shells } => write!(formatter, "{shells} shells turned inside out"),
            Self::Flat { shells } => write!(formatter, "{shells} shells without volume dropped"),
            Self::Sewn { place: [x, y, z], edges } => {
                write!(formatter, "gap of zero width, {edges} edges, at ({x:.6}, {y:.6}, {z:.6}) closed")
            }
            Self::Capped { place: [x, y, z], edges, area } => write!(
                formatter,
                "hole of {edges} edges at ({x:.6}, {y:.6}, {z:.6}) closed by a flat cap of {:.3} mm^2",
                1e6 * area
            ),
            Self::Sheet { place: [x, y, z], triangles } => {
                write!(formatter, "sheet without thickness, {triangles} triangles, at ({x:.6}, {y:.6}, {z:.6}) dropped")
            }
            Self::Joined { place: [x, y, z], edges, moved } => write!(
                formatter,
                "rims of {edges} edges at ({x:.6}, {y:.6}, {z:.6}) joined, moved by up to {:.4} mm",
                1e3 * moved
            ),
            Self::Decided { reason, open, crack, hidden } => {
                write!(formatter, "inside and outside decided by winding numbers ({})", reason.finding())?;
                if *open > 0 {
                    write!(formatter, ", {open} edges open with cracks of less than {:.4} mm", 1e3 * crack)?;
                }
                if *hidden > 0 {
                    write!(formatter, ", {hidden} triangles that separate nothing dropped")?;
                }
                Ok(())
            }
        }
    }
}

/// A closed and consistently wound surface.
pub struct Surface {
    pub vertices: Vec<Vector>,
    pub triangles: Vec<[usize; 3]>,
    pub repairs: Vec<Repair>,
}

impl Surface {
    /// Triangles (indices) of each shell.
    pub fn shells(&self) -> Vec<Vec<usize>> {
        components(self.triangles.len(), &edges(&self.triangles))
    }
}

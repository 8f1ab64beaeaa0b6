//! Why a mesh is refused.

use crate::cover::MOST_PIECES;
use crate::solid::Solid;

/// Why a mesh cannot be read or turned into polytopes. Places are in the unit of the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The file cannot be opened or read.
    #[error("cannot be read: {reason}")]
    Read {
        /// What the system says, or what is wrong.
        reason: String,
    },
    /// A line of a text file is wrong, or the file ends there.
    #[error("line {line}: {problem}")]
    Line {
        /// Number of the line, from one.
        line: usize,
        /// What is wrong there.
        problem: String,
    },
    /// The file is of a kind that is known and not what its name says.
    #[error("it is {what}")]
    Foreign {
        /// What it is and what to do about it.
        what: &'static str,
    },
    /// Nothing but blanks.
    #[error("the file is empty: nothing is in its {size} bytes")]
    NoContent {
        /// Bytes of the file.
        size: usize,
    },
    /// A binary STL file is shorter than its header says.
    #[error(
        "the file is cut off or no STL file: its header states {count} triangles, which take {needed} bytes, and it has {size}"
    )]
    CutOff {
        /// Triangles that the header states.
        count: u32,
        /// Bytes that they need, with the header.
        needed: u64,
        /// Bytes of the file.
        size: usize,
    },
    /// A binary STL file is longer than its header says.
    #[error(
        "its header states {count} triangles, which end at byte {end}, but {left} bytes follow: if several files were joined, export all bodies as one"
    )]
    LeftOver {
        /// Triangles that the header states.
        count: u32,
        /// Bytes up to the end of these.
        end: usize,
        /// Bytes that follow.
        left: usize,
    },
    /// Neither `.stl` nor `.obj`.
    #[error("'{extension}' is not a known format: use .stl or .obj{}", step_advice(.extension))]
    Format {
        /// Extension of the file's name.
        extension: String,
    },
    /// The unit is not a positive number of metres.
    #[error("a unit of {scale} m makes no sense: it must be a positive number")]
    Scale {
        /// The unit (m).
        scale: f64,
    },
    /// No triangles.
    #[error("it has no triangles")]
    Empty,
    /// Longer than is handled in reasonable time.
    #[error("more than {most} triangles are too many: simplify the mesh or export it coarser")]
    TooManyTriangles {
        /// Largest number.
        most: usize,
    },
    /// A coordinate is infinite, not a number, or no length that a part has.
    #[error("vertex {index} (counted from one) has a coordinate that is not a finite number below 1e6 m")]
    Coordinate {
        /// Index of the vertex, from one.
        index: usize,
    },
    /// A triangle names a vertex that is not there.
    #[error("triangle {index} (counted from one) names a vertex that does not exist")]
    Vertex {
        /// Index of the triangle, from one.
        index: usize,
    },
    /// All triangles in one plane or smaller than the precision of the file.
    #[error("the mesh encloses nothing: its volume is zero within the precision of the file")]
    Flat,
    /// A hole that is not certain to be a mere omission.
    #[error("the surface is open: a boundary of {edges} edges, {length:.6} long, passes ({:.6}, {:.6}, {:.6}); close the hole in the CAD program", place[0], place[1], place[2])]
    Open {
        /// A point of the boundary.
        place: [f64; 3],
        /// Length of the boundary.
        length: f64,
        /// Number of its edges.
        edges: usize,
    },
    /// More than two triangles meet in an edge and do not enclose a volume consistently.
    #[error("{count} triangles meet in the edge at ({:.6}, {:.6}, {:.6}): the surface does not separate inside from outside there; remove inner walls in the CAD program", place[0], place[1], place[2])]
    NonManifold {
        /// Middle of the edge.
        place: [f64; 3],
        /// Number of triangles.
        count: usize,
    },
    /// The surface has one side only.
    #[error("the triangles around ({:.6}, {:.6}, {:.6}) cannot be wound consistently: the surface has one side only", place[0], place[1], place[2])]
    OneSided {
        /// Where windings contradict each other.
        place: [f64; 3],
    },
    /// Triangles cross each other.
    #[error("the surface crosses itself at ({:.6}, {:.6}, {:.6}); unite the bodies in the CAD program", place[0], place[1], place[2])]
    SelfIntersecting {
        /// A point of both triangles of a pair.
        place: [f64; 3],
    },
    /// A shell inside of another that is neither a void nor a body in a void.
    #[error("the shell around ({:.6}, {:.6}, {:.6}) lies inside another one and is oriented like it: neither a void nor another body; remove one of them", place[0], place[1], place[2])]
    Nested {
        /// A point of the inner shell.
        place: [f64; 3],
    },
    /// A setting out of its range.
    #[error("{name} = {value} makes no sense: {range}")]
    Setting {
        /// Name of the setting.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        range: &'static str,
    },
    /// The cover would be too large to plan with, or take too long to be found.
    #[error(
        "the part needs too many convex pieces, more than {most}, or too much time to find them: threads and scanned or sculpted surfaces are not for this program; export a plainer part, such as a cylinder in place of a thread{}",
        if *curved > 0 { ", or set fewer `facets`" } else { "" }
    )]
    TooManyPieces {
        /// Largest number of pieces.
        most: usize,
        /// Number of curved surfaces.
        curved: usize,
    },
    /// A convex part has more facets than can be planned with.
    #[error("the part is convex and has {count} planar facets, more than {most}: export it coarser")]
    TooManyHalfspaces {
        /// Number of facets.
        count: usize,
        /// Largest number.
        most: usize,
    },
    /// Nothing is left of the part within the crop box and its clearance.
    #[error("no material is left: `clearance` takes all of the part")]
    NothingLeft,
}

/// What else helps with a format of CAD programs.
fn step_advice(extension: &str) -> &'static str {
    if ["step", "stp"].contains(&extension) { ", which scripts/lab step-to-obj makes of it" } else { "" }
}

impl MeshError {
    /// That a solid needs too many pieces.
    pub(crate) fn too_many_pieces(solid: &Solid) -> Self {
        Self::TooManyPieces { most: MOST_PIECES, curved: solid.curved.len() }
    }

    /// What was found, without what to do.
    pub(crate) fn finding(&self) -> String {
        let text = self.to_string();
        text.split(';').next().unwrap_or_default().to_owned()
    }

    /// Whether winding numbers may decide in spite of it.
    pub(crate) fn is_undecided(&self) -> bool {
        matches!(
            self,
            Self::Open { .. } | Self::NonManifold { .. } | Self::OneSided { .. } | Self::SelfIntersecting { .. }
        )
    }
}

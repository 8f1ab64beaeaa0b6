//! Why a mesh is refused.

/// Why a mesh cannot be read or turned into polytopes. Places are in the unit of the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The file cannot be opened or read.
    #[error("cannot be read: {reason}")]
    Read {
        /// What the system or the format's reader says.
        reason: String,
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
    #[error("{count} triangles are too many: at most {most} are allowed; simplify the mesh or export it coarser")]
    TooManyTriangles {
        /// Number of triangles.
        count: usize,
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
    #[error("the surface crosses itself at {count} pairs of triangles, one at ({:.6}, {:.6}, {:.6}); unite the bodies in the CAD program", place[0], place[1], place[2])]
    SelfIntersecting {
        /// A point of both triangles of a pair.
        place: [f64; 3],
        /// Number of pairs found.
        count: usize,
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
    /// The cover would be too large to plan with.
    #[error(
        "the part needs more than {most} convex pieces, or cells to find them: crop it to where the motion is, use fewer facets for curved surfaces ({curved} of them) or a coarser tolerance"
    )]
    TooManyPieces {
        /// Largest number of pieces or cells.
        most: usize,
        /// Number of curved surfaces.
        curved: usize,
    },
    /// Nothing is left of the part.
    #[error("no material is left: the crop box misses the part or the clearance is larger than it")]
    NothingLeft,
}

/// What else helps with a format of CAD programs.
fn step_advice(extension: &str) -> &'static str {
    if ["step", "stp"].contains(&extension) { ", which scripts/step-to-obj makes of it" } else { "" }
}

//! Triangle meshes of CAD parts to convex polytopes that contain them.

mod bvh;
mod cell;
mod coarsen;
mod cone;
mod cover;
mod crossing;
mod curved;
mod deviation;
mod edges;
mod elements;
mod error;
mod faces;
mod facets;
mod geometry;
mod mass;
mod merge;
mod partition;
mod planes;
mod precision;
mod read;
mod repair;
mod set_cover;
mod shells;
mod solid;
mod strips;
mod surface;
mod triangulate;
mod weld;

pub use cover::{Cover, CoverSettings, Piece};
pub use deviation::Deviation;
pub use error::MeshError;
pub use mass::MassProperties;
pub use read::TriangleMesh;
pub use repair::Repair;
pub use solid::Solid;
pub use surface::{CurvedKind, CurvedSurface};

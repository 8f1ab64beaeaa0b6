//! Triangle meshes of CAD parts to convex polytopes that contain them, with the error of every step.
//!
//! [`TriangleMesh`] is what a file says, [`Solid`] the closed surface with its planes, cylinders and cones, [`Cover`] the
//! convex pieces, and [`Deviation`] compares pieces and mesh by other means than those that made them.
//!
//! | step | what it does | error |
//! |---|---|---|
//! | read | STL, OBJ with polygons of any shape, all of it or an error ([`MeshError`]); lengths in metres | the rounding of the file: half its last digit, or of single precision; at most 1e-5 of the size |
//! | weld | vertices within 4 roundings are one | the same |
//! | repair | drops, joins, rewinds, closes what is certain ([`Repair`]), refuses the rest ([`MeshError`]) | caps are planar within 8 roundings |
//! | planes | triangles within 4 roundings of the plane of a larger one join it; equal planes within 8 are one | [`Cover::tolerance`] |
//! | curves | strips that turn by less than 25 degrees and have their vertices on a cylinder or cone | [`CurvedSurface::mesh_error`] |
//! | facets | N per turn, outside of the material: r (1 / cos(pi/N) - 1) if convex, r (1 - cos(pi/N)) if concave | [`CurvedSurface::error`] |
//! | partition | the box of the part, or the crop box, is split by the planes until no cell has surface inside, other than within its facet's error behind a plane | none beyond the facets' |
//! | merge | cells with material grow as long as they meet no free cell; superfluous ones go | pieces meet free cells by at most 2 tolerances, gaps between them are thinner than that |
//! | places | pieces are kept only for cells that have surface where something moves ([`Cover::facing`]) | none there |
//! | coarsen | halfspaces are dropped | outward, [`Cover::growth`], at most the tolerance that is asked for |
//! | clearance | surfaces, not cuts, move into the material | exactly the clearance |
//!
//! A surface that crosses itself or does not quite close has no such cover: winding numbers say what is inside
//! ([`Solid::is_rough`]). [`Cover::touching`] covers it, and any other, within a budget where something passes it:
//!
//! | step | what it does | error |
//! |---|---|---|
//! | places | points of the other part along its way, with their distances from the surface | none |
//! | cut | the hull is cut by planes of the surface while pieces come too close to places | [`Budget`] |
//! | join | pieces are joined as long as their hull is not too close | the same |
//! | trim | bounding boxes of pieces are cut by planes of their hulls until they are not too close | the same |
//!
//! [`Gauge`] measures the gap between meshes, to compare it with that between pieces, and [`Separation`] how far one can
//! be moved past another.
//!
//! Facets of full turns have normals at multiples of 2 pi/N from +x (from +y around an axis along x), so that a peg and a
//! hole that are mated in one frame have facets face to face, and surfaces around one axis share them. Arcs that planes
//! continue, such as fillets, are divided evenly between these. Spheres, tori and free forms stay facets of the mesh,
//! unless rings of them are cones.
//!
//! A blind hole with N sides in a block comes out as N walls and a floor, each the block with one more halfspace; a
//! countersink adds a halfspace to each wall and no piece, since wall and countersink meet in a convex edge of the
//! material. A counterbore has a concave edge and needs N more pieces.

mod body;
mod bvh;
mod cell;
mod coarsen;
mod cone;
mod cover;
mod crossing;
mod curved;
mod curved_surface;
mod decide;
mod deviation;
mod edges;
mod elements;
mod error;
mod faces;
mod facets;
mod facing;
mod foreign;
mod gap;
mod geometry;
mod hull;
mod joining;
mod loose;
mod mass;
mod merge;
mod nearest;
mod obj;
mod outward;
mod partition;
mod passing;
mod planes;
mod precision;
mod primitives;
mod read;
mod repair;
mod separation;
mod set_cover;
mod settings;
mod shells;
mod solid;
mod stl;
mod strips;
mod superfluous;
mod surface;
mod text;
mod touch;
mod triangulate;
mod weld;
mod winding;

pub use cover::{Cover, Piece};
pub use curved_surface::{CurvedKind, CurvedSurface};
pub use deviation::Deviation;
pub use error::MeshError;
pub use facing::Place;
pub use gap::Gauge;
pub use hull::hull_triangles;
pub use mass::MassProperties;
pub use passing::{Budget, Passage};
pub use read::{Format, TriangleMesh};
pub use separation::{Penetration, Separation};
pub use settings::CoverSettings;
pub use solid::Solid;
pub use surface::Repair;

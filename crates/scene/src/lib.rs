//! Reads scene and homotopy files into a validated assembly problem.
//!
//! [`Scene::load`] reads what an engineer writes: parts, poses, stiffness, offsets. A scene that is returned is valid:
//! every number lies in the range that [`keys`] declares. An error names file, line, column and key, and says what
//! would be valid. [`Scene::task`] returns the planning task of one start and offset magnitude, [`load_homotopy`] reads
//! how to solve it, and [`resolved`] writes both into one file that reproduces the run. [`scene_schema`] and
//! [`homotopy_schema`] are JSON schemas of the files.

mod boxes;
mod carried;
mod chosen;
mod entry;
mod error;
mod facets;
mod file;
mod homotopy;
mod inertia;
mod ipopt;
mod keys;
mod known_meshes;
mod limits;
mod material;
mod mesh;
mod model;
mod motion_region;
mod pairs;
mod parse;
mod part;
mod plain_words;
mod pose;
mod range;
mod resolved;
mod robot;
mod scene;
mod schema;
mod sections;
mod shapes;
mod table;
mod task_error;
mod touching;
mod warnings;
mod words;

pub use carried::{Carried, CarriedShapes, Carrier};
pub use chosen::{duration, horizon, rotational_stiffness, translational_stiffness};
pub use error::{SceneError, Source};
pub use facets::{Fit, SHARE};
pub use file::read_text;
pub use homotopy::{default_homotopy, load_homotopy, parse_homotopy};
pub use keys::{Absent, Key, MAX_CONTACT_FORCES, MAX_NAME_LENGTH, SCALES, UNITS, Values, key, keys};
pub use known_meshes::KnownMeshes;
pub use limits::OutOfReach;
pub use mesh::MeshPart;
pub use model::triangles_of_link;
pub use motion_region::MotionRegion;
pub use part::Part;
pub use pose::StartPose;
pub use range::{Range, short};
pub use resolved::{resolved, resolved_settings, resolved_world};
pub use robot::{LARGEST_FORCE, Robot};
pub use scene::{RobustnessSpec, Scene};
pub use schema::{homotopy_schema, scene_schema};
pub use task_error::TaskError;
pub use touching::Gap;
pub use warnings::USUAL_SIZES;

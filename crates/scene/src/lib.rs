//! Scene and homotopy files to a validated assembly problem.
//!
//! [`Scene::load`] reads what an engineer writes: parts, poses, stiffnesses, offsets. Everything is checked before
//! anything is computed, and an error names file, line, column, key and what would be right. [`Scene::task`] is the
//! planning task of one start and offset magnitude; [`load_homotopy`] reads the settings of its solution;
//! [`resolved`] writes both as one file that reproduces the run.

mod document;
mod error;
mod file;
mod homotopy;
mod ipopt;
mod keys;
mod limits;
mod mesh;
mod part;
mod plain_words;
mod pose;
mod range;
mod reader;
mod resolved;
mod scene;
mod sections;
mod task_error;
mod warnings;

pub use error::{SceneError, Source};
pub use file::read_text;
pub use homotopy::{default_homotopy, load_homotopy, parse_homotopy};
pub use keys::{Absent, Key, MAX_CONTACT_FORCES, MAX_NAME_LENGTH, Range, Values, keys};
pub use limits::OutOfReach;
pub use part::Part;
pub use resolved::resolved;
pub use scene::{Scene, StartPose};
pub use task_error::TaskError;

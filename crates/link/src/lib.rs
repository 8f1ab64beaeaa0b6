//! Collision shapes of links in SDF, URDF and MJCF files.
//!
//! [`Model::parse`] reads the text of a file and tells the formats apart by their root element, [`Model::links`] lists what
//! has collision shapes, and [`Link::shapes`] returns them in the frame of the link. Lengths are metres, as the formats
//! want them. What a format allows and is not read here is an error with its place ([`ModelError`]): nothing that belongs
//! to a link is left out without a word. Elements that are only seen (visuals, geoms that collide with nothing) are no
//! collision shapes.
//!
//! | format | root | link | shape | pose |
//! |---|---|---|---|---|
//! | SDF | `sdf` | `link`, of a nested model `model::link` | `collision` | `pose`: Euler angles or quaternion |
//! | URDF | `robot` | `link` | `collision` | `origin`: fixed-axis angles |
//! | MJCF | `mujoco` | `body`, or `world` | `geom` | `pos` with one of five orientations, `fromto`; within `frame` |

mod element;
mod error;
mod mesh_file;
mod mjcf;
mod model;
mod sdf;
mod shape;
mod urdf;

pub use error::ModelError;
pub use model::{Link, Model};
pub use shape::{Geometry, LinkShape};

//! Collision shapes of links in files of simulators.

mod mjcf;
mod sdf;
mod support;
mod urdf;

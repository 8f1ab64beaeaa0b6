//! Meshes: files, repair, and the polytopes that contain them.

mod cover;
mod primitives;
mod properties;
mod reading;
mod recognise;
mod repair;
mod shapes;
mod touching;

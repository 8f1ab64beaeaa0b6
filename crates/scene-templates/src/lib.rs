//! Scenes to start from, as commented text: [pegs](Peg) of all kinds in their holes, and [starters](starter_scene) from two files.

mod draft;
mod generate;
mod starter;

pub use generate::{Peg, PegError, PegKey, PegSection};
pub use starter::{Axis, BoundingBox, FilePair, FilePart, PartPair, StarterPoses, StarterValues, starter_scene};

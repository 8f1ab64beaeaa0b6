//! Arms: files, kinematics, dynamics, gains.

mod files;
mod gains;
mod motions;
mod mujoco;
mod properties;
mod record;

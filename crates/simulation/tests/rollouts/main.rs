//! Rollouts in small worlds.

mod physics;
mod properties;
mod refinement;
mod world;

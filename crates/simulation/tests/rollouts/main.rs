//! Rollouts in small worlds.

mod absurd;
mod physics;
mod properties;
mod refinement;
mod trajectories;
mod world;

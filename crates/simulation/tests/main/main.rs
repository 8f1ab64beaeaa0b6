//! Rollouts in small worlds.

mod absurd;
mod arms;
mod convergence;
mod joint_ranges;
mod physics;
mod properties;
mod refinement;
mod strokes;
mod trajectories;
mod world;

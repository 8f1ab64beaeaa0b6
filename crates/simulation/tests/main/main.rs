//! Rollouts in small worlds.

mod absurd;
mod arms;
mod convergence;
mod final_oscillation;
mod joint_ranges;
mod physics;
mod position_robots;
mod properties;
mod refinement;
mod trajectories;
mod world;

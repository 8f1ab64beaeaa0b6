//! Robust contact-implicit optimal control: dynamics, transcription, homotopy.

mod task;

pub use task::{AssemblyTask, ContactPair, CostWeights, Horizon, Impedance, Inertia, TrajectoryCost};

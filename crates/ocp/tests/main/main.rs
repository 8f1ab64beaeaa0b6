//! The nonlinear program of a task, and its homotopy.

mod derivatives;
mod errors;
mod friction;
mod guess;
mod linear_solver;
mod near_pairs;
mod new_terms;
mod reference_vectors;
mod residuals;
mod sensitivities;
mod similarity;
mod threads;

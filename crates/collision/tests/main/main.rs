//! Distances and shapes of polytopes.

mod bits;
mod flat_vertices;
mod hard_cases;
mod hulls;
mod polytopes;
mod properties;
mod reference_vectors;
mod shapes;

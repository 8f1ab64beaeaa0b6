//! Factorisations: inertia, accuracy and fallbacks.

mod fallback;
mod inertia;
mod support;

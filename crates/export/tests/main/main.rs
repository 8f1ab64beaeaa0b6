//! What robots read of plans.

mod frames;
mod trajectory;

//! Tapes, their derivatives and batches.

mod batches;
mod derivatives;
mod random;
mod recording;
mod support;

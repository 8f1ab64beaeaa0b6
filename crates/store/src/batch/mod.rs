//! Every start, offset magnitude and homotopy of some scenes.
//!
//! [`expand`] turns a [`Matrix`] into the cells of an immutable [`Manifest`]. Each cell is solved into a folder of its
//! own, named after its problem. The files are the only state: a cell is finished when its plan is whole, and running
//! while a process holds the lock on its log ([`CellState`]). So any number of runs, on one machine or many, share one
//! folder, and each can be killed at any moment and started again. [`collect`] makes one table of all cells.

pub mod cells;
mod expand;
mod matrix;
mod state;

pub use cells::collect;
pub use expand::expand;
pub use matrix::{Matrix, Starts};
pub use state::{CellFiles, CellState};

pub use crate::{Cell, Manifest};

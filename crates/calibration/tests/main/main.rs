//! Fits to logs: those that rollouts have written, and those of an arm in MuJoCo.

mod recorded;
mod support;
mod synthetic;

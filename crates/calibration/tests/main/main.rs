//! Fits to logs: those that rollouts have written, and those of an arm in MuJoCo.

mod commanded;
mod recorded;
mod small_robot;
mod support;
mod synthetic;

//! Solves by Ipopt, with its own linear solver and with another.

mod own_solver;
mod solve;
mod support;

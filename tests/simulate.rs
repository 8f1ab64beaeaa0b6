//! The simulation as a user runs it.

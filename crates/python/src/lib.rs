//! The module `assembly_plan._planner`: the planner and the command line for the Python package around it.
//!
//! Nothing here is meant for users. The package `assembly_plan` has the classes, their documentation and their types;
//! `_planner.pyi` has the types of this module. Motions go to Python as bytes of numbers, which NumPy takes as they are,
//! everything else as JSON or CSV text, as the planner's own files have it.
//!
//! Long work runs in a thread of its own: the interpreter goes on meanwhile, hears of events and can interrupt.

mod background;
mod command;
mod errors;
mod motion;
mod options;
mod plan;
mod scene;
mod simulation;

use pyo3::pymodule;

/// The native part of `assembly_plan`.
#[pymodule]
mod _planner {
    #[pymodule_export]
    use crate::command::run_command;
    #[pymodule_export]
    use crate::plan::Plan;
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::simulation::Simulation;
}

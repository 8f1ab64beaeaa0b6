//! The module `assembly_plan._planner`: the planner and the command line for the Python package around it.
//!
//! Users do not use it directly. The package `assembly_plan` has the classes, their documentation and their types;
//! `_planner.pyi` has the types of this module. Motions go to Python as bytes of numbers for NumPy, everything else as
//! JSON or CSV text, in the format of the planner's files.
//!
//! Long work runs in a thread of its own: meanwhile the interpreter keeps running, receives events and can interrupt.

mod arm;
mod arrays;
mod background;
mod calibration;
mod command;
mod contacts;
mod errors;
mod motion;
mod options;
mod outputs;
mod plan;
mod reference;
mod scene;
mod simulation;
mod tolerance;

use pyo3::pymodule;

/// The native part of `assembly_plan`.
#[pymodule]
mod _planner {
    #[pymodule_export]
    use crate::arm::Arm;
    #[pymodule_export]
    use crate::command::run_command;
    #[pymodule_export]
    use crate::outputs::{figures, write_animation, write_export, write_page};
    #[pymodule_export]
    use crate::plan::Plan;
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::simulation::Simulation;
}

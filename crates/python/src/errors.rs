//! Errors of the planner as exceptions of the package.

use planner::{Fault, PlannerError};
use pyo3::{PyErr, import_exception};

mod raised {
    use super::import_exception;

    import_exception!(assembly_plan.errors, PlannerError);
    import_exception!(assembly_plan.errors, SceneError);
    import_exception!(assembly_plan.errors, NoPlanError);
    import_exception!(assembly_plan.errors, SceneWarning);
}

pub use raised::SceneWarning;

/// The exception of an error, with the message that the command line shows.
pub fn exception(error: &PlannerError) -> PyErr {
    let message = error.to_string();
    match error.fault() {
        Fault::Input => raised::SceneError::new_err(message),
        Fault::NoPlan => raised::NoPlanError::new_err(message),
        Fault::System => raised::PlannerError::new_err(message),
    }
}

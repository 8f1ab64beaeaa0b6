//! Motions as bytes of numbers.

use planner::files::MotionTables;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Numbers of a motion, in native byte order. The shapes follow from steps, scenarios and pairs.
#[derive(IntoPyObject)]
pub struct Motion<'py> {
    time_step: f64,
    steps: usize,
    scenarios: usize,
    pairs: Vec<String>,
    reference: Bound<'py, PyBytes>,
    states: Bound<'py, PyBytes>,
    wrenches: Bound<'py, PyBytes>,
    distances: Bound<'py, PyBytes>,
    forces: Bound<'py, PyBytes>,
}

impl<'py> Motion<'py> {
    /// From some tables.
    pub fn new(py: Python<'py>, tables: &MotionTables) -> Self {
        let MotionTables { time_step, reference, pairs, scenarios } = tables;
        let contacts = || scenarios.iter().flat_map(|scenario| scenario.contacts.iter().flatten());
        Self {
            time_step: *time_step,
            steps: reference.len() - 1,
            scenarios: scenarios.len(),
            pairs: pairs.clone(),
            reference: bytes(py, reference.iter().flat_map(|state| state.0)),
            states: bytes(py, scenarios.iter().flat_map(|scenario| &scenario.states).flat_map(|state| state.0)),
            wrenches: bytes(py, scenarios.iter().flat_map(|scenario| &scenario.wrenches).flat_map(|wrench| wrench.0)),
            distances: bytes(py, contacts().map(|contact| contact.distance)),
            forces: bytes(py, contacts().map(|contact| contact.force)),
        }
    }
}

fn bytes(py: Python, numbers: impl Iterator<Item = f64>) -> Bound<PyBytes> {
    PyBytes::new(py, &numbers.flat_map(f64::to_ne_bytes).collect::<Vec<u8>>())
}

//! Motions as bytes of numbers.

use planner::files::MotionTables;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::arrays::bytes;

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
    ///
    /// # Errors
    /// When there is no memory for them.
    pub fn new(py: Python<'py>, tables: &MotionTables) -> PyResult<Self> {
        let MotionTables { time_step, reference, pairs, scenarios } = tables;
        let contacts = || scenarios.iter().flat_map(|scenario| scenario.contacts.iter().flatten());
        let numbers = |numbers: Vec<f64>| bytes(py, &numbers);
        Ok(Self {
            time_step: *time_step,
            steps: reference.len() - 1,
            scenarios: scenarios.len(),
            pairs: pairs.clone(),
            reference: numbers(reference.iter().flat_map(|state| state.0).collect())?,
            states: numbers(
                scenarios.iter().flat_map(|scenario| &scenario.states).flat_map(|state| state.0).collect(),
            )?,
            wrenches: numbers(
                scenarios.iter().flat_map(|scenario| &scenario.wrenches).flat_map(|wrench| wrench.0).collect(),
            )?,
            distances: numbers(contacts().map(|contact| contact.distance).collect())?,
            forces: numbers(contacts().map(|contact| contact.force).collect())?,
        })
    }
}

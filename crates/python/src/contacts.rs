//! Contact information of many poses, by the batch kernels.

use collision::{DistanceError, Solutions};
use planner::PlannerError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use task::{ContactPair, POSE};

use crate::arrays::bytes;

/// Components of the contact information without and with the contact point.
const CONTACT: usize = 7;
const WITH_POINT: usize = 10;

/// What is asked of many poses.
#[derive(Debug, Clone, Copy)]
pub struct Question {
    pub tau: f64,
    /// Order of the derivatives: 0, 1 or 2.
    pub derivatives: usize,
    /// Whether contact points are included.
    pub points: bool,
}

/// Numbers of P pairs at K poses, with C components each.
#[derive(Default)]
pub struct Numbers {
    /// Shape (P, K, C).
    values: Vec<f64>,
    /// Shape (P, K, C, 7), or empty.
    jacobians: Vec<f64>,
    /// Shape (P, C, K, 7, 7), or empty.
    hessians: Vec<f64>,
}

/// As Python has them.
#[derive(IntoPyObject)]
pub struct Contacts<'py> {
    pairs: Vec<String>,
    components: usize,
    values: Bound<'py, PyBytes>,
    jacobians: Bound<'py, PyBytes>,
    hessians: Bound<'py, PyBytes>,
}

impl<'py> Contacts<'py> {
    /// Of some pairs.
    ///
    /// # Errors
    /// When there is no memory for them.
    pub fn new(py: Python<'py>, pairs: Vec<String>, question: Question, numbers: &Numbers) -> PyResult<Self> {
        Ok(Self {
            pairs,
            components: if question.points { WITH_POINT } else { CONTACT },
            values: bytes(py, &numbers.values)?,
            jacobians: bytes(py, &numbers.jacobians)?,
            hessians: bytes(py, &numbers.hessians)?,
        })
    }
}

/// The answer for some pairs and poses, whose quaternions may be of any norm.
///
/// # Errors
/// When a distance cannot be computed.
pub fn answer(pairs: &[ContactPair], poses: &[[f64; POSE]], question: Question) -> Result<Numbers, PlannerError> {
    if !(1e-9..=1.0).contains(&question.tau) {
        return Err(PlannerError::value("tau", question.tau, "must lie between 1e-9 and 1"));
    }
    let mut numbers = Numbers::default();
    for pair in pairs {
        let evaluated = match question.points {
            true => numbers.add::<WITH_POINT>(pair, poses, question),
            false => numbers.add::<CONTACT>(pair, poses, question),
        };
        evaluated.map_err(|source| PlannerError::Distance { pair: pair.to_string(), source })?;
    }
    Ok(numbers)
}

impl Numbers {
    fn add<const COMPONENTS: usize>(
        &mut self,
        pair: &ContactPair,
        poses: &[[f64; POSE]],
        question: Question,
    ) -> Result<(), DistanceError> {
        // Derivatives take the solutions of the values.
        let (shapes, tau, mut solutions) = (&pair.shapes, question.tau, Solutions::default());
        let mut values = vec![[0.0; COMPONENTS]; poses.len()];
        if question.derivatives == 0 {
            shapes.contacts(poses, tau, &mut solutions, &mut values)?;
        } else {
            let mut jacobians = vec![[[0.0; POSE]; COMPONENTS]; poses.len()];
            shapes.contact_jacobians(poses, tau, &mut solutions, &mut values, &mut jacobians)?;
            self.jacobians.extend_from_slice(jacobians.as_flattened().as_flattened());
        }
        self.values.extend_from_slice(values.as_flattened());
        let components = if question.derivatives == 2 { COMPONENTS } else { 0 };
        let mut hessians = vec![[[0.0; POSE]; POSE]; poses.len()];
        for component in 0..components {
            let mut seed = [0.0; COMPONENTS];
            seed[component] = 1.0;
            shapes.contact_hessians(poses, tau, &vec![seed; poses.len()], &mut solutions, &mut hessians)?;
            self.hessians.extend_from_slice(hessians.as_flattened().as_flattened());
        }
        Ok(())
    }
}

/// Contact points (m, world frame) of some pairs at poses, of distances smoothed by `tau`: shape (K, P, 3), not numbers
/// without one.
pub fn points(pairs: &[ContactPair], poses: &[[f64; POSE]], tau: f64) -> Vec<f64> {
    let of_pair = |pair: &ContactPair| {
        let mut values = vec![[f64::NAN; WITH_POINT]; poses.len()];
        if pair.shapes.contacts(poses, tau, &mut Solutions::default(), &mut values).is_err() {
            // One that cannot be computed spoils the whole batch.
            for (pose, value) in poses.iter().zip(&mut values) {
                let found = pair.shapes.contacts(
                    std::slice::from_ref(pose),
                    tau,
                    &mut Solutions::default(),
                    std::slice::from_mut(value),
                );
                *value = found.map_or([f64::NAN; WITH_POINT], |()| *value);
            }
        }
        values
    };
    let values: Vec<_> = pairs.iter().map(of_pair).collect();
    let point = |pose: usize| values.iter().flat_map(move |values| values[pose][CONTACT..].to_vec());
    (0..poses.len()).flat_map(point).collect()
}

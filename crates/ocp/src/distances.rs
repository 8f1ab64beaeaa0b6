//! Contact information of every pair at every pose of the problem, evaluated in one batch per point and cached.

use std::time::{Duration, Instant};

use nlp::EvaluationError;
use task::{ContactPair, POSE};

use crate::layout::{CONTACT, Layout};

/// What has been evaluated at the current poses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Evaluated {
    Nothing,
    Values,
    Jacobians,
}

/// `W = (Phi_tau, n~_tau)` and its derivatives, per pair and pose; poses are those before each step, so that pose
/// `index = (stage - 1) n_s + scenario` belongs to the step that leads to `stage`.
pub struct Distances {
    pairs: Vec<ContactPair>,
    layout: Layout,
    tau: f64,
    poses: Vec<[f64; POSE]>,
    evaluated: Evaluated,
    values: Vec<Vec<[f64; CONTACT]>>,
    jacobians: Vec<Vec<[[f64; POSE]; CONTACT]>>,
    hessians: Vec<Vec<[[f64; POSE]; POSE]>>,
    elapsed: Duration,
}

impl Distances {
    /// `initial_poses` are the compliant start poses, one per scenario.
    pub fn new(pairs: &[ContactPair], layout: Layout, initial_poses: &[[f64; POSE]]) -> Self {
        let count = layout.steps * layout.scenarios;
        let mut poses = vec![[0.0; POSE]; count];
        poses[..layout.scenarios].copy_from_slice(initial_poses);
        Self {
            pairs: pairs.to_vec(),
            layout,
            tau: f64::NAN,
            poses,
            evaluated: Evaluated::Nothing,
            values: vec![vec![[0.0; CONTACT]; count]; pairs.len()],
            jacobians: vec![vec![[[0.0; POSE]; CONTACT]; count]; pairs.len()],
            hessians: vec![vec![[[0.0; POSE]; POSE]; count]; pairs.len()],
            elapsed: Duration::ZERO,
        }
    }

    /// Smoothing parameter of all distances (Eq. KKTsystem).
    pub fn set_tau(&mut self, tau: f64) {
        self.tau = tau;
        self.evaluated = Evaluated::Nothing;
    }

    /// Takes the compliant poses from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        for (stage, scenario) in self.layout.stages_and_scenarios().skip(self.layout.scenarios) {
            let start = self.layout.compliant(stage - 1, scenario);
            let index = (stage - 1) * self.layout.scenarios + scenario;
            self.poses[index].copy_from_slice(&x[start..start + POSE]);
        }
        self.evaluated = Evaluated::Nothing;
    }

    /// Contact information per (pair, pose).
    pub fn values(&mut self) -> Result<&[Vec<[f64; CONTACT]>], EvaluationError> {
        if self.evaluated < Evaluated::Values {
            let begin = Instant::now();
            for (index, pair) in self.pairs.iter().enumerate() {
                pair.shapes
                    .contacts(&self.poses, self.tau, &mut self.values[index])
                    .map_err(|error| self.describe(index, &error))?;
            }
            self.evaluated = Evaluated::Values;
            self.elapsed += begin.elapsed();
        }
        Ok(&self.values)
    }

    /// `DW` per (pair, pose); afterwards [`Distances::values`] costs nothing.
    pub fn jacobians(&mut self) -> Result<&[Vec<[[f64; POSE]; CONTACT]>], EvaluationError> {
        if self.evaluated < Evaluated::Jacobians {
            let begin = Instant::now();
            for (index, pair) in self.pairs.iter().enumerate() {
                pair.shapes
                    .contact_jacobians(&self.poses, self.tau, &mut self.values[index], &mut self.jacobians[index])
                    .map_err(|error| self.describe(index, &error))?;
            }
            self.evaluated = Evaluated::Jacobians;
            self.elapsed += begin.elapsed();
        }
        Ok(&self.jacobians)
    }

    /// `<s, D2W>` per (pair, pose) for seeds per (pair, pose); values and Jacobians are evaluated on the way.
    pub fn hessians(&mut self, seeds: &[Vec<[f64; CONTACT]>]) -> Result<&[Vec<[[f64; POSE]; POSE]>], EvaluationError> {
        let begin = Instant::now();
        for (index, pair) in self.pairs.iter().enumerate() {
            pair.shapes
                .contact_hessians(
                    &self.poses,
                    self.tau,
                    &seeds[index],
                    &mut self.values[index],
                    &mut self.jacobians[index],
                    &mut self.hessians[index],
                )
                .map_err(|error| self.describe(index, &error))?;
        }
        self.evaluated = Evaluated::Jacobians;
        self.elapsed += begin.elapsed();
        Ok(&self.hessians)
    }

    /// Wall seconds spent here since the last reset.
    pub fn seconds(&self) -> f64 {
        self.elapsed.as_secs_f64()
    }

    /// Starts counting [`Distances::seconds`] anew.
    pub fn reset_seconds(&mut self) {
        self.elapsed = Duration::ZERO;
    }

    /// `DW` as last evaluated by [`Distances::jacobians`] or [`Distances::hessians`].
    pub fn last_jacobians(&self) -> &[Vec<[[f64; POSE]; CONTACT]>] {
        &self.jacobians
    }

    fn describe(&self, pair: usize, error: &collision::DistanceError) -> EvaluationError {
        let (step, scenario) = (error.index / self.layout.scenarios, error.index % self.layout.scenarios);
        let ContactPair { body, environment, .. } = &self.pairs[pair];
        EvaluationError(format!(
            "distance of {body} and {environment}, scenario {}, step {step}, did not converge: {error}",
            scenario + 1
        ))
    }
}

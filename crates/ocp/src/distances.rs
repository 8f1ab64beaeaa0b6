//! Contact information of every pair at every pose of the problem, evaluated in batches and cached.

use std::ops::{ControlFlow, Range};
use std::time::{Duration, Instant};

use collision::Solutions;
use nlp::EvaluationError;
use task::{AssemblyTask, ContactPair, POSE};
use workers::Workers;

use crate::layout::{CONTACT, CONTACT_AND_POINT, Layout};
use crate::pattern::{ABSENT, PatternBuilder, add};
use crate::point::{Point, Points};

/// Poses of a pair that are evaluated as one piece of work, whole groups of lanes in every instruction set.
const CHUNK: usize = 64;

/// A distance that could not be computed; the reason of an [`EvaluationError`] of a transcription.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("no distance between {body} and {environment} in scenario {} at step {step}: {source}", scenario + 1)]
pub struct MissingDistance {
    /// Name of the part of the moved body.
    pub body: String,
    /// Name of the part of the environment.
    pub environment: String,
    /// Scenario, from 0.
    pub scenario: usize,
    /// Step that starts at the pose, from 0.
    pub step: usize,
    /// Error of the collision kernel.
    pub source: collision::DistanceError,
}

/// Quantities that have been evaluated at the current poses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Evaluated {
    Nothing,
    Values,
    Jacobians,
}

/// `W = (Phi_tau, n~_tau)` and its derivatives at every point of [`Points::Pairs`], with the contact point `p` where a term
/// asks for it: `W = (Phi_tau, n~_tau, p)`. Poses are those before each step.
pub struct Distances {
    pairs: Vec<ContactPair>,
    points: Vec<Point>,
    /// Chunks of points, pair by pair.
    chunks: Vec<Range<usize>>,
    tau: f64,
    /// Pose of every point.
    poses: Vec<[f64; POSE]>,
    /// Variables of the pose of every point, [`ABSENT`] for initial poses.
    variables: Vec<[u32; POSE]>,
    evaluated: Evaluated,
    /// Number of components of `W`: [`CONTACT`] or [`CONTACT_AND_POINT`].
    components: usize,
    /// `W`, point by point.
    values: Vec<f64>,
    /// Rows of `DW`, point by point.
    jacobians: Vec<[f64; POSE]>,
    hessians: Vec<[[f64; POSE]; POSE]>,
    /// Adjoints of `W`, point by point, summed over all terms.
    seeds: Vec<f64>,
    /// Of every chunk.
    solutions: Vec<Solutions>,
    /// Hessian entries (coordinate, coordinate) per point.
    curvature_slots: Vec<[[u32; POSE]; POSE]>,
    workers: Workers,
    elapsed: Duration,
}

/// Points of a pair that are evaluated together, with a slice of a result per point.
struct Chunk<'all, T> {
    pair: usize,
    poses: &'all [[f64; POSE]],
    solutions: &'all mut Solutions,
    results: &'all mut [T],
}

impl Distances {
    /// `initial_poses` are the compliant poses at the start, one per scenario.
    pub fn new(task: &AssemblyTask, layout: &Layout, initial_poses: &[[f64; POSE]]) -> Self {
        let points = layout.points(Points::Pairs);
        let variables = |point: &Point| match point.stage {
            1 => [ABSENT; POSE],
            stage => {
                let start = layout.state(stage - 1, point.owner);
                std::array::from_fn(|coordinate| (start + coordinate) as u32)
            }
        };
        let mut chunks = Vec::new();
        let mut start = 0;
        for of_pair in points.chunk_by(|one, other| one.pair == other.pair) {
            let end = start + of_pair.len();
            chunks.extend((start..end).step_by(CHUNK).map(|first| first..end.min(first + CHUNK)));
            start = end;
        }
        let count = points.len();
        Self {
            pairs: task.pairs.clone(),
            tau: f64::NAN,
            poses: points.iter().map(|point| initial_poses[point.scenario()]).collect(),
            variables: points.iter().map(variables).collect(),
            evaluated: Evaluated::Nothing,
            components: CONTACT,
            values: vec![0.0; CONTACT * count],
            jacobians: vec![[0.0; POSE]; CONTACT * count],
            hessians: vec![[[0.0; POSE]; POSE]; count],
            seeds: vec![0.0; CONTACT * count],
            solutions: vec![Solutions::default(); chunks.len()],
            curvature_slots: vec![[[ABSENT; POSE]; POSE]; count],
            workers: Workers::default(),
            elapsed: Duration::ZERO,
            points,
            chunks,
        }
    }

    /// Evaluates with these threads.
    pub fn set_workers(&mut self, workers: Workers) {
        self.workers = workers;
    }

    /// Variables of the pose before the step of a point; [`ABSENT`] if that is an initial pose.
    pub fn pose_variables(&self, point: usize) -> [u32; POSE] {
        self.variables[point]
    }

    /// Adds the entries of `<s, D2W>` at a point to the pattern. Every term that uses the contact information of the
    /// point calls this.
    pub fn reserve_curvature(&mut self, point: usize, hessian: &mut PatternBuilder) {
        let pose = self.pose_variables(point);
        self.curvature_slots[point] = pose.map(|row| pose.map(|column| hessian.symmetric_slot(row, column)));
    }

    /// Makes a component of `W` available. Contact points are computed only where a term asks for one.
    pub fn require(&mut self, component: usize) {
        if component >= self.components {
            self.components = CONTACT_AND_POINT;
            let count = self.components * self.hessians.len();
            self.values.resize(count, 0.0);
            self.jacobians.resize(count, [0.0; POSE]);
            self.seeds.resize(count, 0.0);
        }
    }

    /// Smoothing parameter of all distances (Eq. KKTsystem).
    pub fn set_tau(&mut self, tau: f64) {
        self.tau = tau;
        self.evaluated = Evaluated::Nothing;
    }

    /// Takes the compliant poses from `x`.
    pub fn set_point(&mut self, x: &[f64]) {
        for (pose, variables) in self.poses.iter_mut().zip(&self.variables).filter(|(_, of)| of[0] != ABSENT) {
            let start = variables[0] as usize;
            pose.copy_from_slice(&x[start..start + POSE]);
        }
        self.evaluated = Evaluated::Nothing;
    }

    /// Evaluates `W` unless it is up to date.
    pub fn evaluate(&mut self) -> Result<(), EvaluationError> {
        if self.evaluated >= Evaluated::Values {
            return Ok(());
        }
        match self.components {
            CONTACT => self.evaluate_components::<CONTACT>(),
            _ => self.evaluate_components::<CONTACT_AND_POINT>(),
        }
    }

    fn evaluate_components<const COMPONENTS: usize>(&mut self) -> Result<(), EvaluationError> {
        let begin = Instant::now();
        let (pairs, tau) = (&self.pairs, self.tau);
        let values = in_chunks(records::<_, COMPONENTS>(&mut self.values), &self.chunks);
        let chunks = chunks(&self.points, &self.poses, &self.chunks, &mut self.solutions, values);
        let failure = in_parallel(&self.workers, chunks, |chunk| {
            pairs[chunk.pair].shapes.contacts(chunk.poses, tau, chunk.solutions, chunk.results)
        });
        self.finish(begin, failure, Evaluated::Values)
    }

    /// Evaluates `W` and `DW` unless they are up to date.
    pub fn evaluate_jacobians(&mut self) -> Result<(), EvaluationError> {
        if self.evaluated >= Evaluated::Jacobians {
            return Ok(());
        }
        match self.components {
            CONTACT => self.evaluate_jacobians_of_components::<CONTACT>(),
            _ => self.evaluate_jacobians_of_components::<CONTACT_AND_POINT>(),
        }
    }

    fn evaluate_jacobians_of_components<const COMPONENTS: usize>(&mut self) -> Result<(), EvaluationError> {
        let begin = Instant::now();
        let (pairs, tau) = (&self.pairs, self.tau);
        let jacobians = in_chunks(records::<_, COMPONENTS>(&mut self.jacobians), &self.chunks);
        let values = in_chunks(records::<_, COMPONENTS>(&mut self.values), &self.chunks);
        let chunks = chunks(&self.points, &self.poses, &self.chunks, &mut self.solutions, values).zip(jacobians);
        let failure = in_parallel(&self.workers, chunks, |(chunk, jacobians)| {
            let shapes = &pairs[chunk.pair].shapes;
            shapes.contact_jacobians(chunk.poses, tau, chunk.solutions, chunk.results, jacobians)
        });
        self.finish(begin, failure, Evaluated::Jacobians)
    }

    /// Evaluates `<s, D2W>` for the seeds `s`.
    pub fn evaluate_hessians(&mut self) -> Result<(), EvaluationError> {
        match self.components {
            CONTACT => self.evaluate_hessians_of_components::<CONTACT>(),
            _ => self.evaluate_hessians_of_components::<CONTACT_AND_POINT>(),
        }
    }

    fn evaluate_hessians_of_components<const COMPONENTS: usize>(&mut self) -> Result<(), EvaluationError> {
        let begin = Instant::now();
        let (pairs, tau) = (&self.pairs, self.tau);
        let seeds = in_chunks(records::<_, COMPONENTS>(&mut self.seeds), &self.chunks);
        let hessians = in_chunks(&mut self.hessians, &self.chunks);
        let chunks = chunks(&self.points, &self.poses, &self.chunks, &mut self.solutions, hessians).zip(seeds);
        let failure = in_parallel(&self.workers, chunks, |(chunk, seeds)| {
            let shapes = &pairs[chunk.pair].shapes;
            shapes.contact_hessians(chunk.poses, tau, seeds, chunk.solutions, chunk.results)
        });
        self.finish(begin, failure, self.evaluated)
    }

    /// A component of `W` per point, as last evaluated.
    pub fn last_values(&self, component: usize) -> impl Iterator<Item = f64> {
        self.values.iter().skip(component).step_by(self.components).copied()
    }

    /// `DW` per point as last evaluated, its rows one after the other.
    pub fn last_jacobians(&self) -> std::slice::ChunksExact<'_, [f64; POSE]> {
        self.jacobians.chunks_exact(self.components)
    }

    /// Sets all seeds to zero.
    pub fn clear_seeds(&mut self) {
        self.seeds.fill(0.0);
    }

    /// Adds to a component of all seeds, one value per point.
    pub fn add_seeds(&mut self, component: usize, adjoint: &[f64]) {
        let seeds = self.seeds.iter_mut().skip(component).step_by(self.components);
        for (seed, &value) in seeds.zip(adjoint) {
            *seed += value;
        }
    }

    /// Adds `<s, D2W>` as last evaluated to the slots of the Hessian (Eq. secondderw).
    pub fn add_curvature(&self, slots: &mut [f64]) {
        for (hessian, targets) in self.hessians.iter().zip(&self.curvature_slots) {
            if targets[0][0] == ABSENT {
                continue;
            }
            for row in 0..POSE {
                for column in 0..=row {
                    add(slots, targets[row][column], hessian[row][column]);
                }
            }
        }
    }

    /// Adds second derivatives by two components of `W`, one value per point, times the gradients of both.
    pub fn add_products(&self, values: &[f64], one: usize, other: usize, slots: &mut [f64]) {
        for ((&value, derivative), targets) in values.iter().zip(self.last_jacobians()).zip(&self.curvature_slots) {
            let (left, right) = (&derivative[one], &derivative[other]);
            for row in 0..POSE {
                for column in 0..=row {
                    let mut product = left[row] * right[column];
                    if one != other {
                        product += left[column] * right[row];
                    }
                    add(slots, targets[row][column], value * product);
                }
            }
        }
    }

    /// Wall seconds in evaluations since the last reset.
    pub fn seconds(&self) -> f64 {
        self.elapsed.as_secs_f64()
    }

    /// Resets [`Distances::seconds`] to zero.
    pub fn reset_seconds(&mut self) {
        self.elapsed = Duration::ZERO;
    }

    fn finish(
        &mut self,
        begin: Instant,
        failure: Option<(usize, collision::DistanceError)>,
        evaluated: Evaluated,
    ) -> Result<(), EvaluationError> {
        self.elapsed += begin.elapsed();
        if let Some((chunk, error)) = failure {
            return Err(self.describe(chunk, error));
        }
        self.evaluated = evaluated;
        Ok(())
    }

    fn describe(&self, chunk: usize, mut source: collision::DistanceError) -> EvaluationError {
        source.index += self.chunks[chunk].start;
        let point = &self.points[source.index];
        let pair = &self.pairs[point.pair];
        let (body, environment) = (pair.body.clone(), pair.environment.clone());
        EvaluationError::new(MissingDistance {
            body,
            environment,
            scenario: point.scenario(),
            step: point.stage - 1,
            source,
        })
    }
}

/// One record per point.
fn records<T, const COMPONENTS: usize>(components: &mut [T]) -> &mut [[T; COMPONENTS]] {
    components.as_chunks_mut().0
}

/// Slices of a result, chunk by chunk.
fn in_chunks<'all, T>(mut results: &'all mut [T], chunks: &[Range<usize>]) -> impl Iterator<Item = &'all mut [T]> {
    chunks.iter().map(move |chunk| {
        let (slice, rest) = std::mem::take(&mut results).split_at_mut(chunk.len());
        results = rest;
        slice
    })
}

/// All chunks, with their slices of one of the results.
fn chunks<'all, T: 'all>(
    points: &'all [Point],
    poses: &'all [[f64; POSE]],
    chunks: &'all [Range<usize>],
    solutions: &'all mut [Solutions],
    results: impl Iterator<Item = &'all mut [T]>,
) -> impl Iterator<Item = Chunk<'all, T>> {
    chunks.iter().zip(solutions).zip(results).map(|((range, solutions), results)| Chunk {
        pair: points[range.start].pair,
        poses: &poses[range.clone()],
        solutions,
        results,
    })
}

/// Evaluates all chunks; number and error of the first that fails.
fn in_parallel<C: Send>(
    workers: &Workers,
    chunks: impl Iterator<Item = C>,
    evaluate: impl Fn(C) -> Result<(), collision::DistanceError> + Sync,
) -> Option<(usize, collision::DistanceError)> {
    let (mut next, mut failure) = (0, None);
    workers.in_order(chunks, evaluate, |result| match result {
        Ok(()) => {
            next += 1;
            ControlFlow::Continue(())
        }
        Err(error) => {
            failure = Some((next, error));
            ControlFlow::Break(())
        }
    });
    failure
}

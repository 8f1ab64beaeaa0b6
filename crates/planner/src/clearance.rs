//! Clearance of a body that moves without turning.

use nalgebra::Vector3;
use task::AssemblyTask;

/// Rounding of exact distances (m).
const ROUNDING: f64 = 1e-9;
/// Shortest step along a direction, as a share of the travel that is looked at.
const STEP: f64 = 1e-3;
/// Overlap that is rounding, likewise.
const TOUCHING: f64 = 1e-4;

/// Exact distances between the environment and the body, oriented as at its goal. A distance changes by no more than the
/// body moves, so that pairs far from each other are rarely computed: of hundreds of pairs, only the near ones cost time.
pub struct Clearance<'task> {
    task: &'task AssemblyTask,
    /// Where each pair was computed last, and its distance there (m).
    known: Vec<(Vector3<f64>, f64)>,
    nearest: usize,
}

impl<'task> Clearance<'task> {
    /// Of a task; every distance at its goal is computed.
    pub fn new(task: &'task AssemblyTask) -> Self {
        let goal = position(&task.goal);
        let mut clearance = Self { task, known: vec![(goal, f64::NEG_INFINITY); task.pairs.len()], nearest: 0 };
        clearance.at(&goal);
        clearance
    }

    /// Smallest distance of all pairs (m) with the body at a position, negative where parts overlap; infinite without
    /// pairs.
    pub fn at(&mut self, position: &Vector3<f64>) -> f64 {
        if self.known.is_empty() {
            return f64::INFINITY;
        }
        let mut least = self.compute(self.nearest, position);
        for pair in 0..self.known.len() {
            let (before, distance) = self.known[pair];
            if distance - (position - before).norm() - ROUNDING < least {
                let distance = self.compute(pair, position);
                if distance < least {
                    (least, self.nearest) = (distance, pair);
                }
            }
        }
        least
    }

    fn compute(&mut self, pair: usize, position: &Vector3<f64>) -> f64 {
        let mut pose = self.task.goal;
        pose[..3].copy_from_slice(position.as_slice());
        let distance = self.task.pairs[pair].shapes.exact_distance(&pose);
        // What cannot be computed counts as overlap.
        let distance = if distance.is_nan() { f64::NEG_INFINITY } else { distance };
        self.known[pair] = (*position, distance);
        distance
    }

    /// How far the body moves from a position along a unit vector until it touches something (m), if it does within the
    /// longest travel that is looked at. A body that overlaps something already moves until it overlaps deeper.
    pub fn travel(&mut self, from: &Vector3<f64>, direction: &Vector3<f64>, longest: f64) -> Option<f64> {
        let (mut travelled, mut clearance) = (0.0, self.at(from));
        let floor = clearance.min(0.0) - TOUCHING * longest;
        while travelled <= longest {
            let next = travelled + clearance.max(STEP * longest);
            let there = self.at(&(from + direction * next));
            if there < floor {
                return Some(travelled + clearance.max(0.0));
            }
            (travelled, clearance) = (next, there);
        }
        None
    }
}

/// Position of a pose (m).
pub fn position(pose: &[f64; 7]) -> Vector3<f64> {
    Vector3::new(pose[0], pose[1], pose[2])
}

//! Clearance of a body that moves without rotation.

use nalgebra::Vector3;
use task::{AssemblyTask, ContactPair, Pose};

/// Rounding of exact distances (m).
const ROUNDING: f64 = 1e-9;
/// Shortest step along a direction, as a share of the travel that is looked at.
const STEP: f64 = 1e-3;
/// Rounding of penetrations, in the same measure.
const TOUCHING: f64 = 1e-4;

/// Clearance between the environment and the body, oriented as at its goal. A distance changes by no more than the body
/// moves, so that pairs far from each other are rarely computed: of hundreds of pairs, only the near ones cost time.
pub struct Clearance<'task> {
    task: &'task AssemblyTask,
    pairs: Vec<Known>,
    nearest: usize,
}

/// Bounds on the distance of a pair.
struct Known {
    /// Box along the axes around the body's part at its goal, seen from the box around the environment's: lowest and highest
    /// distance between them along each axis (m), as the position of the body is added.
    boxes: [Vector3<f64>; 2],
    /// Position of the body at the last evaluation of the pair.
    at: Vector3<f64>,
    /// How far apart it was there (m), at least.
    distance: f64,
}

impl<'task> Clearance<'task> {
    /// For a task.
    pub fn new(task: &'task AssemblyTask) -> Self {
        let rotation = task.goal.orientation();
        let known = |pair: &ContactPair| {
            let [low, high] = bounds(pair.shapes.body().vertices(), |vertex| rotation * vertex);
            let [other_low, other_high] = bounds(pair.shapes.environment().vertices(), |vertex| vertex);
            let boxes = [low - other_high, other_low - high];
            Known { boxes, at: task.goal.position(), distance: f64::NEG_INFINITY }
        };
        Self { task, pairs: task.pairs.iter().map(known).collect(), nearest: 0 }
    }

    /// How far the body is from touching at a position (m): the smallest exact distance of all pairs whose boxes are not
    /// farther apart, negative where parts penetrate; infinite without pairs.
    pub fn at(&mut self, position: &Vector3<f64>) -> f64 {
        if self.pairs.is_empty() {
            return f64::INFINITY;
        }
        let mut least = self.compute(self.nearest, position);
        for index in 0..self.pairs.len() {
            let pair = &mut self.pairs[index];
            if pair.distance - (position - pair.at).norm() - ROUNDING >= least {
                continue;
            }
            let apart = (pair.boxes[0] + position).sup(&(pair.boxes[1] - position)).max();
            if apart >= least {
                (pair.at, pair.distance) = (*position, apart);
                continue;
            }
            let distance = self.compute(index, position);
            if distance < least {
                (least, self.nearest) = (distance, index);
            }
        }
        least
    }

    fn compute(&mut self, index: usize, position: &Vector3<f64>) -> f64 {
        let pose = Pose::new((*position).into(), self.task.goal.quaternion());
        let distance = self.task.pairs[index].shapes.exact_distance(&pose);
        // Distances that cannot be computed count as penetration.
        let distance = if distance.is_nan() { f64::NEG_INFINITY } else { distance };
        (self.pairs[index].at, self.pairs[index].distance) = (*position, distance);
        distance
    }

    /// How far the body moves from a position along a unit vector until it touches something (m), if it does within the
    /// longest travel that is looked at. A body that penetrates something already moves until it penetrates deeper.
    pub fn travel(&mut self, from: &Vector3<f64>, direction: &Vector3<f64>, longest: f64) -> Option<f64> {
        if longest == 0.0 {
            return None;
        }
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

/// Lowest and highest corner of the box around some points.
pub fn bounds(points: &[[f64; 3]], place: impl Fn(Vector3<f64>) -> Vector3<f64>) -> [Vector3<f64>; 2] {
    let start = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
    points
        .iter()
        .map(|point| place(Vector3::from(*point)))
        .fold(start, |[low, high], point| [low.inf(&point), high.sup(&point)])
}

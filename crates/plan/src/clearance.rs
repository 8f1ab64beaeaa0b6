//! Clearance of a body that moves without rotation.

use collision::Solutions;
use nalgebra::Vector3;
use task::{AssemblyTask, ContactPair, Pose};

/// Rounding of exact distances (m).
const ROUNDING: f64 = 1e-9;
/// Penetration that is rounding, as a share of the travel that is looked at.
const TOUCHING: f64 = 1e-4;
/// A body that is no farther than this share of that penetration from a limit has reached it.
const REACHED: f64 = 1e-2;
/// Newton steps along a direction after which a pair counts as touched.
const STEPS: usize = 50;
/// Smoothings (m) of distances with normals; the next where one fails.
const TAUS: [f64; 3] = [1e-11, 1e-9, 1e-7];

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
        self.travels(from, &[*direction], longest)[0]
    }

    /// The same along several directions, which takes less time together.
    pub fn travels(&mut self, from: &Vector3<f64>, directions: &[Vector3<f64>], longest: f64) -> Vec<Option<f64>> {
        if longest == 0.0 {
            return vec![None; directions.len()];
        }
        let touching = self.at(from).min(0.0);
        let mut rays: Vec<Ray> = directions
            .iter()
            .map(|direction| Ray { from: *from, direction: *direction, longest, touched: None })
            .collect();
        let apart = |pair: &Known| (pair.boxes[0] + from).sup(&(pair.boxes[1] - from)).max();
        let mut order: Vec<(f64, usize)> = self.pairs.iter().map(apart).zip(0..).collect();
        order.sort_by(|one, other| one.0.total_cmp(&other.0));
        for (_, index) in order {
            self.touch(index, &mut rays, touching, TOUCHING * longest);
        }
        rays.into_iter().map(|ray| ray.touched).collect()
    }

    /// Shortens travels to where a pair is closer than when it touches by more than a tolerance (m). Its distance is a convex
    /// function of the travel: Newton's method never passes that place, and a pair from which the body moves away is done.
    fn touch(&self, index: usize, rays: &mut [Ray], touching: f64, tolerance: f64) {
        let floor = touching - tolerance;
        let enters = |ray: &Ray| ray.enters(&self.pairs[index].boxes);
        let mut waiting: Vec<(usize, f64)> =
            rays.iter().enumerate().filter_map(|(ray, own)| Some((ray, enters(own)?))).collect();
        for step in 0..STEPS {
            let positions: Vec<Vector3<f64>> =
                waiting.iter().map(|(ray, travelled)| rays[*ray].from + rays[*ray].direction * *travelled).collect();
            let distances = self.distances(index, &positions);
            waiting = waiting
                .into_iter()
                .zip(distances)
                .filter_map(|((index, travelled), (distance, normal))| {
                    let ray = &mut rays[index];
                    let rate = normal.dot(&ray.direction);
                    let is_known = distance.is_finite() && rate.is_finite() && step + 1 < STEPS;
                    if !is_known {
                        ray.touch(travelled);
                        return None;
                    }
                    if distance - floor <= REACHED * tolerance {
                        // Where it has begun to touch, if the distance falls like this since.
                        let since = (touching - distance).max(0.0) / rate.abs();
                        ray.touch((travelled - since).max(0.0));
                        return None;
                    }
                    let next = travelled + (distance - floor) / -rate;
                    (rate < 0.0 && next <= ray.longest).then_some((index, next))
                })
                .collect();
            if waiting.is_empty() {
                return;
            }
        }
    }

    /// Distances (m) of a pair at some positions of the body, and their derivatives by the position; NaN where they cannot be
    /// computed.
    fn distances(&self, index: usize, positions: &[Vector3<f64>]) -> Vec<(f64, Vector3<f64>)> {
        let quaternion = self.task.goal.quaternion();
        let poses: Vec<[f64; 7]> =
            positions.iter().map(|position| Pose::new((*position).into(), quaternion).0).collect();
        let mut contacts = vec![[f64::NAN; 7]; poses.len()];
        let pair = &self.task.pairs[index].shapes;
        let is_found =
            TAUS.iter().any(|&tau| pair.contacts(&poses, tau, &mut Solutions::default(), &mut contacts).is_ok());
        let found =
            |[distance, x, y, z, ..]: [f64; 7]| (if is_found { distance } else { f64::NAN }, Vector3::new(x, y, z));
        contacts.into_iter().map(found).collect()
    }
}

/// A body that moves along a direction.
struct Ray {
    from: Vector3<f64>,
    direction: Vector3<f64>,
    /// Travel that is looked at (m): no farther than where it touches something.
    longest: f64,
    touched: Option<f64>,
}

impl Ray {
    fn touch(&mut self, travelled: f64) {
        if travelled <= self.longest {
            (self.longest, self.touched) = (travelled, Some(travelled));
        }
    }

    /// The travel (m) at which the boxes of a pair come together, if they do.
    fn enters(&self, [low, high]: &[Vector3<f64>; 2]) -> Option<f64> {
        let (mut first, mut last) = (0.0f64, self.longest);
        let sides = (0..3).flat_map(|axis| [(low[axis], axis, 1.0), (high[axis], axis, -1.0)]);
        for (apart, axis, sign) in sides {
            let (apart, rate) = (apart + sign * self.from[axis], sign * self.direction[axis]);
            if rate == 0.0 && apart > 0.0 {
                return None;
            }
            let meets = -apart / rate;
            if rate < 0.0 {
                first = first.max(meets);
            } else if rate > 0.0 {
                last = last.min(meets);
            }
        }
        (first <= last).then_some(first)
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

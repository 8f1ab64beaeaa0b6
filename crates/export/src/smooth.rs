//! A reference whose velocities are continuous. Between the knots of a plan the part moves straight and its velocity steps at
//! each: damping makes a step of the torques of it.

use nalgebra::{Isometry3, Matrix3, UnitQuaternion, Vector3};
use simulation::{Knot, Reference};
use task::{Pose, State, Twist};

/// A cubic Hermite curve through the knots of a reference, at rest at both ends. Its tangents are the harmonic means of the
/// velocities before and after a knot, so that no component overshoots.
#[derive(Debug, Clone)]
pub struct SmoothReference {
    time_step: f64,
    knots: Vec<Knot>,
}

impl SmoothReference {
    /// Through the knots of a reference.
    pub fn new(reference: &Reference) -> Self {
        let time_step = reference.time_step();
        let poses: Vec<Isometry3<f64>> = (0..=reference.intervals()).map(|knot| reference.at(knot, 0.0).pose).collect();
        let rates: Vec<[Vector3<f64>; 2]> = poses
            .windows(2)
            .map(|pair| {
                let turn = (pair[0].rotation.inverse() * pair[1].rotation).scaled_axis();
                [(pair[1].translation.vector - pair[0].translation.vector) / time_step, turn / time_step]
            })
            .collect();
        let knot = |index: usize| {
            let around = index.checked_sub(1).and_then(|before| Some((rates.get(before)?, rates.get(index)?)));
            let mean = |kind: usize| around.map_or(Vector3::zeros(), |(one, other)| harmonic(&one[kind], &other[kind]));
            Knot { pose: poses[index], velocity: mean(0), angular_velocity: mean(1) }
        };
        Self { time_step, knots: (0..poses.len()).map(knot).collect() }
    }

    /// Time between two knots (s).
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Poses and twists at the knots.
    pub fn knots(&self) -> &[Knot] {
        &self.knots
    }

    /// Time of the last knot (s).
    pub fn duration(&self) -> f64 {
        (self.knots.len() - 1) as f64 * self.time_step
    }

    /// At a number of knots from the beginning, 1.5 for half a step after the second; at rest after the last one.
    pub fn at(&self, knots: f64) -> Knot {
        let index = knots as usize;
        let Some([from, to, ..]) = self.knots.get(index..) else { return self.knots[self.knots.len() - 1] };
        let (hermite, step) = (Hermite::new(knots.fract()), self.time_step);
        let origin = from.pose.translation.vector;
        let way = to.pose.translation.vector - origin;
        let (moved, velocity) = hermite.between(&way, &(step * from.velocity), &(step * to.velocity));
        let turn = (from.pose.rotation.inverse() * to.pose.rotation).scaled_axis();
        // In the chart of rotation vectors, the tangent at the end differs.
        let last = right_jacobian(&turn).try_inverse().unwrap_or_else(Matrix3::identity) * to.angular_velocity;
        let (turned, rate) = hermite.between(&turn, &(step * from.angular_velocity), &(step * last));
        Knot {
            pose: Isometry3::from_parts(
                (origin + moved).into(),
                from.pose.rotation * UnitQuaternion::from_scaled_axis(turned),
            ),
            velocity: velocity / step,
            angular_velocity: right_jacobian(&turned) * rate / step,
        }
    }

    /// As a reference with `count` straight pieces between two knots, for rollouts.
    pub fn pieces(&self, count: usize) -> Reference {
        let last = (self.knots.len() - 1) * count;
        let knots: Vec<Knot> = (0..=last).map(|piece| self.at(piece as f64 / count as f64)).collect();
        let step = self.time_step / count as f64;
        let state = |index: usize| {
            let (from, to) = (&knots[index.saturating_sub(1)].pose, &knots[index].pose);
            let velocity = (to.translation.vector - from.translation.vector) / step;
            let spin = (from.rotation.inverse() * to.rotation).scaled_axis() / step;
            State::new(&Pose::from(to), &Twist::new(&velocity, &spin))
        };
        let states: Vec<State> = (0..=last).map(state).collect();
        Reference::new(step, &states)
    }
}

/// The cubic polynomials at a share of an interval, and their derivatives.
struct Hermite {
    way: [f64; 2],
    first: [f64; 2],
    last: [f64; 2],
}

impl Hermite {
    fn new(share: f64) -> Self {
        let (square, cube) = (share * share, share * share * share);
        Self {
            way: [3.0 * square - 2.0 * cube, 6.0 * (share - square)],
            first: [cube - 2.0 * square + share, 3.0 * square - 4.0 * share + 1.0],
            last: [cube - square, 3.0 * square - 2.0 * share],
        }
    }

    /// Value and derivative between zero and `way`, with tangents at both ends.
    fn between(&self, way: &Vector3<f64>, first: &Vector3<f64>, last: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        let at = |order: usize| self.way[order] * way + self.first[order] * first + self.last[order] * last;
        (at(0), at(1))
    }
}

/// The harmonic mean of each component; zero where the signs differ.
fn harmonic(one: &Vector3<f64>, other: &Vector3<f64>) -> Vector3<f64> {
    one.zip_map(other, |one, other| if one * other > 0.0 { 2.0 * one * other / (one + other) } else { 0.0 })
}

/// From the derivative of a rotation vector to the angular velocity in the rotated frame.
fn right_jacobian(turn: &Vector3<f64>) -> Matrix3<f64> {
    let (angle, cross) = (turn.norm(), turn.cross_matrix());
    // Limits for small angles.
    let [linear, square] = match angle < 1e-4 {
        true => [0.5, 1.0 / 6.0],
        false => [(1.0 - angle.cos()) / angle.powi(2), (angle - angle.sin()) / angle.powi(3)],
    };
    Matrix3::identity() - linear * cross + square * cross * cross
}

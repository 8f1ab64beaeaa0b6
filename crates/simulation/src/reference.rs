//! Reference motions, given at knots.

use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use task::pose::interpolate;
use task::{GraspError, Horizon, Limits, Pose, State, StraightMotion, Trajectory, Twist};

use crate::perturbation::Perturbation;

/// A reference motion given at equidistant knots. Between the knots, positions are interpolated linearly and
/// orientations by slerp; on the interval `[k, k + 1]` the twist of knot `k + 1` holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    time_step: f64,
    knots: Vec<Knot>,
}

/// What the controller tracks at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knot {
    /// Position (m) and orientation.
    pub pose: Isometry3<f64>,
    /// Velocity in the world frame (m/s).
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame (rad/s).
    pub angular_velocity: Vector3<f64>,
}

impl Knot {
    fn new(state: &State) -> Self {
        let twist = state.twist();
        Self { pose: state.pose().isometry(), velocity: twist.velocity(), angular_velocity: twist.angular_velocity() }
    }

    /// Pose and twist as plain numbers.
    pub fn state(&self) -> State {
        State::new(&Pose::from(&self.pose), &Twist::new(&self.velocity, &self.angular_velocity))
    }
}

impl From<&Trajectory> for Reference {
    fn from(motion: &Trajectory) -> Self {
        Self::new(motion.time_step, &motion.reference)
    }
}

impl Reference {
    /// From the states (pose, twist) of a plan, `time_step` seconds apart: those of `reference.csv` or of
    /// [`task::Trajectory::reference`]. Quaternions may be of any norm.
    ///
    /// # Panics
    /// When there are no states.
    pub fn new(time_step: f64, states: &[State]) -> Self {
        assert!(!states.is_empty(), "a reference has at least one state");
        Self { time_step, knots: states.iter().map(Knot::new).collect() }
    }

    /// The straight motion from start to goal, rotating about one axis, at constant velocity. The horizon has at least
    /// one step.
    pub fn straight(start: &Pose, goal: &Pose, horizon: Horizon) -> Self {
        let (start, goal) = (start.isometry(), goal.isometry());
        let duration = horizon.steps as f64 * horizon.time_step;
        let velocity = (goal.translation.vector - start.translation.vector) / duration;
        let rotation = start.rotation.rotation_to(&goal.rotation).scaled_axis();
        let angular_velocity = start.rotation.inverse() * rotation / duration;
        let knot = |step: usize| {
            let fraction = step as f64 / horizon.steps as f64;
            Knot { pose: interpolate(&start, &goal, fraction), velocity, angular_velocity }
        };
        Self { time_step: horizon.time_step, knots: (0..=horizon.steps).map(knot).collect() }
    }

    /// The reference with a perturbation, and with the twists that lead from knot to knot. Knots before the
    /// perturbation stay as they are.
    pub fn perturbed(&self, perturbation: &Perturbation) -> Self {
        let mut knots = self.knots.clone();
        let weight = |index: usize| perturbation.weight(index as f64 / self.intervals().max(1) as f64);
        let first = (0..knots.len()).find(|&index| weight(index) > 0.0).unwrap_or(knots.len());
        for (index, knot) in knots.iter_mut().enumerate().skip(first) {
            knot.pose.translation.vector += perturbation.shift * weight(index);
            knot.pose.rotation *= UnitQuaternion::from_scaled_axis(perturbation.rotation * weight(index));
        }
        Self { time_step: self.time_step, knots }.with_twists_from(first)
    }

    /// The reference with a share (0 to 1) of its departure from a straight motion taken back between two fractions of
    /// its duration. The share fades towards these fractions, but not towards start and end.
    pub fn straightened(&self, straight: &StraightMotion, part: [f64; 2], share: f64) -> Self {
        let mut knots = self.knots.clone();
        let mut first = knots.len();
        for (index, knot) in knots.iter_mut().enumerate() {
            let taken = share * inside(index as f64 / self.intervals().max(1) as f64, part);
            if taken > 0.0 {
                knot.pose = interpolate(&knot.pose, &straight.nearest(&knot.pose), taken);
                first = first.min(index);
            }
        }
        Self { time_step: self.time_step, knots }.with_twists_from(first)
    }

    /// The same motion somewhere else, shifted in the world frame (m).
    pub fn shifted(&self, by: &Vector3<f64>) -> Self {
        let moved = |knot: &Knot| {
            let position = knot.pose.translation.vector + by;
            Knot { pose: Isometry3::from_parts(position.into(), knot.pose.rotation), ..*knot }
        };
        Self { time_step: self.time_step, knots: self.knots.iter().map(moved).collect() }
    }

    /// The same motion with the knots of another horizon, and with the twists that lead from knot to knot.
    pub fn on(&self, horizon: Horizon) -> Self {
        let knot = |step: usize| {
            let place = step as f64 * horizon.time_step / self.time_step;
            self.at(place as usize, place.fract())
        };
        let knots = (0..=horizon.steps).map(knot).collect();
        Self { time_step: horizon.time_step, knots }.with_twists()
    }

    /// The same motion in a world that is moved.
    pub fn transformed(&self, by: &Isometry3<f64>) -> Self {
        let moved = |knot: &Knot| Knot { pose: by * knot.pose, velocity: by.rotation * knot.velocity, ..*knot };
        Self { time_step: self.time_step, knots: self.knots.iter().map(moved).collect() }
    }

    /// From another start: its difference from that of the motion fades out over a number of intervals, after which the motion
    /// is the same.
    pub fn led_from(&self, start: &Isometry3<f64>, intervals: usize) -> Self {
        let shift = start.translation.vector - self.knots[0].pose.translation.vector;
        let rotation = (self.knots[0].pose.rotation.inverse() * start.rotation).scaled_axis();
        let mut knots = self.knots.clone();
        for (index, knot) in knots.iter_mut().enumerate().take(intervals) {
            let share = index as f64 / intervals as f64;
            let left = 1.0 - share * share * (3.0 - 2.0 * share);
            knot.pose.translation.vector += shift * left;
            knot.pose.rotation *= UnitQuaternion::from_scaled_axis(rotation * left);
        }
        Self { time_step: self.time_step, knots }.with_twists()
    }

    /// The first intervals, at most `intervals`.
    pub fn cut(&self, intervals: usize) -> Self {
        Self { time_step: self.time_step, knots: self.knots.iter().copied().take(intervals + 1).collect() }
    }

    /// The reference, followed by other poses.
    pub(crate) fn continued(&self, poses: impl Iterator<Item = Isometry3<f64>>) -> Self {
        let still =
            |pose: Isometry3<f64>| Knot { pose, velocity: Vector3::zeros(), angular_velocity: Vector3::zeros() };
        let knots = self.knots.iter().copied().chain(poses.map(still)).collect();
        Self { time_step: self.time_step, knots }.with_twists_from(self.knots.len())
    }

    /// The same poses with the twists that lead from knot to knot.
    pub fn with_twists(self) -> Self {
        self.with_twists_from(1)
    }

    /// The same from a knot on.
    fn with_twists_from(mut self, first: usize) -> Self {
        for index in first.max(1)..self.knots.len() {
            let (from, to) = (self.knots[index - 1].pose, self.knots[index].pose);
            self.knots[index].velocity = (to.translation.vector - from.translation.vector) / self.time_step;
            let rotation = from.rotation.rotation_to(&to.rotation).scaled_axis();
            self.knots[index].angular_velocity = from.rotation.inverse() * rotation / self.time_step;
        }
        self
    }

    /// The motion of the part while the robot follows the reference: the same motion in the frame of the part.
    pub fn of_part(&self, grasp: &GraspError) -> Self {
        let rotation = grasp.quaternion();
        let rotated = |knot: &Knot| Knot {
            pose: Isometry3::from_parts(knot.pose.translation, knot.pose.rotation * rotation.inverse()),
            angular_velocity: rotation * knot.angular_velocity,
            ..*knot
        };
        Self { time_step: self.time_step, knots: self.knots.iter().map(rotated).collect() }
    }

    /// Number of first intervals on which another reference is the same.
    pub fn shared_intervals(&self, other: &Self) -> usize {
        let knots = || self.knots.iter().zip(&other.knots);
        match knots().position(|(one, other)| one != other) {
            _ if self.time_step != other.time_step => 0,
            Some(first) => first.saturating_sub(1),
            None => knots().len() - 1,
        }
    }

    /// States (pose, twist) at the knots.
    pub fn states(&self) -> Vec<State> {
        self.knots.iter().map(Knot::state).collect()
    }

    /// Positions at the knots (m, world frame).
    pub fn positions(&self) -> impl Iterator<Item = [f64; 3]> {
        self.knots.iter().map(|knot| knot.pose.translation.vector.into())
    }

    /// Orientations at the knots.
    pub fn orientations(&self) -> impl Iterator<Item = UnitQuaternion<f64>> {
        self.knots.iter().map(|knot| knot.pose.rotation)
    }

    /// The tightest limits that the reference keeps; it has velocities and accelerations only.
    pub fn limits_kept(&self) -> Limits {
        Limits::kept_by(&self.states(), self.time_step, &[], 0.0)
    }

    /// Time between two knots (s).
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Number of intervals between knots, and the time between them.
    pub fn horizon(&self) -> Horizon {
        Horizon { steps: self.intervals(), time_step: self.time_step }
    }

    /// Number of intervals between knots.
    pub fn intervals(&self) -> usize {
        self.knots.len() - 1
    }

    /// The first pose, with a unit quaternion.
    pub fn start(&self) -> Pose {
        Pose::from(&self.knots[0].pose)
    }

    /// At a fraction (0 to 1) of an interval; after the last interval the last pose is held at rest.
    pub fn at(&self, interval: usize, fraction: f64) -> Knot {
        match self.knots.get(interval..) {
            Some([from, to, ..]) => Knot { pose: interpolate(&from.pose, &to.pose, fraction), ..*to },
            _ => Knot {
                pose: self.knots[self.intervals()].pose,
                velocity: Vector3::zeros(),
                angular_velocity: Vector3::zeros(),
            },
        }
    }
}

/// Fraction of a part of a reference over which a change fades in and out.
const FADE: f64 = 0.3;

/// Weight of a change of a part at a fraction of the duration: it fades out towards the ends of the part, but not
/// towards those of the reference.
fn inside(fraction: f64, [from, to]: [f64; 2]) -> f64 {
    let fade = FADE * (to - from);
    let ramp = |distance: f64| {
        let part = (distance / fade).clamp(0.0, 1.0);
        part * part * (3.0 - 2.0 * part)
    };
    let begin = if from > 0.0 { ramp(fraction - from) } else { 1.0 };
    let end = if to < 1.0 { ramp(to - fraction) } else { 1.0 };
    begin * end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reference_from_another_start_ends_as_before() {
        let pose = |x: f64| Pose::new([x, 0.0, 0.1 - x], [(0.5 * x).cos(), (0.5 * x).sin(), 0.0, 0.0]);
        let states: Vec<State> = (0..=10).map(|step| pose(0.01 * f64::from(step)).at_rest()).collect();
        let reference = Reference::new(0.1, &states);
        let start = Isometry3::from_parts(
            Vector3::new(0.004, -0.003, 0.102).into(),
            UnitQuaternion::from_scaled_axis(Vector3::new(0.0, 0.05, 0.0)),
        );
        let led = reference.led_from(&start, 6);
        let far = |index: usize| {
            let (one, other) = (led.at(index, 0.0).pose, reference.at(index, 0.0).pose);
            ((one.translation.vector - other.translation.vector).norm(), one.rotation.angle_to(&other.rotation))
        };
        let begin = led.at(0, 0.0).pose;
        assert!((begin.translation.vector - start.translation.vector).norm() < 1e-15);
        assert!(begin.rotation.angle_to(&start.rotation) < 1e-9);
        assert!((1..6).all(|index| far(index).0 < far(index - 1).0 && far(index).1 < far(index - 1).1));
        assert!((6..=10).all(|index| far(index) == (0.0, 0.0)));
        assert_eq!(reference.led_from(&start, 0), reference.clone().with_twists(), "no time for it");

        let by = Isometry3::from_parts(
            Vector3::new(0.2, 0.0, 0.1).into(),
            UnitQuaternion::from_scaled_axis(Vector3::new(0.0, 0.0, 0.4)),
        );
        let (moved, knot) = (reference.clone().with_twists().transformed(&by), 4);
        let velocity = moved.at(knot, 0.0).velocity;
        let expected = moved.clone().with_twists().at(knot, 0.0).velocity;
        assert!((velocity - expected).norm() < 1e-12, "velocities turn with the world");
    }

    #[test]
    fn a_reference_on_another_horizon_is_the_same_motion() {
        let pose = |step: f64| {
            Pose::new([0.01 * step * step, 0.0, 0.02 * step], [(0.1 * step).cos(), 0.0, (0.1 * step).sin(), 0.0])
        };
        let states: Vec<State> = (0..=4).map(|step| pose(f64::from(step)).at_rest()).collect();
        let coarse = Reference::new(0.1, &states);
        let fine = coarse.on(Horizon { steps: 8, time_step: 0.05 });
        assert_eq!((fine.intervals(), fine.time_step()), (8, 0.05));
        for step in 0..=8 {
            let (one, other) = (fine.at(step, 0.0).pose, coarse.at(step / 2, 0.5 * (step % 2) as f64).pose);
            assert!((one.translation.vector - other.translation.vector).norm() < 1e-12, "knot {step}");
            assert!(one.rotation.angle_to(&other.rotation) < 1e-7, "knot {step}");
        }
        let velocity = fine.at(2, 0.5).velocity;
        assert!((velocity - Vector3::new(0.3, 0.0, 0.2)).norm() < 1e-12, "{velocity}, of the second interval");
    }
}

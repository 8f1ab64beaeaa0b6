//! A reference that looks for a hole along a spiral.
//!
//! A body that is off in the gripper by more than its clearance lands beside the hole. Pressed lightly onto the rim, it is led
//! along a spiral around where the hole should be, until it falls in; the walls of the hole then hold it while the reference
//! goes on. Every offset within the spiral finds the hole once, whatever its direction.

use std::f64::consts::{PI, TAU};

use nalgebra::{Isometry3, Vector3};
use task::pose::interpolate;
use task::{AssemblyTask, Pose};

use crate::reference::Reference;

/// What a spiral depends on besides the task.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpiralSearch {
    /// Direction in which the body leaves its goal (unit vector, world frame).
    pub out: Vector3<f64>,
    /// Distance from the goal along that up to which the hole guides the body across it (m).
    pub depth: f64,
    /// Offsets up to this length are to find the hole (m).
    pub offset: f64,
    /// Distance between two turns of the spiral (m): less than the clearance from side to side.
    pub pitch: f64,
    /// The largest friction that is expected.
    pub friction: f64,
    /// Longest duration of the search (s).
    pub longest: f64,
}

/// Turns of the spiral beyond the largest offset: friction holds the body back.
const TURNS_BEYOND: f64 = 2.0;
/// Friction holds the body back by at most this share of the pitch while the reference is deepest below the rim.
const LAG: f64 = 1.0;
/// The least friction for which the reference is that deep: without friction it would be infinitely deep.
const LEAST_FRICTION: f64 = 0.1;
/// The body passes the pitch in this many times `sqrt(mass / stiffness)`, in which it falls into the hole.
const RESPONSES: f64 = 0.5;
/// Height above the rim at which the body slows down, in pitches, and its velocity from there, in that of the spiral.
const APPROACH: f64 = 5.0;
/// Velocities before and after the search, in those of the straight motion.
const HASTE: f64 = 2.0;

impl SpiralSearch {
    /// The search of a task: towards the rim, along the spiral, to the goal, which it reaches in the goal's orientation. `None`
    /// where it would take too long, or a value is not positive.
    pub fn reference(&self, task: &AssemblyTask) -> Option<Reference> {
        let Self { out, depth, offset, pitch, friction, longest } = *self;
        let mass = out.dot(&(task.inertia.translational() * out));
        let response = (mass / task.impedance.translational_stiffness).sqrt();
        let (velocity, radius) = (pitch / (RESPONSES * response), offset + TURNS_BEYOND * pitch);
        let length = PI * radius * radius / pitch;
        let duration = length / velocity;
        if !(depth > 0.0 && pitch > 0.0 && offset > 0.0 && duration <= longest) {
            return None;
        }
        let deepest = (LAG * pitch / friction.max(LEAST_FRICTION)).min(depth);
        let time_step = task.horizon.time_step;
        let (start, goal) = (task.start.isometry(), task.goal.isometry());
        let rim = goal.translation.vector + out * depth;
        let at =
            |across: Vector3<f64>, down: f64| Isometry3::from_parts((rim + across - out * down).into(), goal.rotation);
        let path = (start.translation.vector - goal.translation.vector).norm();
        let straight = HASTE * path / (task.horizon.steps as f64 * time_step);
        let mut search = Search { poses: vec![start], time_step };
        search.lead_to(at(Vector3::zeros(), -APPROACH * pitch), straight);
        search.lead_to(at(Vector3::zeros(), 0.5 * deepest), velocity);
        let first = out.cross(&Vector3::ith(out.iamin(), 1.0)).normalize();
        let second = out.cross(&first);
        let knots = (duration / time_step).ceil() as usize;
        search.poses.extend((1..=knots).map(|knot| {
            let share = knot as f64 / knots as f64;
            // Equal lengths in equal times.
            let (distance, angle) = (radius * share.sqrt(), TAU * radius * share.sqrt() / pitch);
            let across = (first * angle.cos() + second * angle.sin()) * distance;
            at(across, 0.5 * deepest * (1.0 + share))
        }));
        search.lead_to(at(Vector3::zeros(), deepest), velocity);
        search.lead_to(goal, straight);
        Some(search.reference())
    }
}

struct Search {
    poses: Vec<Isometry3<f64>>,
    time_step: f64,
}

impl Search {
    /// Appends a straight motion that begins and ends at rest, with a mean velocity (m/s).
    fn lead_to(&mut self, to: Isometry3<f64>, velocity: f64) {
        let Some(&from) = self.poses.last() else { return };
        let distance = (to.translation.vector - from.translation.vector).norm();
        let knots = (distance / velocity / self.time_step).ceil().max(1.0) as usize;
        self.poses.extend((1..=knots).map(|knot| {
            let share = knot as f64 / knots as f64;
            interpolate(&from, &to, share * share * (3.0 - 2.0 * share))
        }));
    }

    fn reference(self) -> Reference {
        let states: Vec<_> = self.poses.iter().map(|pose| Pose::from(pose).at_rest()).collect();
        Reference::new(self.time_step, &states).with_twists()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;
    use task::{CostWeights, Horizon, Impedance, Inertia, Limits, TrajectoryCost};

    use super::*;

    const SEARCH: SpiralSearch = SpiralSearch {
        out: Vector3::new(0.0, 0.0, 1.0),
        depth: 0.012,
        offset: 2e-3,
        pitch: 3e-4,
        friction: 0.5,
        longest: 10.0,
    };

    fn insertion() -> AssemblyTask {
        let weights = CostWeights {
            translational_velocity: 1.0,
            rotational_velocity: 1.0,
            terminal_position: 1.0,
            terminal_orientation: 1.0,
        };
        let inertia = Inertia::of_body(1.0, Matrix3::from_diagonal_element(0.1));
        AssemblyTask {
            pairs: Vec::new(),
            frictions: vec![0.0],
            start: Pose([0.0, 0.0, 0.05, 0.999, 0.0447, 0.0, 0.0]),
            goal: Pose([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
            impedance: Impedance::critically_damped(500.0, 16.0, &inertia),
            inertia,
            grasps: Vec::new(),
            horizon: Horizon { steps: 75, time_step: 0.04 },
            cost: TrajectoryCost { reference: weights, compliant: weights },
            limits: Limits::NONE,
        }
    }

    #[test]
    fn every_offset_is_passed_within_half_a_pitch_at_a_light_depth() {
        let task = insertion();
        let reference = SEARCH.reference(&task).unwrap();
        let positions: Vec<[f64; 3]> = reference.positions().collect();
        let rim = |position: &&[f64; 3]| (position[2] - SEARCH.depth).abs() < 7e-4;
        let near: Vec<&[f64; 3]> = positions.iter().filter(rim).collect();
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..200 {
            let (angle, length) = (TAU * random.f64(), SEARCH.offset * random.f64().sqrt());
            let hole = [length * angle.cos(), length * angle.sin()];
            let segments = near.windows(2).map(|pair| {
                let ([from, to], hole) =
                    ([pair[0], pair[1]].map(|p| nalgebra::Vector2::new(p[0], p[1])), nalgebra::Vector2::from(hole));
                let along = to - from;
                let share = ((hole - from).dot(&along) / along.norm_squared().max(1e-30)).clamp(0.0, 1.0);
                (from + along * share - hole).norm()
            });
            let nearest = segments.fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.5 * SEARCH.pitch + 2e-5, "{nearest} m from {hole:?}");
        }
        let last = positions[positions.len() - 1];
        assert!(last.iter().all(|component| component.abs() < 1e-12), "it ends at the goal: {last:?}");
        assert!((reference.start().isometry().rotation.angle() - 0.0894).abs() < 1e-3, "it begins at the start");
    }

    #[test]
    fn a_search_that_takes_too_long_or_has_no_hole_is_none() {
        let task = insertion();
        assert_eq!(SpiralSearch { offset: 0.02, ..SEARCH }.reference(&task), None);
        assert_eq!(SpiralSearch { pitch: 0.0, ..SEARCH }.reference(&task), None);
        assert_eq!(SpiralSearch { depth: 0.0, ..SEARCH }.reference(&task), None);
        assert_eq!(SpiralSearch { pitch: f64::NAN, ..SEARCH }.reference(&task), None);
    }
}

//! A reference that looks for a hole along a spiral, or for a slot from side to side.
//!
//! A body that is off in the gripper by more than its clearance lands beside the hole. Pressed onto the rim, it is led along a
//! spiral around where the hole should be, until it falls in; the walls of the hole then hold it while the reference goes on.
//! Every offset within the spiral finds the hole once, whatever its direction.

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
    /// The only direction across that in which the hole guides the body (unit vector); all where it is `None`.
    pub guided: Option<Vector3<f64>>,
    /// Whether it turns the other way, or begins at the other side.
    pub is_mirrored: bool,
    /// Friction holds the body back by at most this many pitches while the reference is deepest below the rim. A body that is
    /// pressed less is led out of the hole again before it has fallen past a chamfer; one that is pressed more may get stuck.
    pub lag: f64,
    /// Distance from the goal along the way out where the hole begins (m).
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

/// Turns of the body's spiral beyond the largest offset.
const TURNS_BEYOND: f64 = 1.0;
/// Depth of the reference below the rim at first, as a share of the largest. It grows with the distance from the middle: friction then
/// holds the body back by a share of that, so that its spiral is a smaller one with equal turns.
const FIRST_DEPTH: f64 = 0.25;
/// The least friction for which the reference is that deep: without friction it would be infinitely deep.
const LEAST_FRICTION: f64 = 0.1;
/// The body passes the pitch in this many times `sqrt(mass / stiffness)`, in which it falls into the hole.
const RESPONSES: f64 = 0.7;
/// Height above the rim at which the body slows down, in pitches, and its velocity from there, in that of the spiral.
const APPROACH: f64 = 5.0;
/// Velocities before and after the search, in those of the straight motion.
const HASTE: f64 = 2.0;

impl SpiralSearch {
    /// The search of a task: towards the rim, along the spiral, to the goal, which it reaches in the goal's orientation. `None`
    /// where it would take too long, or a value is not positive.
    pub fn reference(&self, task: &AssemblyTask) -> Option<Reference> {
        let Self { out, depth, offset, pitch, longest, .. } = *self;
        let mass = out.dot(&(task.inertia.translational() * out));
        let response = (mass / task.impedance.translational_stiffness).sqrt();
        let velocity = pitch / (RESPONSES * response);
        let duration = self.length() / velocity;
        if !(depth > 0.0 && pitch > 0.0 && offset > 0.0 && duration <= longest) {
            return None;
        }
        let deepest = self.deepest();
        let time_step = task.horizon.time_step;
        let (start, goal) = (task.start.isometry(), task.goal.isometry());
        let rim = goal.translation.vector + out * depth;
        let at =
            |across: Vector3<f64>, down: f64| Isometry3::from_parts((rim + across - out * down).into(), goal.rotation);
        let path = (start.translation.vector - goal.translation.vector).norm();
        let straight = HASTE * path / (task.horizon.steps as f64 * time_step);
        let mut search = Search { poses: vec![start], time_step };
        search.lead_to(at(Vector3::zeros(), -APPROACH * pitch), straight);
        search.lead_to(at(Vector3::zeros(), FIRST_DEPTH * deepest), velocity);
        let knots = (duration / time_step).ceil() as usize;
        search.poses.extend((1..=knots).map(|knot| {
            let share = knot as f64 / knots as f64;
            at(self.across(share), deepest * share.sqrt().max(FIRST_DEPTH))
        }));
        search.lead_to(at(Vector3::zeros(), deepest), velocity);
        search.lead_to(goal, straight);
        Some(search.reference())
    }

    /// Largest depth of the reference below the rim (m).
    fn deepest(&self) -> f64 {
        (self.lag * self.pitch / self.friction.max(LEAST_FRICTION)).min(self.depth)
    }

    /// Largest distance of the search from the hole (m). A body that is led along a circle and held back by friction follows on a
    /// smaller one, at right angles to the way to the reference.
    fn radius(&self) -> f64 {
        let (radius, held_back) = (self.offset + TURNS_BEYOND * self.pitch, self.friction * self.deepest());
        if self.guided.is_some() { radius + held_back } else { radius.hypot(held_back) }
    }

    /// Length of the search (m).
    fn length(&self) -> f64 {
        let radius = self.radius();
        if self.guided.is_some() { 3.0 * radius } else { PI * radius * radius / self.pitch }
    }

    /// Where the search is across the way out (m) after a share of its length.
    fn across(&self, share: f64) -> Vector3<f64> {
        let (radius, out) = (self.radius(), &self.out);
        let sign = if self.is_mirrored { -1.0 } else { 1.0 };
        if let Some(guided) = self.guided {
            // To one side, then to the other.
            let way = 3.0 * share;
            return guided * (sign * radius * if way < 1.0 { way } else { 2.0 - way });
        }
        let first = out.cross(&Vector3::ith(out.iamin(), 1.0)).normalize();
        // Equal lengths in equal times.
        let (distance, angle) = (radius * share.sqrt(), TAU * radius * share.sqrt() / self.pitch);
        (first * angle.cos() + out.cross(&first) * (sign * angle.sin())) * distance
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
        guided: None,
        is_mirrored: false,
        lag: 4.0,
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
    fn a_search_begins_at_the_start_and_ends_at_the_goal_and_has_a_mirror_image() {
        let task = insertion();
        let reference = SEARCH.reference(&task).unwrap();
        let positions: Vec<[f64; 3]> = reference.positions().collect();
        let mirrored = SpiralSearch { is_mirrored: true, ..SEARCH }.reference(&task).unwrap();
        // Its first axis is along y.
        let are_mirrored = positions
            .iter()
            .zip(mirrored.positions())
            .all(|(one, other)| (one[0] + other[0]).abs() < 1e-12 && one[1..] == other[1..]);
        assert!(are_mirrored, "the other one turns the other way");
        let last = positions[positions.len() - 1];
        assert!(last.iter().all(|component| component.abs() < 1e-12), "it ends at the goal: {last:?}");
        assert!((reference.start().isometry().rotation.angle() - 0.0894).abs() < 1e-3, "it begins at the start");
    }

    /// Places across the insertion of a body that is slowly pulled over the rim, held back by Coulomb's friction.
    fn pulled(friction: f64) -> Vec<Vector3<f64>> {
        let reference = SEARCH.reference(&insertion()).unwrap();
        let positions: Vec<Vector3<f64>> = reference.positions().map(Vector3::from).collect();
        let (mut body, mut places) = (Vector3::zeros(), Vec::new());
        for pair in positions.windows(2) {
            for part in 0..50 {
                let to = pair[0].lerp(&pair[1], f64::from(part) / 50.0);
                let depth = SEARCH.depth - to.z;
                // Before and after the search, the reference is above the rim and far below it.
                if !(0.0..=1.001 * SEARCH.deepest()).contains(&depth) {
                    continue;
                }
                let held_back = friction * depth;
                let way = Vector3::new(to.x, to.y, 0.0) - body;
                if way.norm() > held_back {
                    body += way * (1.0 - held_back / way.norm());
                }
                places.push(body);
            }
        }
        places
    }

    #[test]
    fn every_offset_finds_the_hole_whatever_the_friction() {
        let mut random = fastrand::Rng::with_seed(1);
        let offsets: Vec<Vector3<f64>> = (0..300)
            .map(|_| {
                let (angle, length) = (TAU * random.f64(), SEARCH.offset * random.f64().sqrt());
                Vector3::new(length * angle.cos(), length * angle.sin(), 0.0)
            })
            .collect();
        for (friction, most) in [(0.0, 0.55), (0.1, 0.6), (0.25, 0.7), (0.5, 0.9)] {
            let places = pulled(friction);
            for offset in &offsets {
                let nearest = places.iter().map(|place| (place - offset).norm()).fold(f64::INFINITY, f64::min);
                assert!(nearest < most * SEARCH.pitch, "friction {friction}: {nearest} m from {offset:?}");
            }
        }
    }

    #[test]
    fn a_slot_is_looked_for_from_side_to_side() {
        let task = insertion();
        let guided = Vector3::new(0.6, 0.8, 0.0);
        let positions: Vec<Vector3<f64>> = SpiralSearch { guided: Some(guided), ..SEARCH }
            .reference(&task)
            .unwrap()
            .positions()
            .map(Vector3::from)
            .collect();
        let across = |position: &Vector3<f64>| position - Vector3::z() * position.z;
        assert!(positions.iter().all(|position| across(position).cross(&guided).norm() < 1e-12));
        // Friction of 0.5 holds the body back by half of what the reference is deeper than the rim.
        for side in [-1.0, 1.0] {
            let reached = positions
                .iter()
                .map(|position| side * across(position).dot(&guided) - 0.5 * (SEARCH.depth - position.z).max(0.0));
            let farthest = reached.fold(f64::NEG_INFINITY, f64::max);
            assert!(farthest > SEARCH.offset + 0.99 * SEARCH.pitch, "{farthest} m to one side");
        }
        assert!(across(&positions[positions.len() - 1]).norm() < 1e-12, "it ends above the goal");
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

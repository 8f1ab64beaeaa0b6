//! The decaying oscillation at the end of a reference, against dry friction.
//!
//! Dry friction holds a body anywhere in a band around the end of the reference. The reference therefore passes the
//! goal back and forth with decreasing amplitude, and friction leaves the body near the middle, as a decaying
//! alternating field demagnetises a magnet. It needs no friction coefficient.

use nalgebra::{Isometry3, Unit, Vector3};
use task::AssemblyTask;

use crate::reference::Reference;
use crate::success::Success;

/// An oscillation about the goal on the line from start to goal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FinalOscillation {
    goal: Vector3<f64>,
    direction: Unit<Vector3<f64>>,
    /// By how much the amplitude of each half-cycle is smaller than that of the one before (m).
    decrease: f64,
    /// Duration of each half-cycle (s).
    duration: f64,
}

/// Number of half-cycles beyond the goal, alternately along the direction, as the first, and against it; one more ends at
/// the goal.
const COUNT: usize = 5;
/// Decrease of the amplitude from half-cycle to half-cycle, as a part of the position tolerance. A body in any band that the
/// first half-cycle overcomes ends within half of that from the goal.
const DECREASE: f64 = 0.8;
/// Largest half-cycle back as a part of the engagement depth: half-cycles must not take the body out.
const DEPTH: f64 = 0.5;
/// Duration of a half-cycle as a multiple of `sqrt(mass / stiffness)`, the time in which the body follows.
const RESPONSES: f64 = 4.0;
/// Largest velocity and acceleration of a smooth half-cycle of one metre in one second.
const PEAKS: [f64; 2] = [1.5, 6.0];

impl FinalOscillation {
    /// For a task and tolerances of success, where the environment guides the body up to some depth (m) from the goal,
    /// infinite where nothing does. Half-cycles stay within half of that, and keep the limits of translational velocity and
    /// acceleration. `None` where start and goal are at the same place, the depth is zero, or a value is not finite.
    pub fn new(task: &AssemblyTask, success: &Success, depth: f64) -> Option<Self> {
        let goal = task.goal.position();
        let direction = Unit::try_new(goal - task.start.position(), success.position)?;
        // The longest half-cycle back is the second.
        let decrease = (DECREASE * success.position).min(DEPTH * depth / (COUNT - 1) as f64);
        let mass = direction.dot(&(task.inertia.translational() * *direction));
        let response = RESPONSES * (mass / task.impedance.translational_stiffness).sqrt();
        // From one side of the goal to the other.
        let longest = (2 * COUNT - 1) as f64 * decrease;
        let [velocity, acceleration] = PEAKS.map(|peak| peak * longest);
        let duration = response
            .max(velocity / task.limits.translational_velocity)
            .max((acceleration / task.limits.translational_acceleration).sqrt());
        (decrease > 0.0 && duration.is_finite()).then_some(Self { goal, direction, decrease, duration })
    }

    /// Shifts (m, world frame) from the last position of a reference with knots `time_step` seconds apart, one for each
    /// further knot.
    fn shifts(&self, last: &Vector3<f64>, time_step: f64) -> impl Iterator<Item = Vector3<f64>> {
        let ahead = self.direction.dot(&(self.goal - last));
        let turning = move |half_cycle: usize| {
            let reach = (COUNT - half_cycle) as f64 * self.decrease;
            ahead + if half_cycle.is_multiple_of(2) { reach } else { -reach }
        };
        let knots = (self.duration / time_step).ceil().max(1.0) as usize;
        (0..=COUNT).flat_map(move |half_cycle| {
            let (from, to) = (if half_cycle == 0 { 0.0 } else { turning(half_cycle - 1) }, turning(half_cycle));
            (1..=knots).map(move |knot| {
                let part = knot as f64 / knots as f64;
                *self.direction * (from + (to - from) * part * part * (3.0 - 2.0 * part))
            })
        })
    }
}

impl Reference {
    /// The reference, followed by an oscillation: its last orientation and its last position across the line stay.
    pub fn with_oscillation(&self, oscillation: &FinalOscillation) -> Self {
        let last = self.at(self.intervals(), 0.0).pose;
        let shifted =
            |shift: Vector3<f64>| Isometry3::from_parts((last.translation.vector + shift).into(), last.rotation);
        self.continued(oscillation.shifts(&last.translation.vector, self.time_step()).map(shifted))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;
    use task::{CostWeights, GraspError, Horizon, Impedance, Inertia, Limits, Pose, TrajectoryCost};

    use super::*;

    const GOAL: Pose = Pose([0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);

    /// Of 12, 9.6, 7.2, 4.8 and 2.4 mm along x.
    fn oscillation() -> FinalOscillation {
        let goal = Vector3::new(GOAL[0], GOAL[1], GOAL[2]);
        FinalOscillation { goal, direction: Vector3::x_axis(), decrease: 2.4e-3, duration: 0.3 }
    }

    fn push() -> Reference {
        let mut start = GOAL;
        start.0[0] = 0.0;
        Reference::straight(&start, &GOAL, Horizon { steps: 20, time_step: 0.02 })
    }

    /// Where a body ends that friction holds anywhere within a band (m) around a reference on the x axis.
    fn end_in_band(reference: &Reference, band: f64) -> f64 {
        let follow = |body: f64, position: [f64; 3]| body.clamp(position[0] - band, position[0] + band);
        reference.positions().fold(0.0, follow)
    }

    #[test]
    fn a_body_ends_near_the_goal_whatever_holds_it() {
        let (plain, reference) = (push(), push().with_oscillation(&oscillation()));
        for band in (0..=13).map(|millimetres| 1e-3 * f64::from(millimetres)) {
            assert!((end_in_band(&reference, band) - GOAL[0]).abs() < 1.21e-3, "{band} m");
            assert!((end_in_band(&plain, band) - GOAL[0] + band).abs() < 1e-12, "short of it without an oscillation");
        }
    }

    #[test]
    fn an_oscillation_continues_a_reference_and_ends_at_the_goal() {
        // It ends 5 mm short of the goal and 1 mm beside it.
        let mut states = push().states();
        let last = states.len() - 1;
        (states[last].0[0], states[last].0[1]) = (GOAL[0] - 5e-3, 1e-3);
        let plain = Reference::new(0.02, &states);
        let reference = plain.with_oscillation(&oscillation());
        assert_eq!(reference.intervals(), 20 + 6 * 15);
        assert_eq!(plain.shared_intervals(&reference), 20);
        let states = reference.states();
        assert!((states[20 + 90][0] - GOAL[0]).abs() < 1e-12 && states[20..].iter().all(|state| state[1] == 1e-3));
        for (knot, reach) in [(20 + 15, 12e-3), (20 + 30, -9.6e-3), (20 + 75, 2.4e-3)] {
            assert!((states[knot][0] - GOAL[0] - reach).abs() < 1e-12);
        }
        for pair in states[20..].windows(2) {
            assert!((pair[1][0] - pair[0][0] - 0.02 * pair[1][7]).abs() < 1e-12, "velocities lead from knot to knot");
        }
    }

    /// A body of 1 kg that is put in along x.
    fn insertion(limits: Limits) -> AssemblyTask {
        let weights = CostWeights {
            translational_velocity: 1.0,
            rotational_velocity: 1.0,
            terminal_position: 1.0,
            terminal_orientation: 1.0,
        };
        let inertia = Inertia::of_body(1.0, Matrix3::from_diagonal_element(0.1));
        let mut start = GOAL;
        start.0[0] = 0.0;
        AssemblyTask {
            impedance: Impedance::critically_damped(1000.0, 20.0, &inertia),
            inertia,
            pairs: Vec::new(),
            frictions: vec![0.0],
            start,
            goal: GOAL,
            grasps: vec![GraspError::default()],
            horizon: Horizon { steps: 20, time_step: 0.02 },
            cost: TrajectoryCost { reference: weights, compliant: weights },
            limits,
        }
    }

    #[test]
    fn they_never_pull_a_body_out_of_what_guides_it() {
        for depth in [1e-4, 1.8e-3, 7.5e-3, 0.02, f64::INFINITY] {
            for position in [5e-4, 3e-3, 0.01] {
                let oscillation =
                    FinalOscillation::new(&insertion(Limits::NONE), &Success { position, ..Success::default() }, depth);
                let reference = push().with_oscillation(&oscillation.unwrap());
                let lowest = reference.positions().skip(20).map(|[x, ..]| x - GOAL[0]).fold(0.0, f64::min);
                let expected = -(0.5 * depth).min(3.2 * position);
                assert!((lowest - expected).abs() < 1e-12, "{lowest} of {expected} m");
            }
        }
        assert_eq!(FinalOscillation::new(&insertion(Limits::NONE), &Success::default(), 0.0), None);
    }

    #[test]
    fn they_start_from_rest_as_well() {
        let rest = Reference::new(0.02, &[GOAL.at_rest()]);
        assert_eq!(rest.with_oscillation(&oscillation()).intervals(), 90);
    }
}

//! Plans played closed loop under injected offsets.

use nalgebra::Vector3;
use task::AssemblyTask;

use crate::contact::ContactFinder;
use crate::dynamics::{Body, Stepper};
use crate::grasp::Grasp;
use crate::parallel::in_parallel;
use crate::reference::{Reference, coordinates, isometry};
use crate::settings::Settings;
use crate::success::Success;

/// A task that is ready to be played.
#[derive(Debug, Clone)]
pub struct Rollout {
    pub(crate) task: AssemblyTask,
    pub(crate) settings: Settings,
    finder: ContactFinder,
}

/// How a rollout ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Final pose of the body (position m, unit quaternion w x y z).
    pub pose: [f64; 7],
    /// Distance of the final position from the goal (m).
    pub position_error: f64,
    /// Angle between the final orientation and the goal (rad).
    pub orientation_error: f64,
    /// Deepest overlap of a pair (m) after any time step, or at the start.
    pub max_penetration: f64,
    /// Largest normal force of a pair (N), the mean over an interval between two knots: an impact has no largest force,
    /// only an impulse.
    pub max_force: f64,
    /// Whether the motion left the range of numbers; nothing else then means anything.
    pub diverged: bool,
}

impl Moment {
    /// Pose and twist in the order of tables and transcriptions.
    pub fn state(&self) -> [f64; 13] {
        let ([x, y, z, w, i, j, k], [vx, vy, vz], [p, q, r]) = (self.pose, self.velocity, self.spin);
        [x, y, z, w, i, j, k, vx, vy, vz, p, q, r]
    }
}

impl Outcome {
    /// Whether it ends at the goal.
    pub fn is(&self, success: &Success) -> bool {
        !self.diverged && success.reached(self.position_error, self.orientation_error)
    }
}

/// A moment of a rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Time since the start (s).
    pub time: f64,
    /// Pose of the body (position m, unit quaternion w x y z).
    pub pose: [f64; 7],
    /// Velocity in the world frame (m/s).
    pub velocity: [f64; 3],
    /// Angular velocity in the body frame (rad/s).
    pub spin: [f64; 3],
}

impl Rollout {
    /// Prepares the shapes of a task.
    pub fn new(task: &AssemblyTask, settings: Settings) -> Self {
        Self { task: task.clone(), settings, finder: ContactFinder::new(&task.pairs) }
    }

    /// Plays a reference once per grasp or offset (m, body frame) on `jobs` threads; outcomes are in their order and do
    /// not depend on the number of threads.
    pub fn simulate<G: Copy + Into<Grasp> + Sync>(
        &self,
        reference: &Reference,
        grasps: &[G],
        jobs: usize,
    ) -> Vec<Outcome> {
        in_parallel(grasps.len(), jobs, |index| self.play(reference, grasps[index], |_, _| {}))
    }

    /// Plays a reference with one grasp or offset (m, body frame) and shows every moment of it: the body starts at rest where the
    /// robot believes to hold it at the reference's start, and the reference is held at its end for the settling time.
    /// With every moment comes the normal impulse (Ns) of every pair since the last knot.
    pub fn play(
        &self,
        reference: &Reference,
        grasp: impl Into<Grasp>,
        mut observe: impl FnMut(&Moment, &[f64]),
    ) -> Outcome {
        let grasp = grasp.into();
        let mut body =
            Body { pose: isometry(&grasp.start(reference)), velocity: Vector3::zeros(), spin: Vector3::zeros() };
        let (reference, impedance) = (&grasp.reference(reference), grasp.impedance(&self.task.impedance));
        let mut finder = self.finder.clone();
        let (time_step, substeps) = self.settings.divide(reference.time_step());
        let mut stepper = Stepper::new(time_step, &self.task.inertia, &impedance, self.settings.friction);
        let offset = Vector3::from(grasp.offset);
        let mut max_penetration = (-finder.find(&body.pose, 0.0)).max(0.0);
        let mut max_impulse = 0.0_f64;
        let mut impulses = vec![0.0; self.task.pairs.len()];
        for interval in 0..reference.intervals() + self.settings.settling_intervals(reference.time_step()) {
            impulses.fill(0.0);
            for substep in 1..=substeps {
                let target = reference.at(interval, substep as f64 / substeps as f64);
                let overlap = stepper.step(&mut body, &target, &offset, &mut finder, &mut impulses);
                max_penetration = max_penetration.max(overlap);
                observe(&moment((interval * substeps + substep) as f64 * time_step, &body), &impulses);
            }
            max_impulse = impulses.iter().copied().fold(max_impulse, f64::max);
            if !is_finite(&body) {
                break;
            }
        }
        let pose = coordinates(&body.pose);
        let (position_error, orientation_error) = task::pose::errors(&pose, &self.task.goal);
        Outcome {
            pose,
            position_error,
            orientation_error,
            max_penetration,
            max_force: max_impulse / reference.time_step(),
            diverged: !is_finite(&body),
        }
    }
}

fn moment(time: f64, body: &Body) -> Moment {
    Moment { time, pose: coordinates(&body.pose), velocity: body.velocity.into(), spin: body.spin.into() }
}

fn is_finite(body: &Body) -> bool {
    coordinates(&body.pose).iter().chain(&body.velocity).chain(&body.spin).all(|number| number.is_finite())
}

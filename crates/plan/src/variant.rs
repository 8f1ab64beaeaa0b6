//! A planning problem as it is really solved: the scene's own, or one that was changed to give more margin.

use simulation::{Reference, Rollout, Settings};
use task::{AssemblyTask, HomotopySettings, Trajectory};

use crate::problem::Problem;

/// A task and settings to solve.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The task to be planned.
    pub task: AssemblyTask,
    /// How.
    pub settings: HomotopySettings,
    /// The motion from which the homotopy starts, instead of rest at the start pose.
    pub near: Option<Trajectory>,
}

/// Part of the limit of contact forces that plans may use. Their forces are means over a time step; a rollout, and a
/// robot, may push harder for 10 ms.
const FORCE_SHARE: f64 = 0.7;

impl Variant {
    /// The scene as it is, with a margin of contact forces.
    pub fn of_scene(problem: &Problem) -> Self {
        let mut task = problem.task().clone();
        task.limits.contact_force *= FORCE_SHARE;
        Self { task, settings: problem.homotopy().clone(), near: None }
    }

    /// The same, but its homotopy starts from the motions that a reference leads to, on all time steps.
    pub fn started_from(self, reference: &Reference) -> Self {
        let Self { task, settings, .. } = self;
        let grasps: Vec<_> = task.scenarios().iter().map(|scenario| scenario.grasp).collect();
        let rollout = Rollout::new(&task, Settings::default());
        let is_fitting = reference.horizon() == task.horizon;
        let reference = if is_fitting { reference.clone() } else { reference.on(task.horizon) };
        let near = Some(rollout.trajectory(&reference, &grasps, settings.tau));
        Self { task, settings: HomotopySettings { coarse_iterations: 0, ..settings }, near }
    }
}

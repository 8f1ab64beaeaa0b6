//! Whether an arm's controller answers in time.

use nalgebra::{Cholesky, Matrix6};
use plan::Problem;
use task::AssemblyTask;

/// A warning where the controller of the scene's arm answers too late for its damping.
pub fn delay(problem: &Problem) -> Option<String> {
    let robot = problem.scene().robot.as_ref().filter(|_| problem.scene().position_robot.is_none())?;
    let delay = robot.control_period + problem.scene().robustness.delay;
    let rate = fastest_damping(problem.task())?;
    (delay * rate > 1.0).then(|| {
        format!(
            "the damping stops the arm's lightest motion within {:.1} ms, and the controller answers after {:.1} ms: the arm \
             may oscillate; lower impedance.rotational_stiffness or the damping, or shorten robot.control_period",
            1e3 / rate,
            1e3 * delay
        )
    })
}

/// The fastest rate (1/s) at which damping alone stops a motion: the largest eigenvalue of `M^-1 D`.
fn fastest_damping(task: &AssemblyTask) -> Option<f64> {
    let mut damping = Matrix6::zeros();
    damping.fixed_view_mut::<3, 3>(0, 0).copy_from(&task.impedance.translational_damping);
    damping.fixed_view_mut::<3, 3>(3, 3).copy_from(&task.impedance.rotational_damping);
    let lower = Cholesky::new(*task.inertia.matrix())?.l();
    let half = lower.solve_lower_triangular(&damping)?;
    let ratio = lower.solve_lower_triangular(&half.transpose())?;
    Some((ratio + ratio.transpose()).symmetric_eigenvalues().max() / 2.0)
}

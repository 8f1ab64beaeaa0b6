//! Whether a robot that is commanded by position or force yields fast enough.

use plan::Problem;
use scene::LARGEST_FORCE;

/// Part of the force that may shift the part against damping; the stiffness needs the rest.
const SHARE: f64 = 0.5;

/// A warning where contacts within the force limit do not shift the part by the largest offset within the horizon, against the
/// damping that makes the law stable.
pub fn sliding(problem: &Problem) -> Option<String> {
    let robot = problem.scene().position_robot.as_ref()?;
    let (task, damping) = (problem.task(), robot.gains.damping[0]);
    let duration = task.horizon.steps as f64 * task.horizon.time_step;
    let force = if task.limits.contact_force.is_finite() { task.limits.contact_force } else { LARGEST_FORCE };
    let needed = problem.offset_magnitude() * damping / (SHARE * force);
    let suffices = needed <= duration;
    (!suffices).then(|| {
        format!(
            "against {damping:.0} Ns/m, which a contact of {:.0} N/m with a lag of {:.1} ms needs, {:.0} N shift the part by {:.1} mm \
             in {needed:.1} s, and the plan lasts {duration:.1} s: give [horizon] more time, or make the contact softer, the delay \
             shorter or the bandwidth larger",
            robot.contact_stiffness,
            1e3 * robot.contact_loop().lag(),
            SHARE * force,
            1e3 * problem.offset_magnitude(),
        )
    })
}

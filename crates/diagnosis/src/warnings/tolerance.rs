//! Whether the position tolerance separates an assembled body from one that is not.

use plan::Problem;
use plan::directions::axis_name;

/// A tolerance within which the start is, or beyond the depth of engagement, and offsets along free directions beyond the
/// tolerance.
pub fn warnings(problem: &Problem) -> Vec<String> {
    [success_at_start(problem), unassembled_success(problem), free_offset(problem)].into_iter().flatten().collect()
}

fn success_at_start(problem: &Problem) -> Option<String> {
    let (tolerance, task) = (problem.success().position, problem.task());
    let path = task.start.error(&task.goal);
    (path.position <= tolerance && path.orientation <= problem.success().orientation).then(|| {
        format!(
            "the start is {:.2} mm from the goal, within the tolerance of {:.2} mm, so that a body that never moves is a \
             success: move the start, or lower position_tolerance in [goal] or --position-tolerance",
            1e3 * path.position,
            1e3 * tolerance
        )
    })
}

fn unassembled_success(problem: &Problem) -> Option<String> {
    let (tolerance, depth) = (problem.success().position, problem.engagement().depth_m?);
    (tolerance >= depth).then(|| {
        format!(
            "{:.2} mm from the goal the part is not engaged yet; a tolerance of {:.2} mm calls that a success: lower \
             position_tolerance in [goal] or --position-tolerance, to {:.2} mm or less",
            1e3 * depth,
            1e3 * tolerance,
            1e3 * 0.25 * depth
        )
    })
}

/// An offset along a direction in which nothing guides the body stays, with any plan.
pub fn free_offset(problem: &Problem) -> Option<String> {
    let (tolerance, engagement) = (problem.success().position, problem.engagement());
    let offset = engagement.free_offset(problem.task(), &problem.scene().coverage);
    let names: Vec<String> = engagement.free.iter().map(axis_name).collect();
    let axes = names.join(" and ");
    (offset > tolerance).then(|| {
        format!(
            "nothing guides the body along {axes} at its goal: an offset of {:.2} mm along {axes} stays, more than the \
             tolerance of {:.2} mm: raise the tolerance above it, add a stop, or leave {axes} out of \
             robustness.offset_directions",
            1e3 * offset,
            1e3 * tolerance
        )
    })
}

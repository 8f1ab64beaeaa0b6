//! Why no plan can be made of a scene, as far as that is certain.

use nalgebra::Vector3;
use plan::Problem;
use task::AssemblyTask;

use crate::check::clear_path::{self, ClearPath};
use crate::check::penetrations::{deepest, largest_fit, start_inside};

/// Distance from the goal within which something must be: in offsets, where something guides the body and where nothing
/// does, and in sizes of the body.
const REACH_IN_OFFSETS: f64 = 3.0;
const UNGUIDED_REACH_IN_OFFSETS: f64 = 1.0;
const REACH_IN_SIZES: f64 = 0.1;
/// Angle (rad) between start and goal above which the body rotates on its path.
const TURNED: f64 = 1e-3;

/// Refusal where no plan can exist: the body starts inside the environment, its goal is inside it, out of reach,
/// enclosed, or too tight to be left. The message names parts and distances, and what to do. `None` where a plan may
/// exist.
pub fn refusal(problem: &Problem) -> Option<String> {
    start_inside(problem).or_else(|| goal_inside(problem)).or_else(|| not_assembled(problem)).or_else(|| {
        // With strong smoothing and rotations there may be a plan that the search does not find.
        let rotation = problem.task().start.error(&problem.task().goal).orientation;
        if rotation > TURNED {
            return None;
        }
        let path = clear_path::find(problem.task());
        enclosed(&path).or_else(|| press_fit(problem, &path))
    })
}

/// The body penetrates the environment at its goal by more than a plan that is done may, and no path leads out.
fn press_fit(problem: &Problem, path: &ClearPath) -> Option<String> {
    let (pair, depth) =
        deepest(problem.task(), &problem.task().goal).filter(|_| matches!(path, ClearPath::None { .. }))?;
    (depth > problem.allowed_penetration()).then(|| {
        format!(
            "[goal]: {pair} penetrate there by {:.3} mm, and no path in clearance leads away from it: parts need clearance; a press \
             fit cannot be planned, and of parts that CAD draws as large as their holes, `clearance` of a mesh states the fit",
            1e3 * depth
        )
    })
}

/// The goal lies in the environment, deeper than a fit explains.
fn goal_inside(problem: &Problem) -> Option<String> {
    let (pair, depth) = deepest(problem.task(), &problem.task().goal)?;
    let most = largest_fit(problem);
    (depth > most).then(|| {
        format!(
            "[goal]: {pair} penetrate there by {:.3} mm, more than the {:.3} mm that a tight fit or rounding explains, so that \
             the goal cannot be reached: move [goal] out of the environment, or export both files in the assembled pose",
            1e3 * depth,
            1e3 * most
        )
    })
}

/// Nothing is near the body at its goal.
fn not_assembled(problem: &Problem) -> Option<String> {
    let norm = |offset: [f64; 3]| Vector3::from(offset).norm();
    let offset = problem.task().offsets().into_iter().map(norm).fold(0.0, f64::max);
    let reach = match problem.engagement().depth_m {
        Some(_) => (REACH_IN_OFFSETS * offset).max(REACH_IN_SIZES * problem.scene().body_size()),
        None => UNGUIDED_REACH_IN_OFFSETS * offset,
    };
    let world = AssemblyTask { pairs: problem.scene().all_pairs(), ..problem.task().clone() };
    let (pair, depth) = deepest(&world, &world.goal)?;
    (-depth > reach).then(|| {
        format!(
            "nothing is near the body at its goal: the nearest parts, {pair}, are {:.1} mm apart, and no offset or clearance is \
             larger than {:.1} mm; the parts are not assembled: export both files in one frame, in the assembled pose; a scene \
             can also move its [goal]",
            -1e3 * depth,
            1e3 * reach
        )
    })
}

/// The environment that keeps the body from leaving its goal, if a search has shown that.
pub fn enclosed(path: &ClearPath) -> Option<String> {
    let ClearPath::Enclosed { farthest_m } = path else { return None };
    Some(format!(
        "the goal cannot be reached without rotation: the environment encloses the body there, which gets no farther away than \
         {:.2} mm; check the goal, the fit and the axis of insertion",
        1e3 * farthest_m
    ))
}

//! Penetrations of body and environment before the body moves.

use plan::Problem;
use serde::Serialize;
use task::{AssemblyTask, GraspError, Pose};

/// Penetration (m) that rounding of poses and meshes explains.
const ROUNDING: f64 = 1e-4;
/// Penetration at the goal that a fit, rounding and facets explain: at least (m), and in sizes of the body.
const FIT: f64 = 1e-4;
const FIT_IN_SIZES: f64 = 2e-3;

/// A pair that penetrates at a pose of the scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PosePenetration {
    /// `goal`, or `start` with the number of an offset, from 1.
    pub pose: String,
    /// Body and environment part.
    pub pair: String,
    /// Exact distance, negative.
    pub distance_m: f64,
}

/// Refusal where the body is inside the environment at its start, with every planned grasp error; `None` if it is not.
pub fn start_inside(problem: &Problem) -> Option<String> {
    let task = problem.task();
    let depths = task.grasps.iter().map(|grasp| deepest(task, &grasp.actual(&task.start)));
    let depths: Vec<(String, f64)> = depths.collect::<Option<_>>()?;
    if depths.iter().any(|(_, depth)| *depth <= ROUNDING) {
        return None;
    }
    let (number, (pair, depth)) = (1..).zip(&depths).max_by(|(_, one), (_, other)| one.1.total_cmp(&other.1))?;
    let is_free = deepest(task, &task.start).is_none_or(|(_, depth)| depth <= ROUNDING);
    let cure = if is_free {
        "without an offset it is not: lower robustness.offset_magnitude, or move the start away from the environment"
    } else {
        "move the start to the side from which the body is put in (`--axis` of `new`), or exchange body and environment if \
         they are confused"
    };
    Some(format!(
        "[[start]] \"{}\": the body begins inside of the environment with every offset, {:.3} mm deep with offset {number} \
         ({pair}); {cure}",
        problem.start().name,
        1e3 * depth,
    ))
}

/// The pair that penetrates most at a pose, and how deep (m); negative where none does.
pub fn deepest(task: &AssemblyTask, pose: &Pose) -> Option<(String, f64)> {
    let depths = task.pairs.iter().map(|pair| (pair, -pair.shapes.exact_distance(pose)));
    depths.max_by(|one, other| one.1.total_cmp(&other.1)).map(|(pair, depth)| (pair.to_string(), depth))
}

/// Largest penetration at the goal (m) that a fit explains.
pub fn largest_fit(problem: &Problem) -> f64 {
    FIT.max(FIT_IN_SIZES * problem.scene().body_size())
}

/// Pairs that penetrate at the goal and at the actual start: with every offset, and also rotated in the gripper (rad)
/// about each axis of the body, both ways.
pub fn penetrations(task: &AssemblyTask, rotation_error: f64) -> Vec<PosePenetration> {
    let mut poses = vec![("goal".to_owned(), task.goal)];
    for (number, grasp) in (1..).zip(&task.grasps) {
        let name = format!("start with offset {number}");
        poses.push((name.clone(), grasp.actual(&task.start)));
        for (axis, about) in ["x", "y", "z"].iter().enumerate().filter(|_| rotation_error > 0.0) {
            for (sign, angle) in [("+", rotation_error), ("-", -rotation_error)] {
                let mut turned = GraspError::from(grasp.offset);
                turned.rotation[axis] = angle;
                poses.push((format!("{name}, rotated about {sign}{about}"), turned.actual(&task.start)));
            }
        }
    }
    let mut penetrations = Vec::new();
    for (pose, at) in poses {
        for pair in &task.pairs {
            let distance_m = pair.shapes.exact_distance(&at);
            if distance_m < 0.0 {
                penetrations.push(PosePenetration { pose: pose.clone(), pair: pair.to_string(), distance_m });
            }
        }
    }
    penetrations
}

/// The deepest penetration at the goal and the deepest at the start, and what to do about them.
pub fn warnings(problem: &Problem) -> Vec<String> {
    let penetrations = penetrations(problem.task(), problem.scene().robustness.rotation_error);
    let (at_goal, at_start): (Vec<_>, Vec<_>) =
        penetrations.into_iter().partition(|penetration| penetration.pose == "goal");
    let goal = if largest_penetration(&at_goal) > largest_fit(problem) {
        "it cannot be reached: move [goal] out of the environment, or export both files in the assembled pose"
    } else {
        "where CAD is size on size, state the fit by `clearance` of a mesh"
    };
    let start = "move that start, or lower robustness.offset_magnitude";
    let is_inside = start_inside(problem);
    let at_start = if is_inside.is_some() { is_inside } else { warning(&at_start, start) };
    warning(&at_goal, goal).into_iter().chain(at_start).collect()
}

fn largest_penetration(penetrations: &[PosePenetration]) -> f64 {
    penetrations.iter().map(|penetration| -penetration.distance_m).fold(0.0, f64::max)
}

fn warning(penetrations: &[PosePenetration], cure: &str) -> Option<String> {
    let worst = penetrations.iter().min_by(|one, other| one.distance_m.total_cmp(&other.distance_m))?;
    let PosePenetration { pose, pair, distance_m } = worst;
    Some(format!("{pair} penetrate by {:.3} mm at the {pose}, the deepest of all pairs; {cure}", -1e3 * distance_m))
}

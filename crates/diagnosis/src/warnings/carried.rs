//! Whether the arm and the gripper meet the environment before anything is planned.

use nalgebra::Isometry3;
use plan::Problem;
use plan::carried::{CarriedWorld, Frames};
use task::pose::interpolate;

/// Poses between goal and start that are looked at without an arm.
const POSES: usize = 20;

/// The deepest penetration on the straight path from the goal to the start.
pub fn warning(problem: &Problem) -> Option<String> {
    let scene = problem.scene();
    let world = CarriedWorld::new(scene)?;
    let course = straight(problem)?;
    let meeting = world.meeting(&course)?;
    let last = course.len() - 1;
    let place = match meeting.at {
        0 => "at the goal".to_owned(),
        at if at == last => "at the start".to_owned(),
        at => {
            let [goal, start] = [&scene.goal, &problem.start().pose].map(|pose| pose.isometry().translation.vector);
            let distance = (goal - start).norm() * at as f64 / last as f64;
            format!("{:.1} mm from the goal on the straight path to the start", 1e3 * distance)
        }
    };
    Some(format!("{meeting} {place}: {}", world.advice()))
}

/// Frames from the goal to the start.
fn straight(problem: &Problem) -> Option<Vec<Frames>> {
    let (scene, start) = (problem.scene(), problem.start());
    let index = scene.starts.iter().position(|other| other.name == start.name)?;
    match &scene.robot {
        Some(robot) => Some(Frames::along(robot, &robot.ways.get(index)?.configurations)),
        None => {
            let [goal, start]: [Isometry3<f64>; 2] = [scene.goal.isometry(), start.pose.isometry()];
            let pose = |index: usize| interpolate(&goal, &start, index as f64 / (POSES - 1) as f64);
            Some((0..POSES).map(|index| Frames::of_body(pose(index))).collect())
        }
    }
}

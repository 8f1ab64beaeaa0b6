//! Whether an arm can move as a plan asks it to, and whether it or its gripper meets the environment then.

use plan::carried::{CarriedWorld, Frames};
use plan::{ArmCourse, Plan};
use scene::Robot;
use task::ScenarioTrajectory;

/// Poses, speeds and torques that the arm cannot have, in the motions of all scenarios, and where it or the gripper meets the
/// environment.
pub fn warnings(plan: &Plan) -> Vec<String> {
    let Some(robot) = &plan.problem.scene().robot else {
        let believed = |scenario: &ScenarioTrajectory| {
            let grasp = scenario.grasp.believed();
            scenario.states.iter().map(|state| Frames::of_body(state.pose().isometry() * grasp)).collect()
        };
        return meeting(plan, plan.trajectory.scenarios.iter().map(believed)).into_iter().collect();
    };
    let trajectory = &plan.trajectory;
    let course = |scenario: &task::ScenarioTrajectory| {
        ArmCourse::new(robot, trajectory.time_step, &scenario.grasp, &scenario.states, &scenario.wrenches)
    };
    let courses: Result<Vec<ArmCourse>, _> = trajectory.scenarios.iter().map(course).collect();
    match courses {
        Ok(courses) => {
            let frames = |course: &ArmCourse| Frames::along(robot, &course.configurations);
            let meeting = meeting(plan, courses.iter().map(frames));
            torque(robot, trajectory.time_step, &courses).into_iter().chain(meeting).collect()
        }
        Err(error) => vec![format!(
            "the arm cannot follow the plan: {error}; change robot.configuration or robot.base, or give [horizon] more steps"
        )],
    }
}

/// The deepest penetration of the arm or the gripper with the environment in any scenario.
fn meeting(plan: &Plan, courses: impl Iterator<Item = Vec<Frames>>) -> Option<String> {
    let world = CarriedWorld::new(plan.problem.scene())?;
    let meetings = (1..).zip(courses).filter_map(|(scenario, course)| Some((scenario, world.meeting(&course)?)));
    let (scenario, meeting) = meetings.max_by(|(_, one), (_, other)| one.depth.total_cmp(&other.depth))?;
    Some(format!(
        "{meeting} at {:.2} s of scenario {scenario}: {}",
        meeting.at as f64 * plan.trajectory.time_step,
        world.advice()
    ))
}

/// The joint whose torque exceeds its limit most.
fn torque(robot: &Robot, time_step: f64, courses: &[ArmCourse]) -> Option<String> {
    let mut worst: Option<(f64, usize, f64, usize)> = None;
    for (step, torques) in courses.iter().flat_map(|course| course.torques.iter().enumerate()) {
        for (joint, limits) in robot.arm.joints().iter().enumerate() {
            let share = torques[joint].abs() / limits.effort;
            if share > worst.map_or(1.0, |(largest, ..)| largest) {
                worst = Some((share, joint, torques[joint].abs(), step));
            }
        }
    }
    let (_, joint, torque, step) = worst?;
    let joint = &robot.arm.joints()[joint];
    Some(format!(
        "joint `{}` would need {torque:.1} at {:.2} s, and its limit is {:.1} (Nm or N): lower impedance or \
         robustness.offset_magnitude",
        joint.name,
        step as f64 * time_step,
        joint.effort
    ))
}

//! Whether an arm can move as a plan asks it to.

use scene::Robot;

use crate::arm_course::ArmCourse;
use crate::plan::Plan;

/// Poses, speeds and torques that the arm cannot have, in the motions of all scenarios; nothing without an arm.
pub fn warnings(plan: &Plan) -> Vec<String> {
    let Some(robot) = &plan.problem.scene().robot else { return Vec::new() };
    let trajectory = &plan.trajectory;
    let course = |scenario: &task::ScenarioTrajectory| {
        ArmCourse::new(robot, trajectory.time_step, &scenario.grasp, &scenario.states, &scenario.wrenches)
    };
    let courses: Result<Vec<ArmCourse>, _> = trajectory.scenarios.iter().map(course).collect();
    match courses {
        Ok(courses) => torque(robot, trajectory.time_step, &courses).into_iter().collect(),
        Err(error) => vec![format!(
            "the arm cannot follow the plan: {error}; change robot.configuration or robot.base, or give [horizon] more steps"
        )],
    }
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

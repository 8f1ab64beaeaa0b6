//! Executions, beside rollouts with the same grasp errors.

use std::path::{Path, PathBuf};

use plan::{PlannerError, Problem, RobustnessTarget};
use simulation::{Reference, Settings};
use store::{Ending, ExecutedState, Execution, StoredPlan};
use task::{GraspError, Pose, ScenarioTrajectory, State, Trajectory, Twist, Wrench};

use super::motion::{HARD, Measures, World};
use crate::model::{ExecutionData, MotionData, Source};
use crate::rounded::{FORCE, LENGTH, rounded};

/// The motions of logs.
///
/// # Errors
/// When a log cannot be compared with the plan.
pub fn motions(
    logs: &[PathBuf],
    plan: &StoredPlan,
    problem: &Problem,
    world: &World,
) -> Result<Vec<MotionData>, PlannerError> {
    logs.iter().map(|log| motion(log, name(log, logs), plan, problem, world)).collect()
}

/// The end of a path that no other one has.
fn name(log: &Path, logs: &[PathBuf]) -> String {
    let end = |path: &Path, count: usize| -> PathBuf {
        let parts: Vec<_> = path.components().collect();
        parts[parts.len().saturating_sub(count)..].iter().collect()
    };
    let is_unique = |count: &usize| logs.iter().filter(|other| end(other, *count) == end(log, *count)).count() == 1;
    let count = (1..log.components().count()).find(is_unique).unwrap_or(log.components().count());
    end(log, count).display().to_string()
}

/// The motion of a log. Its first scenario is the robot, its second one the rollout that is closest to it, at one of
/// the scene's frictions.
fn motion(
    log: &Path,
    name: String,
    plan: &StoredPlan,
    problem: &Problem,
    world: &World,
) -> Result<MotionData, PlannerError> {
    let frictions = RobustnessTarget::of(&problem.scene().robustness).frictions;
    let settings: Vec<Settings> =
        frictions.into_iter().map(|friction| Settings { friction, ..Settings::default() }).collect();
    let execution = Execution::read(log, problem, plan, &settings)?;
    let reference = with_rest(&plan.reference()?, execution.duration());
    let settings = Settings { friction: execution.friction, ..Settings::default() };
    let mut played = problem.rollout(settings)?.trajectory(&reference, &[execution.grasp], HARD);
    let (time_step, duration) = (reference.time_step(), execution.duration());
    // A robot that was stopped is shown until then.
    let knots = 0..=(duration / time_step).ceil() as usize;
    let states: Vec<(ExecutedState, f64)> =
        knots.map(|knot| execution.at(duration.min(knot as f64 * time_step))).collect();
    played.scenarios.insert(0, robot(problem, &execution.grasp, &played, &states));
    let measures: Vec<Measures> = played.scenarios.iter().map(|scenario| Measures::from(&scenario.quality)).collect();
    let mut motion = world.motion(&world.tables(played), &measures, Source::Executed, HARD)?;
    let beside = motion.scenarios[1].clone();
    let robot = &mut motion.scenarios[0];
    // A robot need not start exactly at its reference, and does not measure where parts touch.
    (robot.offset, robot.rotation) = (beside.offset, beside.rotation);
    robot.success = execution.ending == Ending::AtGoal;
    robot.forces.clear();
    robot.max_force = f64::NAN;
    robot.measured = measured(&states);
    motion.execution = Some(ExecutionData {
        log: name,
        friction: execution.friction,
        stopped: matches!(execution.ending, Ending::Stopped(_)).then_some(duration),
        sentences: execution.sentences(),
        distances: states.iter().map(|(_, distance)| rounded(*distance, LENGTH)).collect(),
    });
    Ok(motion)
}

/// A reference that is held at its end until a time (s).
fn with_rest(reference: &Reference, time: f64) -> Reference {
    let mut states = reference.states();
    let knots = 1 + (time / reference.time_step()).ceil() as usize;
    let end = states[states.len() - 1].pose().at_rest();
    states.resize(knots.max(states.len()), end);
    Reference::new(reference.time_step(), &states)
}

/// The motion of the part in the robot's gripper, with the wrench of the plan's controller there. The contact forces
/// are unknown.
fn robot(
    problem: &Problem,
    grasp: &GraspError,
    beside: &Trajectory,
    states: &[(ExecutedState, f64)],
) -> ScenarioTrajectory {
    let actual: Vec<State> = states.iter().map(|(state, _)| actual(grasp, &state.believed)).collect();
    let world = problem.world();
    let unknown = |_| std::iter::repeat_n(0.0, world.pairs.len());
    let reference = &beside.reference[..actual.len()];
    ScenarioTrajectory::new(&world, *grasp, beside.time_step, reference, &actual, unknown, HARD)
}

/// State of a part that is believed to be in another one.
fn actual(grasp: &GraspError, believed: &State) -> State {
    let pose = grasp.actual(&believed.pose());
    let twist = believed.twist();
    let spin = believed.pose().orientation() * twist.angular_velocity();
    let lever = pose.position() - believed.pose().position();
    let velocity = twist.velocity() + spin.cross(&lever);
    let twist = Twist::new(&velocity, &(grasp.quaternion() * twist.angular_velocity()));
    State::new(&Pose::from(&pose.isometry()), &twist)
}

/// Wrenches from the first step on, none if the log has no column for them.
fn measured(states: &[(ExecutedState, f64)]) -> Vec<f64> {
    let wrenches: Option<Vec<Wrench>> = states[1..].iter().map(|(state, _)| state.wrench).collect();
    wrenches.unwrap_or_default().iter().flat_map(|wrench| wrench.0).map(|component| rounded(component, FORCE)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logs_have_the_shortest_names_that_differ() {
        let logs = ["a/executed.csv", "b/executed.csv", "/c/b/dry.csv"].map(PathBuf::from);
        let names: Vec<String> = logs.iter().map(|log| name(log, &logs)).collect();
        assert_eq!(names, ["a/executed.csv", "b/executed.csv", "dry.csv"]);
        let twice = [logs[0].clone(), logs[0].clone()];
        assert_eq!(name(&twice[0], &twice), "a/executed.csv");
    }

    #[test]
    fn the_part_moves_with_the_gripper() {
        let grasp = GraspError { offset: [0.0, 0.1, 0.0], rotation: [0.0; 3] };
        let mut believed = Pose([1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0]).at_rest();
        believed.0[12] = 0.5;
        let actual = actual(&grasp, &believed);
        assert_eq!(actual[..3], [1.0, 1.9, 3.0]);
        // Turning about z, a part below the believed one moves along x.
        assert!((actual[7] - 0.05).abs() < 1e-12 && actual[12] == 0.5, "{actual:?}");
    }
}

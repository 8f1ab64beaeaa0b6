//! Scenarios that miss the goal.

use plan::Plan;
use plan::records::{GraspRecord, MotionEnd};
use serde::{Deserialize, Serialize};
use task::ScenarioTrajectory;

/// A scenario that misses the goal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StuckScenario {
    /// The scenario, from 1.
    pub scenario: usize,
    /// Its grasp error.
    #[serde(flatten)]
    pub grasp: GraspRecord,
    /// How its motion ends.
    pub end: MotionEnd,
}

/// The scenarios of a plan that miss the goal.
pub fn of_plan(plan: &Plan) -> Vec<StuckScenario> {
    let success = plan.problem.success();
    let missed = (1..)
        .zip(&plan.trajectory.scenarios)
        .filter(|(_, motion)| !success.reached(motion.quality.position_error, motion.quality.orientation_error));
    let stuck = |(scenario, motion): (usize, &ScenarioTrajectory)| StuckScenario {
        scenario,
        grasp: GraspRecord::from(&motion.grasp),
        end: MotionEnd::new(&plan.task, motion, plan.trajectory.time_step, &success),
    };
    missed.map(stuck).collect()
}

impl std::fmt::Display for StuckScenario {
    /// A sentence without its full stop.
    fn fmt(&self, formatter: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(formatter, "scenario {} ({}) {}", self.scenario, self.grasp, self.end)
    }
}

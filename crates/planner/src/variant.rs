//! A planning problem as it is really solved: the scene's own, or one that was changed to give more margin.

use task::{AssemblyTask, HomotopySettings, Trajectory};

use crate::problem::Problem;

/// A task and settings to solve, and what makes them differ from the scene's own.
#[derive(Debug, Clone)]
pub struct Variant {
    /// What is planned.
    pub task: AssemblyTask,
    /// How.
    pub settings: HomotopySettings,
    /// The motion at which the homotopy begins, instead of rest at the start pose.
    pub near: Option<Trajectory>,
    /// In words.
    pub name: String,
}

impl Variant {
    /// The scene as it is.
    pub fn of_scene(problem: &Problem) -> Self {
        Self {
            task: problem.task().clone(),
            settings: problem.homotopy().clone(),
            near: None,
            name: "the scene as it is".to_owned(),
        }
    }
}

//! What several commands ask: what to plan, and what counts as success.

use std::path::PathBuf;

use clap::Args;
use planner::Choices;

use crate::values;

/// What to plan.
#[derive(Debug, Args)]
pub struct TaskArguments {
    /// Scene file (TOML)
    pub scene: PathBuf,
    /// Name of the start pose [default: the scene's first]
    #[arg(long, value_name = "NAME")]
    pub start: Option<String>,
    /// Offset magnitude delta-hat in metres [default: the scene's]
    #[arg(long, value_name = "M")]
    pub delta: Option<f64>,
}

/// What counts as success.
#[derive(Debug, Args)]
pub struct ToleranceArguments {
    /// Largest final position error of a success (m) [default: the scene's]
    #[arg(long, value_name = "M", value_parser = values::of_key("goal.position_tolerance"))]
    pub position_tolerance: Option<f64>,
    /// Largest final angle to the goal of a success (rad) [default: the scene's]
    #[arg(long, value_name = "RAD", value_parser = values::of_key("goal.angle_tolerance"))]
    pub angle_tolerance: Option<f64>,
}

impl TaskArguments {
    /// Choices for the scene.
    pub fn choices(&self) -> Choices {
        Choices { start: self.start.clone(), offset_magnitude: self.delta, ..Choices::default() }
    }
}

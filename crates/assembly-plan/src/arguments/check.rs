//! What the user can say about a check.

use clap::Args;
use task::Pose;

use crate::arguments::task::TaskArguments;
use crate::values;

#[derive(Debug, Args)]
pub struct CheckArguments {
    #[command(flatten)]
    pub task: TaskArguments,
    /// Report every pair's distances at this pose: position (m) and quaternion
    #[arg(long, value_name = "\"x y z qw qx qy qz\"", allow_hyphen_values = true, value_parser = values::pose)]
    pub pose: Option<Pose>,
    /// Smoothing of the distances [default: the first of the scene's homotopy]
    #[arg(long, value_name = "T")]
    pub tau: Option<f64>,
    /// Print everything as JSON
    #[arg(long)]
    pub json: bool,
    /// List all parts and pieces of meshes
    #[arg(long, conflicts_with_all = ["json", "pose"])]
    pub verbose: bool,
    /// Exit with 1 where there is a warning
    #[arg(long)]
    pub strict: bool,
}

//! What the user can say about a new scene.

use std::path::PathBuf;

use clap::Args;
use scene_templates::Axis;

use crate::values;

#[derive(Debug, Args)]
pub struct NewArguments {
    /// Scene file to write; paths in it are relative to its folder
    pub file: PathBuf,
    /// STL or OBJ mesh, or SDF, URDF or MJCF model of the body, in its goal pose [default: a square shaft and its hole]
    #[arg(long, value_name = "FILE", requires = "environment")]
    pub body: Option<PathBuf>,
    /// Mesh or model of the environment, in the same frame
    #[arg(long, value_name = "FILE", requires = "body")]
    pub environment: Option<PathBuf>,
    /// Unit of the mesh files, required for STL and OBJ
    #[arg(long, value_name = "UNIT", value_parser = values::unit(), requires_all = ["body", "environment"])]
    pub unit: Option<String>,
    /// Direction in which the body is taken out, opposite to the insertion [default: the direction in which it can
    /// be pulled out and whose opposite ends at a stop]
    #[arg(long, value_name = "AXIS", value_parser = values::axis(), ignore_case = true, allow_hyphen_values = true)]
    #[arg(requires = "body")]
    pub axis: Option<Axis>,
    /// Link of the body's model, if it has several
    #[arg(long, value_name = "NAME", requires = "body")]
    pub link: Option<String>,
    /// Link of the environment's model, if it has several
    #[arg(long, value_name = "NAME", requires = "environment")]
    pub environment_link: Option<String>,
    /// How far the body may be off in the gripper (m) [default: 0.001, with meshes or models]
    #[arg(long, value_name = "M", value_parser = values::of_key("robustness.offset_magnitude"))]
    pub offset: Option<f64>,
    /// Largest final position error of a success (m) [default: a quarter of the engagement depth, at most 0.003]
    #[arg(long, value_name = "M", value_parser = values::of_key("goal.position_tolerance"))]
    pub position_tolerance: Option<f64>,
    /// Largest contact force of a plan (N) [default: 60]
    #[arg(long, value_name = "N", value_parser = values::of_key("limits.contact_force"))]
    pub contact_force: Option<f64>,
    /// Replace the file if it exists
    #[arg(short, long)]
    pub force: bool,
}

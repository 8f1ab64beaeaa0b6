//! What the user can say about a calibration.

use std::path::PathBuf;

use clap::Args;

use crate::values::jobs;

#[derive(Debug, Args)]
pub struct CalibrateArguments {
    /// Scene file (TOML) of the plans
    pub scene: PathBuf,
    /// Tables that players of an export wrote: of dry runs, and of runs in which the parts touched
    #[arg(value_name = "LOG", required = true)]
    pub logs: Vec<PathBuf>,
    /// Write a copy of the scene with the fitted entries to this file [default: print the entries]
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// With --out: replace the file if it exists
    #[arg(short, long, requires = "out")]
    pub force: bool,
    /// Fit rotor inertia and friction of each joint, not of all in the proportions of the scene
    #[arg(long)]
    pub per_joint: bool,
    /// Print everything as JSON
    #[arg(long)]
    pub json: bool,
    /// Number of threads; does not affect the result [default: one per processor]
    #[arg(short, long, value_name = "N", value_parser = jobs)]
    pub jobs: Option<u16>,
    /// Print no progress: standard error has only warnings and errors
    #[arg(short, long)]
    pub quiet: bool,
}

//! What the user can say about an export.

use std::path::PathBuf;

use clap::Args;
use export::Target;

use crate::values;

#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Folder that `solve` wrote
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Target
    #[arg(long, value_name = "TARGET", value_parser = values::target())]
    pub to: Target,
    /// Samples of the motion per second (Hz)
    #[arg(long, value_name = "HZ", default_value_t = 500.0, value_parser = values::rate)]
    pub rate: f64,
    /// Folder to write; an earlier export in it is replaced [default: DIR/export/TARGET]
    #[arg(short, long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Also export a plan that did not converge, or succeeds too rarely in rollouts
    #[arg(long)]
    pub anyway: bool,
}

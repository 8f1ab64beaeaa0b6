//! What the user can say about a page.

use std::path::PathBuf;

use clap::Args;

#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Folder that `solve`, `batch`, `simulate` or `tolerance` wrote
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Also show an execution, logged by an exported player, beside a rollout that has the same grasp error;
    /// can be given several times
    #[arg(long, value_name = "LOG")]
    pub executed: Vec<PathBuf>,
    /// HTML file to write; it needs no network and no other file [default: DIR/report.html]
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Show the plan in another folder beside this one; both must be of the same parts
    #[arg(long, value_name = "DIR")]
    pub beside: Option<PathBuf>,
    /// Also write SVG figures for papers and slides into this folder: sections through the parts at six moments, contact
    /// forces, convergence, success rates
    #[arg(long, value_name = "DIR")]
    pub figures: Option<PathBuf>,
    /// Also write the moving plan as a picture for slides; the extension says whether .svg or .gif
    #[arg(long, value_name = "FILE")]
    pub animation: Option<PathBuf>,
    /// Number of the only scenario in the animation, from 1 [default: all]
    #[arg(long, value_name = "NUMBER", requires = "animation")]
    pub scenario: Option<usize>,
}

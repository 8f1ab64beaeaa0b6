//! What the user can say about tolerances.

use std::path::PathBuf;

use clap::Args;
use tolerance::{Quantity, ToleranceRequest};

use crate::arguments::task::{TaskArguments, ToleranceArguments};
use crate::progress::ProgressArguments;
use crate::values::{self, jobs, not_negative, positive, seconds};

/// Which errors are increased, and how often.
#[derive(Debug, Args)]
pub struct ToleranceCommandArguments {
    #[command(flatten)]
    pub task: TaskArguments,
    /// Folder of the plan to measure [default: plan the scene, and again for each row of the map]
    #[arg(long, value_name = "DIR", conflicts_with_all = ["start", "delta"])]
    pub plan: Option<PathBuf>,
    /// What to increase, or to decrease for clearance and chamfer, until too many rollouts fail: offset, rotation, hole, friction,
    /// clearance, chamfer [default: all of them but chamfer]
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = values::quantity())]
    pub quantity: Vec<Quantity>,
    /// The two quantities of the map: the first is increased at several values of the second [default: offset,clearance]
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', num_args = 1, value_parser = values::quantity())]
    #[arg(default_values = ["offset", "clearance"], hide_default_value = true)]
    pub map: Vec<Quantity>,
    /// Values of the second quantity of the map (m, rad, or 1) [default: multiples of the scene's]
    #[arg(long, value_name = "VALUE,...", value_delimiter = ',', value_parser = not_negative)]
    pub rows: Vec<f64>,
    /// Draw no map
    #[arg(long, conflicts_with = "rows")]
    pub no_map: bool,
    /// Ask for the smallest clearance, or chamfer, at which this is tolerated, such as offset=2mm
    #[arg(long, value_name = "NAME=VALUE", value_parser = values::required)]
    pub need: Option<(Quantity, f64)>,
    /// What to size for --need: clearance, or a chamfer of 45 degrees at the mouth of the hole
    #[arg(long, value_name = "NAME", value_parser = values::part_quantity(), default_value = "clearance", requires = "need")]
    pub by: Quantity,
    /// Rows of the map at the smallest and the largest clearance of an ISO 286 fit, such as H7/g6
    #[arg(long, value_name = "FIT", requires = "diameter", conflicts_with_all = ["rows", "no_map"])]
    pub fit: Option<String>,
    /// Nominal diameter of --fit (m)
    #[arg(long, value_name = "M", requires = "fit", value_parser = positive)]
    pub diameter: Option<f64>,
    /// Success rate that the rollouts must reach
    #[arg(long, value_name = "RATE", default_value_t = ToleranceRequest::default().rate, value_parser = values::fraction)]
    pub target_rate: f64,
    /// Coulomb friction coefficients, which the rollouts have in turn [default: those that the plan was refined for]
    #[arg(long, value_name = "MU,MU,...", value_delimiter = ',', value_parser = not_negative)]
    pub friction: Vec<f64>,
    #[command(flatten)]
    pub tolerance: ToleranceArguments,
    /// Largest number of random errors; fewer, but at least 500, where the interval is narrow before
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = values::whole::<u32>(20..=1_000_000))]
    pub cases: u32,
    /// Seed of the random errors
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::seed)]
    pub seed: u64,
    /// Without --plan: time for each plan (s)
    #[arg(long, value_name = "S", default_value_t = 60.0, value_parser = seconds)]
    pub time_limit: f64,
    /// Number of threads; does not affect what is measured of a plan [default: one per processor]
    #[arg(short, long, value_name = "N", value_parser = jobs)]
    pub jobs: Option<u16>,
    #[command(flatten)]
    pub progress: ProgressArguments,
    /// Measure only one boundary, by its number from 0, and keep it for a run with --resume
    #[arg(long, value_name = "K", requires = "plan", conflicts_with = "resume")]
    pub index: Option<usize>,
    /// Continue an interrupted run of the same command: what it has finished is not measured again
    #[arg(long)]
    pub resume: bool,
    /// Folder for tolerance.json, tolerance.svg and the plans [default: DIR of --plan, or out/SCENE-START-tolerance]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

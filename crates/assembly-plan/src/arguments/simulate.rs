//! What the user can say about rollouts.

use std::path::PathBuf;

use clap::Args;
use planner::{GraspErrors, OffsetSource, PlannerError, Region, SimulationRequest, files};
use simulation::Settings;

use crate::arguments::task::ToleranceArguments;
use crate::progress::ProgressArguments;
use crate::values::{self, jobs, not_negative, positive};

/// How plans are played. At most one of --random, --grid and --offsets chooses the offsets.
#[derive(Debug, Args)]
#[command(allow_missing_positional = true)]
pub struct SimulateArguments {
    /// Scene file (TOML) of the plans [default: resolved.toml of each plan]
    pub scene: Option<PathBuf>,
    /// Folder that `solve` wrote, or a folder of such folders
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Play N random offsets of those that the scene covers, half of them on the rim of the disc or ball [default: the planned
    /// offsets themselves]
    #[arg(long, value_name = "N", value_parser = values::whole::<u32>(1..=1_000_000), group = "source")]
    pub random: Option<u32>,
    #[command(flatten)]
    pub region: RegionArguments,
    /// Seed of the random offsets
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = values::seed)]
    pub seed: u64,
    /// Play a grid in the hull of the planned offsets, N intervals along each of its edges
    #[arg(long, value_name = "N", value_parser = values::whole::<u32>(1..=1_000_000), group = "source")]
    pub grid: Option<u32>,
    /// Play the offsets of a CSV file with the header x_m,y_m,z_m (body frame)
    #[arg(long, value_name = "FILE", group = "source", conflicts_with = "magnitude")]
    pub offsets: Option<PathBuf>,
    /// Also rotate the part in the gripper at random, by up to this angle about any axis (rad)
    #[arg(long, value_name = "RAD", default_value_t = 0.0, value_parser = not_negative)]
    pub rotation_error: f64,
    /// Magnitudes (m) to which the planned offsets are scaled, such as 0.005,0.01 [default: delta-hat of every plan]
    #[arg(long, value_name = "M,M,...", value_delimiter = ',', value_parser = not_negative)]
    pub magnitude: Vec<f64>,
    /// Coulomb friction coefficients, such as 0,0.1
    #[arg(long, value_name = "MU,MU,...", value_delimiter = ',', default_value = "0", value_parser = not_negative)]
    pub friction: Vec<f64>,
    /// Also play the reference of every homotopy step, as they are in stages/
    #[arg(long)]
    pub stages: bool,
    #[command(flatten)]
    pub tolerance: ToleranceArguments,
    /// How long the end of the reference is held before a rollout is judged (s)
    #[arg(long, value_name = "S", default_value_t = Settings::default().settling_time, value_parser = not_negative)]
    pub settling_time: f64,
    /// Time step of the simulation (s)
    #[arg(long, value_name = "S", default_value_t = Settings::default().time_step, value_parser = positive)]
    pub time_step: f64,
    /// Number of threads; does not affect the result [default: one per processor]
    #[arg(short, long, value_name = "N", value_parser = jobs)]
    pub jobs: Option<u16>,
    #[command(flatten)]
    pub progress: ProgressArguments,
    /// Also write the motion of one rollout to a new CSV file with the columns of reference.csv: the first plan's at the
    /// first friction and offset
    #[arg(long, value_name = "FILE")]
    pub trace: Option<PathBuf>,
    /// Compare an execution, logged by an exported player, with a rollout that has the same grasp error; play
    /// nothing else
    #[arg(long, value_name = "LOG", conflicts_with_all = ["source", "trace", "out", "stages", "report"])]
    pub executed: Option<PathBuf>,
    /// Folder for rollouts.csv, success.csv and simulation.json [default: DIR]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Also write report.html, a page that shows the success rates, beside them
    #[arg(long)]
    pub report: bool,
}

/// Where random offsets lie; by default where the scene has them covered.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub struct RegionArguments {
    /// With --random: offsets in the hull of the planned ones
    #[arg(long, requires = "random", conflicts_with_all = ["grid", "offsets"])]
    pub hull: bool,
    /// With --random: offsets in the disc across the insertion, half of them on its rim
    #[arg(long, requires = "random", conflicts_with_all = ["grid", "offsets"])]
    pub disc: bool,
    /// With --random: offsets in the ball, half of them on its surface
    #[arg(long, requires = "random", conflicts_with_all = ["grid", "offsets"])]
    pub ball: bool,
}

impl SimulateArguments {
    /// The requested simulation.
    ///
    /// # Errors
    /// When the list of offsets cannot be read, or a value is out of its range.
    pub fn request(&self) -> Result<SimulationRequest, PlannerError> {
        let offsets = match (self.random, self.grid, &self.offsets) {
            (Some(count), ..) => OffsetSource::Random(count as usize, self.region.region()),
            (_, Some(divisions), _) => OffsetSource::Grid(divisions as usize),
            (_, _, Some(file)) => OffsetSource::Listed(files::read_offsets(file)?),
            (None, None, None) => OffsetSource::Planned,
        };
        let errors = GraspErrors {
            offsets,
            magnitudes: self.magnitude.clone(),
            rotation_error: self.rotation_error,
            seed: self.seed,
        };
        let request = SimulationRequest {
            errors,
            frictions: self.friction.clone(),
            time_step: self.time_step,
            settling_time: self.settling_time,
        };
        request.validate()?;
        Ok(request)
    }
}

impl RegionArguments {
    fn region(&self) -> Region {
        match self {
            Self { hull: true, .. } => Region::Hull,
            Self { disc: true, .. } => Region::Disc,
            Self { ball: true, .. } => Region::Ball,
            _ => Region::Covered,
        }
    }
}

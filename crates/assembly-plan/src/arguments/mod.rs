//! What the user can say.

mod batch;
mod generate;
mod help;

use std::path::PathBuf;
use std::time::Duration;

use clap::{Args, Parser, Subcommand};
use export::Target;
use planner::{Choices, GraspErrors, OffsetSource, PlannerError, Region, RobustnessTarget, SimulationRequest, files};
use scene::Scene;
use scene_templates::Axis;
use simulation::Settings;
use task::LinearSolver;

use crate::progress::ProgressArguments;
use crate::values::{self, Pose, fraction, jobs, not_negative, positive, seconds};

pub use batch::{BatchArguments, BatchCommand, MatrixArguments, SubmitArguments};
pub use generate::GenerateArguments;
pub use help::{CLOSINGS, Closing, command_line};

/// Plans motions of a robot that insert a part which may sit several millimetres off in the gripper.
///
/// A scene file (TOML, lengths in metres, quaternions w x y z) names the shapes of the part and its environment, start and
/// goal poses, the robot's stiffness and the size of the offset. The plan is one reference trajectory, which a Cartesian
/// impedance controller tracks; it brings the part to its goal with every modelled offset.
#[derive(Debug, Parser)]
#[command(name = "assembly-plan", version, propagate_version = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Plan one motion and write its files
    Solve(SolveArguments),
    /// Plan every start and offset magnitude of some scenes, here or on a cluster
    Batch(BatchArguments),
    /// Test plans: play them with offsets, hard contacts and friction, and count successes
    Simulate(SimulateArguments),
    /// Write an HTML page that shows a plan, a batch or a simulation
    Report(ReportArguments),
    /// Write what a robot reads of a plan: tool motion, gains, limits, player
    Export(ExportArguments),
    /// Fit the robot of a scene to logs of executed plans
    Calibrate(CalibrateArguments),
    /// Check and explain a scene without solving it
    Check(CheckArguments),
    /// Write a commented scene that solves as it is, from two meshes if given
    New(NewArguments),
    /// Write the scene of a peg and its hole: random, round, rectangular or keyed
    Generate(GenerateArguments),
    /// Print a JSON schema of scene files, for editors
    Schema(SchemaArguments),
    /// Print a script that completes the command line in a shell
    Completions(CompletionsArguments),
    /// Write the manual pages
    Man(ManualArguments),
}

/// What to plan.
#[derive(Debug, Args)]
pub struct TaskArguments {
    /// Scene file (TOML)
    pub scene: PathBuf,
    /// Name of the start pose [default: the scene's first]
    #[arg(long, value_name = "NAME")]
    pub start: Option<String>,
    /// Offset magnitude delta-hat in metres [default: the scene's]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub delta: Option<f64>,
}

#[derive(Debug, Args)]
pub struct SolveArguments {
    #[command(flatten)]
    pub task: TaskArguments,
    /// Homotopy file (TOML) [default: the scene's, else the built-in configs/default.toml]
    #[arg(long, value_name = "FILE")]
    pub homotopy: Option<PathBuf>,
    /// Folder for the results; an older plan in it is replaced once the new one is whole [default: out/TITLE-START]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Linear solver; ma27, ma57 and ma97 need the HSL library [default: the homotopy's, else stage]
    #[arg(long, value_name = "NAME", value_parser = values::linear_solver())]
    pub linear_solver: Option<LinearSolver>,
    /// Continue an interrupted or killed solve of the same problem into --out
    #[arg(long, requires = "out")]
    pub resume: bool,
    /// Solve a cell of a batch: refuse any problem but the one of this identity, which stands in the manifest, and stop
    /// when standard input ends
    #[arg(long, hide = true, requires = "resume", value_name = "IDENTITY")]
    pub cell: Option<String>,
    #[command(flatten)]
    pub tolerance: ToleranceArguments,
    #[command(flatten)]
    pub robust: RobustArguments,
    /// Number of threads; does not affect the result [default: one per processor]
    #[arg(short, long, value_name = "N", value_parser = jobs)]
    pub jobs: Option<u16>,
    /// Also write report.html, a page that shows the plan
    #[arg(long)]
    pub report: bool,
    #[command(flatten)]
    pub progress: ProgressArguments,
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

/// How a plan is made robust.
#[derive(Debug, Args)]
pub struct RobustArguments {
    /// Test the plan with hard contacts and friction at offsets that were not planned, and refine it until they succeed
    #[arg(long)]
    pub robust: bool,
    /// With --robust: success rate to reach at each friction, from 0 to 1
    #[arg(long, value_name = "RATE", default_value_t = 0.99, value_parser = fraction, requires = "robust")]
    pub target_rate: f64,
    /// End after this time (s), everything included, with the best plan so far [default: 300 with --robust]
    #[arg(long, value_name = "S", value_parser = seconds)]
    pub time_limit: Option<f64>,
    /// With --robust: evaluate a plan again after this many perturbations in a row without improvement; 0 only evaluates it
    #[arg(long, value_name = "N", default_value_t = 150, value_parser = values::whole::<u32>(0..=values::BILLION), requires = "robust")]
    pub stall_limit: u32,
    /// With --robust: try at most this many perturbations
    #[arg(long, hide = true, value_name = "N", value_parser = values::whole::<u32>(0..=values::BILLION), requires = "robust")]
    pub max_perturbations: Option<u32>,
    /// With --robust: replace the parameters of the search, `robust.parameters` of result.json, by those of a file (TOML)
    #[arg(long, hide = true, value_name = "FILE", requires = "robust")]
    pub robust_parameters: Option<PathBuf>,
    /// With --robust: Coulomb friction coefficients, such as 0,0.1 [default: the scene's]
    #[arg(long, value_name = "MU,MU,...", value_delimiter = ',', value_parser = not_negative)]
    #[arg(allow_negative_numbers = true, requires = "robust")]
    pub friction: Option<Vec<f64>>,
    /// With --robust: the part may also be rotated in the gripper by up to this angle about any axis (rad) [default: the
    /// scene's]
    #[arg(long, value_name = "RAD", value_parser = not_negative, requires = "robust")]
    #[arg(allow_negative_numbers = true)]
    pub rotation_error: Option<f64>,
}

/// How plans are played. At most one of --random, --grid and --offsets chooses the offsets.
#[derive(Debug, Args)]
#[command(allow_missing_positional = true)]
pub struct SimulateArguments {
    /// Scene file (TOML) of the plans [default: resolved.toml of each plan]
    pub scene: Option<PathBuf>,
    /// Folder that `solve` wrote, or a folder of such folders
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Play N random offsets of those that the scene covers, half of a disc or ball on its rim [default: the planned
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
    #[arg(long, value_name = "RAD", default_value_t = 0.0, value_parser = not_negative, allow_negative_numbers = true)]
    pub rotation_error: f64,
    /// Magnitudes (m) to which the planned offsets are scaled, such as 0.005,0.01 [default: delta-hat of every plan]
    #[arg(long, value_name = "M,M,...", value_delimiter = ',', value_parser = not_negative)]
    #[arg(allow_negative_numbers = true)]
    pub magnitude: Vec<f64>,
    /// Coulomb friction coefficients, such as 0,0.1
    #[arg(long, value_name = "MU,MU,...", value_delimiter = ',', default_value = "0", value_parser = not_negative)]
    #[arg(allow_negative_numbers = true)]
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
    /// Compare an execution, as the player of an export logged it, with a rollout that has the same grasp error; play
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

#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Folder that `solve`, `batch` or `simulate` wrote
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Also show an execution, as the player of an export logged it, beside a rollout that has the same grasp error;
    /// can be given several times
    #[arg(long, value_name = "LOG")]
    pub executed: Vec<PathBuf>,
    /// HTML file to write; it needs no network and no other file [default: DIR/report.html]
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Also write SVG figures for papers and slides into this folder: sections through the parts at six moments, contact
    /// forces, convergence, success rates
    #[arg(long, value_name = "DIR")]
    pub figures: Option<PathBuf>,
}

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
    /// Also export a plan that is not done, or succeeds too rarely in rollouts
    #[arg(long)]
    pub anyway: bool,
}

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
    /// Print only warnings
    #[arg(short, long)]
    pub quiet: bool,
}

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
    /// Unit of meshes, which need one
    #[arg(long, value_name = "UNIT", value_parser = values::unit(), requires_all = ["body", "environment"])]
    pub unit: Option<String>,
    /// Direction in which the body is taken out, opposite to the insertion [default: the one in which it gets out, where it
    /// ends at a stop in the opposite one]
    #[arg(long, value_name = "AXIS", value_parser = values::axis(), ignore_case = true, allow_hyphen_values = true)]
    #[arg(requires = "body")]
    pub axis: Option<Axis>,
    /// Link of the body's model, where that has several
    #[arg(long, value_name = "NAME", requires = "body")]
    pub link: Option<String>,
    /// Link of the environment's model, where that has several
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

#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// Print the schema of homotopy files
    #[arg(long)]
    pub homotopy: bool,
}

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell that reads the script
    pub shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub struct ManualArguments {
    /// Folder to write them to, one file for the program and one for each command
    pub folder: PathBuf,
}

impl SolveArguments {
    /// Choices for the scene.
    pub fn choices(&self) -> Choices {
        Choices {
            rotation_error: self.robust.rotation_error,
            homotopy: self.homotopy.clone(),
            linear_solver: self.linear_solver,
            position_tolerance: self.tolerance.position_tolerance,
            angle_tolerance: self.tolerance.angle_tolerance,
            ..self.task.choices()
        }
    }

    /// Requirements on the plan in rollouts.
    ///
    /// # Errors
    /// When a file of parameters is wrong.
    pub fn target(&self, scene: &Scene) -> Result<RobustnessTarget, PlannerError> {
        let arguments = &self.robust;
        let own = RobustnessTarget::of(&scene.robustness);
        let parameters = arguments.robust_parameters.as_deref().map(files::read_robust_parameters).transpose()?;
        Ok(RobustnessTarget {
            target_rate: arguments.target_rate,
            frictions: arguments.friction.clone().unwrap_or(own.frictions),
            time_limit: self.time_limit().unwrap_or(own.time_limit),
            stall_limit: arguments.stall_limit as usize,
            max_perturbations: arguments.max_perturbations.map(|most| most as usize),
            parameters: parameters.unwrap_or_default(),
            ..own
        })
    }

    /// How long the program may run.
    pub fn time_limit(&self) -> Option<Duration> {
        let own = || self.robust.robust.then(|| RobustnessTarget::default().time_limit);
        self.robust.time_limit.map(Duration::from_secs_f64).or_else(own)
    }
}

impl TaskArguments {
    /// Choices for the scene.
    pub fn choices(&self) -> Choices {
        Choices { start: self.start.clone(), delta: self.delta, ..Choices::default() }
    }
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

//! What the user can say about a solve.

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use planner::{Choices, PlannerError, RobustnessTarget, files};
use scene::Scene;
use task::LinearSolver;

use crate::arguments::task::{TaskArguments, ToleranceArguments};
use crate::progress::ProgressArguments;
use crate::values::{self, fraction, jobs, not_negative, seconds};

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
    /// With --robust: before anything is solved, try the plan in this folder, moved to the start and the goal of the scene
    #[arg(long, value_name = "DIR", requires = "robust")]
    pub from: Option<PathBuf>,
    /// With --robust: evaluate again after this many perturbations without improvement; 0 only evaluates the plan
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
    #[arg(requires = "robust")]
    pub friction: Option<Vec<f64>>,
    /// With --robust: the part may also be rotated in the gripper by up to this angle about any axis (rad) [default: the
    /// scene's]
    #[arg(long, value_name = "RAD", value_parser = not_negative, requires = "robust")]
    pub rotation_error: Option<f64>,
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

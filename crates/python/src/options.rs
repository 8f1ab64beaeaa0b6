//! What is chosen of a scene and how it is solved and simulated: dictionaries of the package, whose values all are there.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ::scene::{Scene, Source, parse_homotopy};
use planner::{Choices, GraspErrors, OffsetSource, PlannerError, Problem, RobustnessTarget, SimulationRequest};
use pyo3::FromPyObject;
use task::LinearSolver;

/// Name of a homotopy that is a dictionary, in messages.
const DICTIONARY: &str = "homotopy";

/// What is chosen of a scene.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ChoiceOptions {
    start: Option<String>,
    delta: Option<f64>,
    turn: Option<f64>,
    homotopy: Option<PathBuf>,
    /// As a TOML file would have it, in JSON.
    homotopy_json: Option<String>,
    linear_solver: Option<String>,
    position_tolerance: Option<f64>,
    angle_tolerance: Option<f64>,
}

impl ChoiceOptions {
    /// The problem that is chosen of a scene.
    ///
    /// # Errors
    /// What is wrong with a choice.
    pub fn problem(self, scene: &Scene, file: &Path) -> Result<Problem, PlannerError> {
        let mut scene = scene.clone();
        if let Some(json) = &self.homotopy_json {
            let (file, text) = (Path::new(DICTIONARY), toml_text(json)?);
            scene.homotopy = Some(parse_homotopy(Source { file, text: &text })?);
        }
        let choices = Choices {
            linear_solver: self.linear_solver.as_deref().map(linear_solver).transpose()?,
            start: self.start,
            delta: self.delta,
            turn: self.turn,
            homotopy: self.homotopy,
            position_tolerance: self.position_tolerance,
            angle_tolerance: self.angle_tolerance,
        };
        Problem::choose(scene, file, &choices)
    }
}

/// How a problem is solved.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SolveOptions {
    pub out: Option<PathBuf>,
    pub resume: bool,
    pub jobs: Option<usize>,
}

/// How a plan is made robust.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RobustOptions {
    wanted_rate: f64,
    time_limit: f64,
    patience: u32,
    friction: Option<Vec<f64>>,
}

impl RobustOptions {
    /// What a robust plan of a scene must bear, and until when it is sought.
    ///
    /// # Errors
    /// When a value is out of its range.
    pub fn target(self, scene: &Scene) -> Result<(RobustnessTarget, Option<Instant>), PlannerError> {
        /// More than anyone waits (s).
        const MOST: f64 = 1e7;
        if !(self.time_limit > 0.0 && self.time_limit <= MOST) {
            let rule = "must lie between 0 and 10000000 s";
            return Err(PlannerError::value("time_limit", self.time_limit, rule));
        }
        let own = RobustnessTarget::of(&scene.borne);
        let target = RobustnessTarget {
            wanted_rate: self.wanted_rate,
            frictions: self.friction.unwrap_or(own.frictions),
            time_limit: Duration::from_secs_f64(self.time_limit),
            patience: self.patience as usize,
            ..own
        };
        target.validate()?;
        let deadline = Instant::now().checked_add(target.time_limit);
        Ok((target, deadline))
    }
}

/// How plans are played.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PlayOptions {
    random: Option<usize>,
    ball: bool,
    seed: u64,
    grid: Option<usize>,
    offsets: Option<Vec<[f64; 3]>>,
    turn: f64,
    magnitude: Vec<f64>,
    friction: Vec<f64>,
    settling_time: f64,
    time_step: f64,
    pub stages: bool,
    pub position_tolerance: Option<f64>,
    pub angle_tolerance: Option<f64>,
    pub jobs: Option<usize>,
}

impl PlayOptions {
    /// What is simulated.
    ///
    /// # Errors
    /// When a value is out of its range, or two exclude each other.
    pub fn request(&self) -> Result<SimulationRequest, PlannerError> {
        let offsets = match (self.random, self.grid, &self.offsets) {
            (Some(count), None, None) if self.ball => OffsetSource::Ball(count),
            (Some(count), None, None) => OffsetSource::Hull(count),
            (None, Some(divisions), None) => OffsetSource::Grid(divisions),
            (None, None, Some(offsets)) => OffsetSource::Listed(offsets.clone()),
            (None, None, None) => OffsetSource::Planned,
            _ => return Err(excluded("at most one of random, grid and offsets chooses the offsets")),
        };
        if self.ball && self.random.is_none() {
            return Err(excluded("ball needs random, the number of offsets"));
        }
        if self.offsets.is_some() && !self.magnitude.is_empty() {
            return Err(excluded("magnitude does not scale offsets that are given; leave one of the two out"));
        }
        let errors = GraspErrors { offsets, magnitudes: self.magnitude.clone(), turn: self.turn, seed: self.seed };
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

fn excluded(problem: &str) -> PlannerError {
    PlannerError::Choice { name: "offsets", problem: problem.to_owned() }
}

/// Number of threads: as many as wanted, else one per processor.
pub fn threads(jobs: Option<usize>) -> usize {
    jobs.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into))
}

/// The text of a TOML file with the content of a JSON object.
///
/// # Errors
/// When it is no object, or has a value that TOML does not know.
pub fn toml_text(json: &str) -> Result<String, PlannerError> {
    let wrong = |problem: String| PlannerError::Choice { name: "dict", problem };
    let table: toml::Table = serde_json::from_str(json).map_err(|error| wrong(error.to_string()))?;
    toml::to_string(&table).map_err(|error| wrong(error.to_string()))
}

fn linear_solver(name: &str) -> Result<LinearSolver, PlannerError> {
    let names = LinearSolver::ALL.map(LinearSolver::name).join(", ");
    LinearSolver::from_name(name)
        .ok_or_else(|| PlannerError::value("linear_solver", name, &format!("unknown; choose one of {names}")))
}

//! Choices for a scene, and settings of solving and simulating: dictionaries of the package, in which every key is
//! present.

use std::path::{Path, PathBuf};
use std::time::Duration;

use ::scene::{Scene, Source, parse_homotopy};
use planner::files::PlanFolder;
use planner::{
    Choices, GraspErrors, Keeper, OffsetSource, PlannerError, Problem, Region, RobustnessTarget, SimulationRequest,
};
use pyo3::FromPyObject;
use task::LinearSolver;

use crate::reference::ReferenceOptions;

/// Name of a homotopy that is a dictionary, in messages.
const DICTIONARY: &str = "homotopy";

/// Choices for a scene.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ChoiceOptions {
    start: Option<String>,
    delta: Option<f64>,
    rotation_error: Option<f64>,
    pub homotopy: Option<PathBuf>,
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
            offset_magnitude: self.delta,
            rotation_error: self.rotation_error,
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
    out: Option<PathBuf>,
    resume: bool,
    pub jobs: Option<usize>,
    /// From which the homotopy starts.
    pub guess: Option<ReferenceOptions>,
}

impl SolveOptions {
    /// Claims the folder of the plan, if it has one; `inputs` are files that the user has named.
    ///
    /// # Errors
    /// When it cannot be that of a plan, or nothing can be resumed.
    pub fn claim(&self, inputs: &[&Path]) -> Result<Option<PlanFolder>, PlannerError> {
        let Some(out) = &self.out else {
            return match self.resume {
                true => Err(wrong("resume", "needs out, the folder of the plan")),
                false => Ok(None),
            };
        };
        let folder = PlanFolder::claim(out, inputs)?;
        if !self.resume {
            folder.discard()?;
        }
        Ok(Some(folder))
    }
}

/// How a plan is made robust.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RobustOptions {
    target_rate: f64,
    time_limit: f64,
    stall_limit: u32,
    friction: Option<Vec<f64>>,
}

impl RobustOptions {
    /// Target of a robust plan of a scene.
    ///
    /// # Errors
    /// When a value is out of its range.
    pub fn target(self, scene: &Scene) -> Result<RobustnessTarget, PlannerError> {
        /// More than anyone waits (s).
        const MOST: f64 = 1e7;
        if !(self.time_limit > 0.0 && self.time_limit <= MOST) {
            let rule = "must lie between 0 and 10000000 s";
            return Err(PlannerError::value("time_limit", self.time_limit, rule));
        }
        let own = RobustnessTarget::of(&scene.robustness);
        let target = RobustnessTarget {
            target_rate: self.target_rate,
            frictions: self.friction.unwrap_or(own.frictions),
            time_limit: Duration::from_secs_f64(self.time_limit),
            stall_limit: self.stall_limit as usize,
            ..own
        };
        target.validate()?;
        Ok(target)
    }
}

/// How plans are played.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PlayOptions {
    random: Option<usize>,
    hull: bool,
    disc: bool,
    ball: bool,
    seed: u64,
    grid: Option<usize>,
    offsets: Option<Vec<[f64; 3]>>,
    rotation_error: f64,
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
    /// The region of random offsets.
    fn region(&self) -> Result<Region, PlannerError> {
        match (self.hull, self.disc, self.ball) {
            (false, false, false) => Ok(Region::Covered),
            (true, false, false) => Ok(Region::Hull),
            (false, true, false) => Ok(Region::Disc),
            (false, false, true) => Ok(Region::Ball),
            _ => Err(wrong("random", "give at most one of hull, disc and ball")),
        }
    }

    /// The simulation to be run.
    ///
    /// # Errors
    /// When a value is out of its range, or two exclude each other.
    pub fn request(&self) -> Result<SimulationRequest, PlannerError> {
        let offsets = match (self.random, self.grid, &self.offsets) {
            (Some(count), None, None) => OffsetSource::Random(count, self.region()?),
            (None, Some(divisions), None) => OffsetSource::Grid(divisions),
            (None, None, Some(offsets)) => OffsetSource::Listed(offsets.clone()),
            (None, None, None) => OffsetSource::Planned,
            _ => return Err(wrong("offsets", "at most one of random, grid and offsets chooses them")),
        };
        let regions = [("hull", self.hull), ("disc", self.disc), ("ball", self.ball)];
        if let (None, Some((name, _))) = (self.random, regions.into_iter().find(|(_, is_chosen)| *is_chosen)) {
            return Err(wrong(name, "needs random, the number of offsets"));
        }
        if self.offsets.is_some() && !self.magnitude.is_empty() {
            return Err(wrong("magnitude", "does not scale offsets that are given; leave one of the two out"));
        }
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

/// Which errors of a plan are measured.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ToleranceOptions {
    pub quantities: Vec<String>,
    pub need: Option<(String, f64)>,
    pub by: String,
    pub map: Option<(String, String)>,
    pub rows: Vec<f64>,
    pub target_rate: f64,
    pub friction: Option<Vec<f64>>,
    pub cases: usize,
    pub seed: u64,
    pub position_tolerance: Option<f64>,
    pub angle_tolerance: Option<f64>,
    pub jobs: Option<usize>,
}

fn wrong(name: &'static str, problem: impl ToString) -> PlannerError {
    PlannerError::Choice { name, problem: problem.to_string() }
}

/// The text of a TOML file with the content of a JSON object.
///
/// # Errors
/// When it is not an object, or has a value that TOML cannot represent.
pub fn toml_text(json: &str) -> Result<String, PlannerError> {
    let table: toml::Table = serde_json::from_str(json).map_err(|error| wrong("dictionary", error))?;
    toml::to_string(&table).map_err(|error| wrong("dictionary", error))
}

fn linear_solver(name: &str) -> Result<LinearSolver, PlannerError> {
    let names = LinearSolver::ALL.map(LinearSolver::name).join(", ");
    LinearSolver::from_name(name)
        .ok_or_else(|| PlannerError::value("linear_solver", name, &format!("unknown; choose one of {names}")))
}

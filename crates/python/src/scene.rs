//! Scenes: read, explained, solved, played.

use std::path::PathBuf;
use std::sync::Arc;

use ::scene::{Part, Source};
use nalgebra::Matrix3;
use planner::check::{explain, pair_reports, refusal};
use planner::{Choices, Keeper, PlannerError, Problem, RobustnessTarget, RunClock, Session, Stop, warnings};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::Serialize;
use serde_json::json;
use task::Pose;

use crate::arm::Arm;
use crate::arrays::{bytes, rows};
use crate::background::{self, Watch};
use crate::calibration::{CalibrationOptions, fit};
use crate::contacts::{Contacts, Question, answer};
use crate::options::{ChoiceOptions, PlayOptions, RobustOptions, SolveOptions, ToleranceOptions, toml_text};
use crate::plan::{Earlier, Plan, TriedFirst};
use crate::reference::{ReferenceOptions, RolloutData, RolloutOptions, refine as refined, rollouts};
use crate::simulation::{Simulation, play, play_reference};
use crate::tolerance::measure;

/// A valid scene.
#[pyclass(frozen, module = "assembly_plan._planner")]
pub struct Scene(Arc<Read>);

/// A scene and where it was read from.
struct Read {
    scene: ::scene::Scene,
    file: PathBuf,
}

#[pymethods]
impl Scene {
    /// Reads a scene file and the files it names.
    #[staticmethod]
    fn load(py: Python, file: PathBuf) -> PyResult<Self> {
        background::run(py, None, move |_| {
            let scene = ::scene::Scene::load(&file)?;
            Ok(Self(Arc::new(Read { scene, file })))
        })
    }

    /// Reads a scene from JSON with the keys of a scene file. `file` is what it would be called.
    #[staticmethod]
    fn from_json(py: Python, json: String, file: PathBuf) -> PyResult<Self> {
        background::run(py, None, move |_| {
            let text = toml_text(&json)?;
            let scene = ::scene::Scene::parse(Source { file: &file, text: &text })?;
            Ok(Self(Arc::new(Read { scene, file })))
        })
    }

    /// The content of the scene, as JSON.
    fn content(&self) -> String {
        let scene = &self.0.scene;
        let impedance = &scene.impedance;
        let starts = scene.starts.iter().map(|start| json!({ "name": start.name, "pose": start.pose }));
        let parts = |parts: &[Part]| parts.iter().map(part).collect::<Vec<_>>();
        json!({
            "title": scene.title,
            "starts": starts.collect::<Vec<_>>(),
            "goal": scene.goal,
            "offset_magnitude": scene.offset_magnitude,
            "impedance": {
                "translational_stiffness": impedance.translational_stiffness,
                "rotational_stiffness": impedance.rotational_stiffness,
                "translational_damping": rows_of(&impedance.translational_damping),
                "rotational_damping": rows_of(&impedance.rotational_damping),
            },
            "time_step": scene.horizon.time_step,
            "body": parts(&scene.body),
            "environment": parts(&scene.environment),
        })
        .to_string()
    }

    /// The scene after defaults, with its first start, as TOML.
    fn resolved(&self, py: Python) -> PyResult<String> {
        let read = Arc::clone(&self.0);
        background::run(py, None, move |_| {
            let problem = Problem::choose(read.scene.clone(), &read.file, &Choices::default())?;
            Ok(problem.resolved().to_owned())
        })
    }

    /// The explanation of the scene, as JSON.
    fn check(&self, py: Python, choices: ChoiceOptions, tau: Option<f64>) -> PyResult<String> {
        let read = Arc::clone(&self.0);
        background::run(py, None, move |_| {
            let problem = choices.problem(&read.scene, &read.file)?;
            text(&explain(&problem, tau.unwrap_or(problem.homotopy().tau))?)
        })
    }

    /// Every pair's distances at a pose, as JSON.
    fn distances(&self, py: Python, choices: ChoiceOptions, pose: [f64; 7], tau: Option<f64>) -> PyResult<String> {
        let read = Arc::clone(&self.0);
        background::run(py, None, move |_| {
            let problem = choices.problem(&read.scene, &read.file)?;
            text(&pair_reports(&problem, &unit(pose)?, tau.unwrap_or(problem.homotopy().tau))?)
        })
    }

    /// Contact information of every pair at some poses (bytes of rows of 7 numbers), by the batch kernels.
    fn contacts<'py>(
        &self,
        py: Python<'py>,
        choices: ChoiceOptions,
        poses: &[u8],
        tau: Option<f64>,
        derivatives: usize,
        points: bool,
    ) -> PyResult<Contacts<'py>> {
        let (read, poses) = (Arc::clone(&self.0), rows(poses));
        let (pairs, question, numbers) = background::run(py, None, move |_| {
            let problem = choices.problem(&read.scene, &read.file)?;
            let question = Question { tau: tau.unwrap_or(problem.homotopy().tau), derivatives, points };
            let pairs = &problem.task().pairs;
            Ok((pairs.iter().map(ToString::to_string).collect(), question, answer(pairs, &poses, question)?))
        })?;
        Contacts::new(py, pairs, question, &numbers)
    }

    /// The arm that holds the body, if the scene has one.
    fn arm(&self) -> Option<Arm> {
        self.0.scene.robot.clone().map(Arm::new)
    }

    /// Fits the robot of the scene to logs of players; the record as JSON. Writes a copy of the scene's file if it is named.
    fn calibrate(&self, py: Python, options: CalibrationOptions) -> PyResult<String> {
        let read = Arc::clone(&self.0);
        background::run(py, None, move |watch| fit(&read.scene, &read.file, &options, watch))
    }

    /// Plans; makes the plan robust if requested, beginning with an earlier one if there is one.
    fn solve(
        &self,
        py: Python,
        choices: ChoiceOptions,
        options: SolveOptions,
        robust: Option<(RobustOptions, Option<TriedFirst>)>,
        progress: Option<Bound<PyAny>>,
    ) -> PyResult<Plan> {
        let read = Arc::clone(&self.0);
        let robust = robust.map(|(robust, tried_first)| (robust, tried_first.map(Earlier::from)));
        background::run(py, progress.as_ref(), move |watch| solve(&read, choices, options, robust, watch))
    }

    /// Plays a plan.
    fn simulate(
        &self,
        py: Python,
        plan: PyRef<Plan>,
        options: PlayOptions,
        progress: Option<Bound<PyAny>>,
    ) -> PyResult<Simulation> {
        let (read, played) = (Arc::clone(&self.0), plan.played(options.stages));
        background::run(py, progress.as_ref(), move |watch| play(&read.scene, &read.file, &played?, &options, watch))
    }

    /// Plays a reference of the user.
    fn simulate_reference(
        &self,
        py: Python,
        reference: ReferenceOptions,
        options: PlayOptions,
        progress: Option<Bound<PyAny>>,
    ) -> PyResult<Simulation> {
        let read = Arc::clone(&self.0);
        let work = move |watch: &Watch| play_reference(&read.scene, &read.file, &reference, &options, watch);
        background::run(py, progress.as_ref(), work)
    }

    /// Plays a reference and keeps all that happens.
    fn rollouts<'py>(
        &self,
        py: Python<'py>,
        reference: ReferenceOptions,
        options: RolloutOptions,
    ) -> PyResult<RolloutData<'py>> {
        let read = Arc::clone(&self.0);
        let played = background::run(py, None, move |_| rollouts(&read.scene, &read.file, &reference, &options))?;
        played.data(py)
    }

    /// Refines a reference of the user: bytes of its states, and the report as JSON.
    fn refine<'py>(
        &self,
        py: Python<'py>,
        reference: ReferenceOptions,
        robust: RobustOptions,
        jobs: Option<usize>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyBytes>, String)> {
        let read = Arc::clone(&self.0);
        let work = move |watch: &Watch| refined(&read.scene, &read.file, &reference, robust, jobs, watch);
        let (states, report) = background::run(py, progress.as_ref(), work)?;
        Ok((bytes(py, &states)?, report))
    }

    /// The errors that a plan tolerates, as JSON.
    fn tolerance(
        &self,
        py: Python,
        plan: PyRef<Plan>,
        options: ToleranceOptions,
        progress: Option<Bound<PyAny>>,
    ) -> PyResult<String> {
        let (read, played) = (Arc::clone(&self.0), plan.played(false));
        background::run(py, progress.as_ref(), move |watch| measure(&read.scene, &read.file, &played?, &options, watch))
    }
}

/// As the command `solve` does.
fn solve(
    read: &Read,
    choices: ChoiceOptions,
    options: SolveOptions,
    robust: Option<(RobustOptions, Option<Earlier>)>,
    watch: &Watch,
) -> Result<Plan, PlannerError> {
    let clock = RunClock::start();
    let inputs = [Some(read.file.clone()), choices.homotopy.clone()];
    let problem = choices.problem(&read.scene, &read.file)?;
    if let Some(reason) = refusal(&problem) {
        return Err(PlannerError::file(&read.file, reason));
    }
    let problem = match &options.guess {
        Some(guess) => problem.with_guess(guess.reference()?),
        None => problem,
    };
    let (robust, earlier) = robust.unzip();
    let problem = match earlier.flatten() {
        Some(earlier) => earlier.tried_first_for(problem)?,
        None => problem,
    };
    let target = robust.map(|robust| robust.target(problem.scene())).transpose()?;
    warnings::of_problem(&problem).into_iter().for_each(|warning| watch.warn(warning));
    let folder = options.claim(&inputs.iter().flatten().map(PathBuf::as_path).collect::<Vec<_>>())?;
    let clock = clock.limited(target.as_ref().map(|target| target.time_limit));
    let keeper = folder.as_ref().map(|folder| folder as &dyn Keeper);
    let session = Session { folder: keeper, clock, ..watch.session(options.jobs) };
    let mut plan = match &target {
        Some(target) => planner::solve_robust(&problem, target, &session)?,
        None => planner::solve(&problem, &session)?,
    };
    if target.is_none() {
        plan.tested = planner::test(&plan, &RobustnessTarget::of(&problem.scene().robustness), &session)?;
    }
    warnings::of_plan(&plan).into_iter().for_each(|warning| watch.warn(warning));
    // Interrupted work raises the interrupt.
    let folder = folder.filter(|_| plan.stopped != Some(Stop::User));
    Plan::solved(plan, folder)
}

/// A matrix as JSON has it.
fn rows_of(matrix: &Matrix3<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// A part, as JSON.
fn part(part: &Part) -> serde_json::Value {
    let shape = &part.shape;
    json!({ "name": part.name, "vertices": shape.vertices(), "normals": shape.normals(), "offsets": shape.offsets() })
}

/// A pose whose quaternion has unit norm.
fn unit(pose: [f64; 7]) -> Result<Pose, PlannerError> {
    Pose::given(pose).map_err(|rule| PlannerError::value("pose", format!("{pose:?}"), rule))
}

fn text(value: &impl Serialize) -> Result<String, PlannerError> {
    serde_json::to_string(value).map_err(|_| PlannerError::Internal("a report"))
}

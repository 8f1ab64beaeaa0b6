//! Simulations: rollouts and success rates as tables.

use std::path::{Path, PathBuf};

use ::scene::Scene;
use planner::files::{RolloutRow, SimulationRecord, SuccessRow, to_csv, write_rollout_tables};
use planner::{Choices, Motion, PlannerError, Problem, RolloutRemarks, SimulationRequest, SuccessTable, simulate};
use pyo3::prelude::*;
use simulation::Reference;

use crate::background::Watch;
use crate::errors::exception;
use crate::options::PlayOptions;
use crate::plan::PlayedPlan;
use crate::reference::ReferenceOptions;

/// The rollouts of a plan.
#[pyclass(frozen, module = "assembly_plan._planner")]
pub struct Simulation {
    record: SimulationRecord,
    rollouts: Vec<RolloutRow>,
    successes: Vec<SuccessRow>,
    table: String,
}

#[pymethods]
impl Simulation {
    /// `rollouts.csv`.
    fn rollouts(&self) -> PyResult<String> {
        csv(to_csv(&self.rollouts))
    }

    /// `success.csv`.
    fn successes(&self) -> PyResult<String> {
        csv(to_csv(&self.successes))
    }

    /// Success rates, as the command line prints them.
    fn table(&self) -> &str {
        &self.table
    }

    /// Writes `rollouts.csv`, `success.csv` and `simulation.json`.
    fn save(&self, folder: PathBuf) -> PyResult<()> {
        let written = write_rollout_tables(&folder, &self.record, &self.rollouts, &self.successes);
        written.map_err(|error| exception(&error))
    }
}

/// As the command `simulate` does.
pub fn play(
    scene: &Scene,
    file: &Path,
    plan: &PlayedPlan,
    options: &PlayOptions,
    watch: &Watch,
) -> Result<Simulation, PlannerError> {
    let request = options.request()?;
    let problem = problem(scene, file, plan, options.position_tolerance, options.angle_tolerance)?;
    let folder = plan.folder();
    let name = if folder.as_os_str().is_empty() { "plan".to_owned() } else { folder.display().to_string() };
    if !plan.require_made_for(&problem)? {
        watch.warn(format!("{name}: the plan was made with other settings than {} has", file.display()));
    }
    if plan.result.is_unconverged() {
        watch.warn(format!("{name}: the plan did not converge"));
    }
    rollouts(&problem, &plan.motions, Played { name, folder, start: &plan.result.start }, &request, options.jobs, watch)
}

/// Plays a reference of the user.
pub fn play_reference(
    scene: &Scene,
    file: &Path,
    given: &ReferenceOptions,
    options: &PlayOptions,
    watch: &Watch,
) -> Result<Simulation, PlannerError> {
    let request = options.request()?;
    if options.stages {
        return Err(PlannerError::Choice { name: "stages", problem: "a reference has none; play a plan".to_owned() });
    }
    let problem = given.problem(scene, file, options.position_tolerance, options.angle_tolerance)?;
    let motions = [(Motion::Plan, given.reference()?)];
    let played = Played { name: "reference".to_owned(), folder: PathBuf::new(), start: &problem.start().name };
    rollouts(&problem, &motions, played, &request, options.jobs, watch)
}

/// What is played, in tables.
struct Played<'start> {
    name: String,
    folder: PathBuf,
    start: &'start str,
}

fn rollouts(
    problem: &Problem,
    motions: &[(Motion, Reference)],
    Played { name, folder, start }: Played,
    request: &SimulationRequest,
    jobs: Option<usize>,
    watch: &Watch,
) -> Result<Simulation, PlannerError> {
    let rollouts = simulate(problem, motions, request, &watch.session(jobs))?;
    let limit = problem.task().limits.contact_force;
    let mut remarks = RolloutRemarks::default();
    rollouts.iter().for_each(|rollout| remarks.add(rollout, limit));
    remarks.penetration_warning().into_iter().for_each(|warning| watch.warn(warning));
    let table = SuccessTable::new(&rollouts);
    Ok(Simulation {
        record: SimulationRecord::new(problem, vec![name], &request.errors),
        rollouts: rollouts.iter().map(|rollout| RolloutRow::new(&folder, start, rollout)).collect(),
        successes: table.groups().iter().map(SuccessRow::from).collect(),
        table: table.to_string(),
    })
}

/// The problem of a plan in a scene, with other tolerances of success (m, rad) where they are given.
pub fn problem(
    scene: &Scene,
    file: &Path,
    plan: &PlayedPlan,
    position_tolerance: Option<f64>,
    angle_tolerance: Option<f64>,
) -> Result<Problem, PlannerError> {
    let choices = Choices {
        start: Some(plan.result.start.clone()),
        offset_magnitude: Some(plan.result.delta_m),
        rotation_error: Some(plan.result.turn_rad),
        position_tolerance,
        angle_tolerance,
        ..Choices::default()
    };
    Problem::choose(scene.clone(), file, &choices)
        .map_err(|error| PlannerError::Choice { name: "plan", problem: format!("it does not fit the scene: {error}") })
}

fn csv(table: Result<Vec<u8>, PlannerError>) -> PyResult<String> {
    let text = table.map_err(|error| exception(&error))?;
    Ok(String::from_utf8(text)?)
}

//! Plans: solved ones, and those of a folder.

use std::collections::BTreeMap;
use std::path::PathBuf;

use planner::explain::{Parameter, optimum, sensitivities};
use planner::files::trajectory::read_tables;
use planner::files::{MotionTables, PlanFolder, PlanResult, RESOLVED, STAGES, StoredPlan, read_text};
use planner::{Keeper, Motion as Played, PlannerError, Problem};
use pyo3::prelude::*;
use simulation::Reference;

use crate::background;
use crate::errors::exception;
use crate::motion::Motion;

/// A plan.
#[pyclass(module = "assembly_plan._planner")]
pub struct Plan {
    origin: Origin,
    result: PlanResult,
    tables: MotionTables,
}

/// The place of a plan.
enum Origin {
    Solved(Box<planner::Plan>),
    Stored(Box<StoredPlan>),
}

/// A plan that is tried before another problem is solved.
#[derive(FromPyObject)]
pub enum TriedFirst<'py> {
    Plan(PyRef<'py, Plan>),
    Folder(PathBuf),
}

/// The same, apart from Python.
pub enum Earlier {
    Solved(Box<Problem>, Reference),
    Stored(Box<StoredPlan>),
    Folder(PathBuf),
}

impl From<TriedFirst<'_>> for Earlier {
    fn from(tried: TriedFirst) -> Self {
        match tried {
            TriedFirst::Plan(plan) => match &plan.origin {
                Origin::Solved(plan) => Self::Solved(Box::new(plan.problem.clone()), plan.reference()),
                Origin::Stored(stored) => Self::Stored(stored.clone()),
            },
            TriedFirst::Folder(folder) => Self::Folder(folder),
        }
    }
}

impl Earlier {
    /// A problem for which it is tried first.
    ///
    /// # Errors
    /// When its folder has no plan, or its arm does not reach its start.
    pub fn tried_first_for(&self, problem: Problem) -> Result<Problem, PlannerError> {
        match self {
            Self::Solved(from, reference) => {
                let reference = planner::moved(reference, from, &problem)?;
                Ok(problem.with_earlier(reference))
            }
            Self::Stored(stored) => stored.tried_first_for(problem),
            Self::Folder(folder) => StoredPlan::open(folder)?.tried_first_for(problem),
        }
    }
}

/// The inputs of a simulation of a plan.
pub struct PlayedPlan {
    origin: Option<StoredPlan>,
    pub result: PlanResult,
    pub motions: Vec<(Played, Reference)>,
}

impl Plan {
    /// A plan that has just been made; with a folder, it is written there.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn solved(plan: planner::Plan, folder: Option<PlanFolder>) -> Result<Self, PlannerError> {
        let result = match folder {
            Some(folder) => folder.finish(&plan)?,
            None => PlanResult::new(&plan, BTreeMap::new()),
        };
        let tables = MotionTables::new(&plan.trajectory, &plan.task);
        Ok(Self { origin: Origin::Solved(Box::new(plan)), result, tables })
    }

    /// The inputs of a simulation, with the homotopy steps if requested.
    ///
    /// # Errors
    /// When a file of a stored plan cannot be read.
    pub fn played(&self, stages: bool) -> Result<PlayedPlan, PlannerError> {
        let mut motions = Vec::new();
        if stages {
            motions.extend((1..).map(Played::HomotopyStep).zip(self.iteration_references()?));
        }
        motions.push((Played::Plan, Reference::new(self.tables.time_step, &self.tables.reference)));
        let origin = match &self.origin {
            Origin::Solved(_) => None,
            Origin::Stored(stored) => Some(StoredPlan::clone(stored)),
        };
        Ok(PlayedPlan { origin, result: self.result.clone(), motions })
    }

    /// The plan with what the solver knew of it, if this process has solved it.
    fn in_memory(&self) -> Option<planner::Plan> {
        match &self.origin {
            Origin::Solved(plan) => Some(planner::Plan::clone(plan)),
            Origin::Stored(_) => None,
        }
    }

    fn iteration_references(&self) -> Result<Vec<Reference>, PlannerError> {
        Ok(self.stage_tables()?.iter().map(|tables| Reference::new(tables.time_step, &tables.reference)).collect())
    }

    fn stage_tables(&self) -> Result<Vec<MotionTables>, PlannerError> {
        match &self.origin {
            Origin::Solved(plan) => {
                let task = &plan.variant.task;
                Ok(plan.iterations.iter().map(|iteration| MotionTables::new(&iteration.trajectory, task)).collect())
            }
            Origin::Stored(stored) => {
                let folder = stored.folder.join(STAGES);
                let numbers = 1..=stored.result.stages.len();
                numbers.map(|number| read_tables(&folder.join(number.to_string()))).collect()
            }
        }
    }
}

impl PlayedPlan {
    /// The folder of a stored plan; otherwise empty.
    pub fn folder(&self) -> PathBuf {
        self.origin.as_ref().map_or_else(PathBuf::new, |stored| stored.folder.clone())
    }

    /// Checks that it was made for the shapes, the start and the goal of a problem. Returns whether everything else is
    /// the same too.
    ///
    /// # Errors
    /// When it was made for others.
    pub fn require_made_for(&self, problem: &Problem) -> Result<bool, PlannerError> {
        let made_from = &self.result.made_from;
        match &self.origin {
            Some(stored) => stored.require_made_for(problem),
            None if made_from.shapes != problem.shapes_hash() => Err(PlannerError::Choice {
                name: "plan",
                problem: "it was made for another scene: a shape, the start or the goal differs".to_owned(),
            }),
            None => Ok(made_from.settings == problem.settings_hash()),
        }
    }
}

#[pymethods]
impl Plan {
    /// Reads the plan of a folder.
    #[staticmethod]
    fn load(py: Python, folder: PathBuf) -> PyResult<Self> {
        background::run(py, None, move |_| {
            let stored = StoredPlan::open(&folder)?;
            let (result, tables) = (stored.result.clone(), read_tables(&folder)?);
            Ok(Self { origin: Origin::Stored(Box::new(stored)), result, tables })
        })
    }

    /// Writes the files of a plan.
    fn save(&mut self, folder: PathBuf) -> PyResult<()> {
        let mut write = || -> Result<(), PlannerError> {
            let folder = PlanFolder::claim(&folder, &[])?;
            folder.discard()?;
            match &self.origin {
                Origin::Solved(plan) => self.result = folder.finish(plan)?,
                Origin::Stored(stored) => folder.copy(stored)?,
            }
            Ok(())
        };
        write().map_err(|error| exception(&error))
    }

    /// Writes a copy into an empty folder, which is not where the plan is saved.
    fn copy(&self, folder: PathBuf) -> PyResult<()> {
        let write = || -> Result<(), PlannerError> {
            let folder = PlanFolder::claim(&folder, &[])?;
            match &self.origin {
                Origin::Solved(plan) => folder.finish(plan).map(drop),
                Origin::Stored(stored) => folder.copy(stored),
            }
        };
        write().map_err(|error| exception(&error))
    }

    /// `result.json`.
    fn result(&self) -> PyResult<String> {
        let text = serde_json::to_string(&self.result).map_err(|_| PlannerError::Internal("result.json"));
        text.map_err(|error| exception(&error))
    }

    /// `resolved.toml`.
    fn resolved(&self) -> PyResult<String> {
        match &self.origin {
            Origin::Solved(plan) => Ok(plan.problem.resolved().to_owned()),
            Origin::Stored(stored) => read_text(&stored.folder.join(RESOLVED)).map_err(|error| exception(&error)),
        }
    }

    /// The motion of the plan.
    fn motion<'py>(&self, py: Python<'py>) -> PyResult<Motion<'py>> {
        Motion::new(py, &self.tables)
    }

    /// The motions after every homotopy step.
    fn stages<'py>(&self, py: Python<'py>) -> PyResult<Vec<Motion<'py>>> {
        let tables = self.stage_tables().map_err(|error| exception(&error))?;
        tables.iter().map(|tables| Motion::new(py, tables)).collect()
    }

    /// Names of parameters with the derivative of the optimal cost; none where they are not known.
    fn sensitivities(&self, py: Python) -> PyResult<Option<Vec<(String, f64)>>> {
        let Some(plan) = self.in_memory() else { return Ok(None) };
        let found = background::run(py, None, move |_| Ok(sensitivities(&plan)))?;
        let named = |(parameter, slope): (Parameter, f64)| (parameter.to_string(), slope);
        Ok(found.map(|found| found.into_iter().map(named).collect()))
    }

    /// Every constraint where the solver ended, as JSON; null where that point is not known any more.
    fn constraints(&self, py: Python) -> PyResult<String> {
        let plan = self.in_memory();
        background::run(py, None, move |_| {
            let records = plan.as_ref().and_then(optimum);
            serde_json::to_string(&records).map_err(|_| PlannerError::Internal("constraints"))
        })
    }
}

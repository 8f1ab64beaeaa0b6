//! The plans whose tolerances are measured: a given one, or one for each row of a map, made here.

use std::path::{Path, PathBuf};
use std::time::Duration;

use planner::files::{PlanFolder, StoredPlan};
use planner::{Choices, PlannerError, Problem, RobustnessTarget, RunClock, Session, Stop};
use scene::RobustnessSpec;
use simulation::{Reference, Success};
use tolerance::{Quantity, Trials};

use crate::arguments::ToleranceCommandArguments;
use crate::played::problem_of;
use crate::solve::default_folder;

/// Share of the time limit from which on a plan that missed its target has had the whole of it.
const WHOLE_TIME: f64 = 0.8;

/// The plans.
pub enum Plans {
    /// One that was there before.
    Given(Box<(StoredPlan, Problem)>),
    /// Those that are made, below a folder.
    Made {
        /// The problem of the scene.
        problem: Box<Problem>,
        /// Folders of the plans.
        folders: Vec<PathBuf>,
    },
}

impl Plans {
    /// As the arguments say.
    pub fn of(arguments: &ToleranceCommandArguments) -> Result<Self, PlannerError> {
        let scene = &arguments.task.scene;
        match &arguments.plan {
            Some(folder) => {
                let plan = StoredPlan::open(folder)?;
                Ok(Self::Given(Box::new(problem_of(Some(scene), &arguments.tolerance, plan)?)))
            }
            None => {
                let tolerance = &arguments.tolerance;
                let choices = Choices {
                    position_tolerance: tolerance.position_tolerance,
                    angle_tolerance: tolerance.angle_tolerance,
                    ..arguments.task.choices()
                };
                Ok(Self::Made { problem: Box::new(Problem::load(scene, &choices)?), folders: Vec::new() })
            }
        }
    }

    /// Where results go.
    pub fn out(&self, arguments: &ToleranceCommandArguments) -> PathBuf {
        let own = || match self {
            Self::Given(given) => given.0.folder.clone(),
            Self::Made { problem, .. } => {
                let mut folder = default_folder(problem).into_os_string();
                folder.push("-tolerance");
                folder.into()
            }
        };
        arguments.out.clone().unwrap_or_else(own)
    }

    /// Folders of the plans.
    pub fn names(&self) -> Vec<String> {
        match self {
            Self::Given(given) => vec![given.0.folder.display().to_string()],
            Self::Made { folders, .. } => folders.iter().map(|folder| folder.display().to_string()).collect(),
        }
    }

    /// The frictions of the rollouts: as given, as the plan was refined for, or as scenes have them.
    pub fn frictions(&self, arguments: &ToleranceCommandArguments) -> Vec<f64> {
        if !arguments.friction.is_empty() {
            return arguments.friction.clone();
        }
        let refined = match self {
            Self::Given(given) => given.0.result.robust.as_ref(),
            Self::Made { .. } => None,
        };
        let mut frictions: Vec<f64> =
            refined.into_iter().flat_map(|robust| robust.after.0.iter().map(|group| group.friction)).collect();
        frictions.sort_by(f64::total_cmp);
        frictions.dedup();
        let problem = self.problem();
        if frictions.is_empty() { problem.scene().robustness.frictions.clone() } else { frictions }
    }

    fn problem(&self) -> &Problem {
        match self {
            Self::Given(given) => &given.1,
            Self::Made { problem, .. } => problem,
        }
    }

    /// The plan of the scene as it is. `None` when the session is interrupted.
    pub fn nominal(
        &mut self,
        arguments: &ToleranceCommandArguments,
        session: &Session,
    ) -> Result<Option<(Problem, Reference)>, PlannerError> {
        let problem = self.problem().clone();
        let reference = match self {
            Self::Given(given) => Some(given.0.reference()?),
            Self::Made { .. } => {
                let frictions = self.frictions(arguments);
                self.make(arguments, &problem, &frictions, "nominal", session)?
            }
        };
        Ok(reference.map(|reference| (problem, reference)))
    }

    /// The plan for a row of a map: the given one, or one that is made for the row. `None` when the session is interrupted.
    pub fn for_row(
        &mut self,
        arguments: &ToleranceCommandArguments,
        trials: &Trials,
        over: Quantity,
        at: f64,
        session: &Session,
    ) -> Result<Option<Reference>, PlannerError> {
        match self {
            Self::Given(given) => given.0.reference().map(Some),
            Self::Made { .. } => {
                let problem = row_problem(trials, over, at)?;
                let (_, scale) = over.unit();
                let frictions = if over == Quantity::Friction { vec![at] } else { self.frictions(arguments) };
                self.make(arguments, &problem, &frictions, &format!("{}-{:.4}", over.name(), scale * at), session)
            }
        }
    }

    /// A plan that is made now, or was made for the same problem, frictions and rate before.
    fn make(
        &mut self,
        arguments: &ToleranceCommandArguments,
        problem: &Problem,
        frictions: &[f64],
        name: &str,
        session: &Session,
    ) -> Result<Option<Reference>, PlannerError> {
        let folder = self.out(arguments).join("plans").join(name);
        if let Self::Made { folders, .. } = self {
            folders.push(folder.clone());
        }
        if let Some(known) = known(&folder, problem, frictions, arguments) {
            return known.reference().map(Some);
        }
        let claimed = PlanFolder::claim(&folder, &[&arguments.task.scene])?;
        let limit = Duration::from_secs_f64(arguments.time_limit);
        let clock = RunClock::start().limited(Some(limit));
        let session = Session {
            folder: Some(&claimed),
            clock,
            threads: session.threads,
            ..Session::new(session.observer, session.interrupted)
        };
        let target = RobustnessTarget {
            time_limit: limit,
            target_rate: arguments.target_rate,
            frictions: frictions.to_vec(),
            ..RobustnessTarget::of(&problem.scene().robustness)
        };
        let plan = planner::solve_robust(problem, &target, &session)?;
        if plan.stopped == Some(Stop::User) {
            return Ok(None);
        }
        claimed.finish(&plan)?;
        // As another run will read it, to the last bit.
        StoredPlan::open(&folder)?.reference().map(Some)
    }
}

/// A plan in a folder, if it was made for this problem, these frictions and this rate, and what more time could not improve.
fn known(
    folder: &Path,
    problem: &Problem,
    frictions: &[f64],
    arguments: &ToleranceCommandArguments,
) -> Option<StoredPlan> {
    let plan = StoredPlan::open(folder).ok()?;
    let robust = plan.result.robust.as_ref()?;
    let is_same = plan.result.made_from.problem == problem.identity()
        && requirements(&plan.problem().ok()?) == requirements(problem)
        && robust.target_rate == arguments.target_rate
        && robust.after.0.iter().all(|group| frictions.contains(&group.friction))
        && frictions.iter().all(|friction| robust.after.0.iter().any(|group| group.friction == *friction));
    let is_final = robust.reached || robust.wall_s >= WHOLE_TIME * arguments.time_limit;
    (is_same && is_final).then_some(plan)
}

/// What a refinement depends on beside the problem and the frictions: tolerances of the goal, errors to tolerate, and how round
/// edges are.
fn requirements(problem: &Problem) -> (Success, RobustnessSpec, f64) {
    let errors = RobustnessSpec { frictions: Vec::new(), edge_radius: None, ..problem.scene().robustness.clone() };
    (problem.success(), errors, problem.edge_radius())
}

/// The problem of a row.
fn row_problem(trials: &Trials, over: Quantity, at: f64) -> Result<Problem, PlannerError> {
    let problem = trials.problem();
    let (mut scene, mut offset_magnitude) = (problem.scene().clone(), problem.offset_magnitude());
    match over {
        Quantity::Offset => offset_magnitude = at,
        Quantity::Rotation => scene.robustness.rotation_error = at,
        // No part of the problem: the target of the refinement, and no error of the grasp.
        Quantity::Friction | Quantity::Hole => {}
        Quantity::Clearance => scene = trials.scene_with_clearance(at)?,
        Quantity::Chamfer => scene = trials.scene_with_chamfer(at)?,
    }
    Problem::new(scene, Some(&problem.start().name), Some(offset_magnitude), problem.homotopy().clone())
}

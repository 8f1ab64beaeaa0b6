//! References of the user: played, refined, and their rollouts in full.

use std::path::Path;

use ::scene::Scene;
use planner::files::{MotionTables, state_problem};
use planner::{Choices, PlannerError, Problem, refine_reference};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use simulation::{Reference, Settings};
use task::{Contact, GraspError, Pose, STATE, State, TWIST, Wrench};

use crate::arrays::{bytes, rows};
use crate::background::Watch;
use crate::contacts::points;
use crate::motion::Motion;
use crate::options::RobustOptions;

/// Smoothing of distances in rollouts (N m): none that can be seen.
const HARD: f64 = 1e-6;
/// How far the norm of a quaternion may be from 1.
const NORM_ERROR: f64 = 1e-3;

/// A reference, and which problem of the scene it is for.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct ReferenceOptions {
    /// States, or poses alone.
    states: PyBackedBytes,
    poses: bool,
    time_step: f64,
    start: Option<String>,
    delta: Option<f64>,
    rotation_error: Option<f64>,
}

impl ReferenceOptions {
    /// Its problem, with other tolerances of success (m, rad) where they are given.
    ///
    /// # Errors
    /// What is wrong with a choice.
    pub fn problem(
        &self,
        scene: &Scene,
        file: &Path,
        position_tolerance: Option<f64>,
        angle_tolerance: Option<f64>,
    ) -> Result<Problem, PlannerError> {
        let choices = Choices {
            start: self.start.clone(),
            offset_magnitude: self.delta,
            rotation_error: self.rotation_error,
            position_tolerance,
            angle_tolerance,
            ..Choices::default()
        };
        Problem::choose(scene.clone(), file, &choices)
    }

    /// The motion. Poses alone get the velocities that lead from knot to knot.
    ///
    /// # Errors
    /// When it has fewer than two knots, or one that is no state.
    pub fn reference(&self) -> Result<Reference, PlannerError> {
        let states: Vec<State> = match self.poses {
            true => rows(&self.states).into_iter().map(|pose| Pose(pose).at_rest()).collect(),
            false => rows(&self.states).into_iter().map(State).collect(),
        };
        let wrong = |problem: String| PlannerError::Choice { name: "reference", problem };
        if states.len() < 2 {
            return Err(wrong("needs at least two knots".to_owned()));
        }
        for (knot, state) in states.iter().enumerate() {
            if let Some(problem) = state_problem(state, NORM_ERROR) {
                return Err(wrong(format!("knot {knot}: {problem}")));
            }
        }
        let reference = Reference::new(self.time_step, &states);
        Settings::default().validate_for(&reference)?;
        Ok(if self.poses { reference.with_twists() } else { reference })
    }
}

/// Rollouts with all that happens in them.
pub struct Rollouts {
    tables: MotionTables,
    grasps: Vec<GraspError>,
    success: Vec<bool>,
    /// Position error (m), orientation error (rad), largest contact force (N), deepest penetration (m) of each.
    measures: Vec<[f64; 4]>,
    points: Vec<f64>,
}

/// As Python has them.
#[derive(IntoPyObject)]
pub struct RolloutData<'py> {
    motion: Motion<'py>,
    grasps: Bound<'py, PyBytes>,
    success: Vec<bool>,
    measures: Bound<'py, PyBytes>,
    points: Bound<'py, PyBytes>,
}

/// How rollouts are played in full.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RolloutOptions {
    /// Offset and rotation vector of each; the planned ones where there are none.
    grasps: Option<Vec<[[f64; 3]; 2]>>,
    friction: f64,
    settling_time: f64,
    time_step: f64,
    position_tolerance: Option<f64>,
    angle_tolerance: Option<f64>,
}

/// Plays a reference with hard contact.
///
/// # Errors
/// When a value is out of its range, or the arm does not reach the start.
pub fn rollouts(
    scene: &Scene,
    file: &Path,
    given: &ReferenceOptions,
    options: &RolloutOptions,
) -> Result<Rollouts, PlannerError> {
    let problem = given.problem(scene, file, options.position_tolerance, options.angle_tolerance)?;
    let (world, reference) = (problem.world(), given.reference()?);
    let RolloutOptions { friction, settling_time, time_step, .. } = *options;
    let settings = Settings { friction, settling_time, time_step };
    settings.validate_for(&reference)?;
    let listed = |grasps: &Vec<[[f64; 3]; 2]>| {
        grasps.iter().map(|&[offset, rotation]| GraspError { offset, rotation }).collect()
    };
    let grasps = options.grasps.as_ref().map_or_else(|| GraspError::distinct(world.grasps.clone()), listed);
    let played = problem.rollout_in(&world, settings)?.trajectory(&reference, &grasps, HARD);
    let success = problem.success();
    let quality = |index: usize| &played.scenarios[index].quality;
    let reached = |index| success.reached(quality(index).position_error, quality(index).orientation_error);
    let measures = |index| {
        let quality = quality(index);
        let penetration = quality.penetration.map_or(0.0, |peak| peak.value);
        [quality.position_error, quality.orientation_error, quality.max_force, penetration]
    };
    let (success, measures) = (0..grasps.len()).map(|index| (reached(index), measures(index))).unzip();
    let mut tables = MotionTables::new(&played, &world);
    pad(&mut tables);
    let poses: Vec<[f64; 7]> =
        tables.scenarios.iter().flat_map(|scenario| &scenario.states[1..]).map(|state| state.pose().0).collect();
    let points = points(&world.pairs, &poses, HARD);
    Ok(Rollouts { tables, grasps, success, measures, points })
}

/// Gives rollouts that diverged, and so ended early, the length of the others: by what is no number.
fn pad(tables: &mut MotionTables) {
    let (knots, pairs) = (tables.reference.len(), tables.pairs.len());
    for scenario in &mut tables.scenarios {
        scenario.states.resize(knots, State([f64::NAN; STATE]));
        scenario.wrenches.resize(knots - 1, Wrench([f64::NAN; TWIST]));
        scenario.contacts.resize(knots - 1, vec![Contact { distance: f64::NAN, force: f64::NAN }; pairs]);
    }
}

impl Rollouts {
    /// For Python.
    ///
    /// # Errors
    /// When there is no memory for it.
    pub fn data<'py>(&self, py: Python<'py>) -> PyResult<RolloutData<'py>> {
        let grasps: Vec<f64> =
            self.grasps.iter().flat_map(|grasp| grasp.offset.into_iter().chain(grasp.rotation)).collect();
        Ok(RolloutData {
            motion: Motion::new(py, &self.tables)?,
            grasps: bytes(py, &grasps)?,
            success: self.success.clone(),
            measures: bytes(py, self.measures.as_flattened())?,
            points: bytes(py, &self.points)?,
        })
    }
}

/// Refines a reference. Returns the states of the refined one, and the report as JSON.
///
/// # Errors
/// When the target is out of range.
pub fn refine(
    scene: &Scene,
    file: &Path,
    given: &ReferenceOptions,
    target: RobustOptions,
    jobs: Option<usize>,
    watch: &Watch,
) -> Result<(Vec<f64>, String), PlannerError> {
    let problem = given.problem(scene, file, None, None)?;
    let target = target.target(problem.scene())?;
    let session = watch.session(jobs);
    let clock = session.clock.limited(Some(target.time_limit));
    let session = planner::Session { clock, ..session };
    let (reference, report) = refine_reference(&problem, given.reference()?, &target, &session)?;
    let states = reference.states().into_iter().flat_map(|state| state.0).collect();
    let report = serde_json::to_string(&report).map_err(|_| PlannerError::Internal("a report"))?;
    Ok((states, report))
}

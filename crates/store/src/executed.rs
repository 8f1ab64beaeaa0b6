//! An execution, beside a rollout with the same grasp error.
//!
//! If the part ends at its goal, its end gives the grasp error. For any other motion the grasp error is unknown, and
//! the rollout of the closest planned grasp error is used instead.

use std::path::Path;

use nalgebra::{Isometry3, Vector3};
use plan::records::GraspRecord;
use plan::{Millimetres, PlannerError, Problem};
use serde::Deserialize;
use simulation::{Reference, Settings};
use task::pose::interpolate;
use task::{GraspError, Pose, State};

use crate::{ExecutedState, PlayedRows, StoredPlan, read_log_header, read_played_rows};

/// First line of a log: its session.
#[derive(Debug, Default, Deserialize)]
struct Header {
    scene: String,
    problem: String,
    dry_run_m: f64,
    /// Why the robot was stopped, if it was.
    #[serde(default)]
    stopped: Option<String>,
}

/// How a motion ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// As if the part were at its goal and sat in the gripper with a grasp error that was planned for.
    AtGoal,
    /// Elsewhere: at its goal, the part would sit in the gripper with this error, longer than the plan's offsets and the
    /// tolerance of success.
    Missed(GraspError),
    /// Before the end of the plan, with the reason if the log has one.
    Stopped(Option<String>),
}

/// How a motion was executed.
#[derive(Debug, Clone, PartialEq)]
pub struct Execution {
    /// How it ended.
    pub ending: Ending,
    /// How the part sat in the gripper, if it ended at its goal; else the planned grasp error whose rollout is closest to
    /// the motion.
    pub grasp: GraspError,
    /// Friction of that rollout: of those given, the one that is closest to the motion.
    pub friction: f64,
    /// Whether that rollout reaches the goal.
    pub rollout_succeeds: bool,
    /// The motion since the plan was started, at least one state; times increase.
    pub course: Vec<ExecutedState>,
    /// Distance (m) between where the robot and the rollout believe the part at these times.
    pub distances: Vec<f64>,
    /// Offset magnitude that was planned for (m).
    offset_magnitude: f64,
}

impl Execution {
    /// Reads the log of a player: the columns of `reference.csv` with the believed pose of the part, and `phase`.
    /// Rollouts have these frictions, at least one.
    ///
    /// # Errors
    /// When the log cannot be read, is of another plan or of a dry run, or has no executed plan; when a
    /// rollout cannot be made.
    pub fn read(
        file: &Path,
        problem: &Problem,
        plan: &StoredPlan,
        settings: &[Settings],
    ) -> Result<Self, PlannerError> {
        let header = read_log_header::<Header>(file)?.unwrap_or_default();
        header.require_comparable(file, plan)?;
        let Some(PlayedRows { course, rested }) = read_played_rows(file)? else {
            let reason = header.stopped.map_or_else(String::new, |reason| format!(": {reason}"));
            let problem = format!("no row has the phase `playing`: the plan was not executed{reason}");
            return Err(PlannerError::file(file, problem));
        };
        let reference = plan.reference()?;
        require_duration(file, &course, &reference)?;
        let ending = match header.stopped {
            None if rested => ending(problem, &course),
            reason => Ending::Stopped(reason),
        };
        let grasps = match ending {
            Ending::AtGoal => vec![grasp_at_end(problem, &course)],
            _ => GraspError::distinct(problem.task().grasps.clone()),
        };
        let rollouts = settings.iter().flat_map(|settings| grasps.iter().map(move |grasp| (settings, grasp)));
        let beside = |(settings, grasp): (&Settings, &GraspError)| {
            Self::beside(&course, &ending, problem, &reference, *settings, *grasp)
        };
        let executions: Vec<Self> = rollouts.map(beside).collect::<Result<_, _>>()?;
        let closest = executions.into_iter().min_by(|one, other| one.mean_distance().total_cmp(&other.mean_distance()));
        closest.ok_or(PlannerError::Internal("an execution without a rollout"))
    }

    /// Beside a rollout with some grasp error.
    fn beside(
        course: &[ExecutedState],
        ending: &Ending,
        problem: &Problem,
        reference: &Reference,
        settings: Settings,
        grasp: GraspError,
    ) -> Result<Self, PlannerError> {
        let mut believed = Vec::new();
        let outcome = problem.rollout(settings)?.play(reference, grasp, |state, _| {
            believed.push((state.time, state.pose.isometry() * grasp.believed()));
        });
        Ok(Self {
            ending: ending.clone(),
            grasp,
            friction: settings.friction,
            rollout_succeeds: outcome.succeeds(&problem.success(), &problem.task().limits),
            course: course.to_vec(),
            distances: course.iter().map(|state| distance(&believed, state)).collect(),
            offset_magnitude: problem.offset_magnitude(),
        })
    }

    /// Largest of the distances (m), and its time (s).
    pub fn largest_distance(&self) -> (f64, f64) {
        let distances = self.distances.iter().zip(&self.course).map(|(distance, state)| (*distance, state.time));
        distances.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or_default()
    }

    /// Mean of the distances (m).
    pub fn mean_distance(&self) -> f64 {
        self.distances.iter().sum::<f64>() / self.distances.len() as f64
    }

    /// Time at which it ended (s), since the plan was started.
    pub fn duration(&self) -> f64 {
        self.course.last().map_or(0.0, |state| state.time)
    }

    /// State at a time (s) between the first and the last one, and distance there (m). Poses are interpolated.
    pub fn at(&self, time: f64) -> (ExecutedState, f64) {
        let after = self.course.partition_point(|state| state.time <= time).min(self.course.len() - 1);
        let before = after.saturating_sub(1);
        let (from, to) = (&self.course[before], &self.course[after]);
        let fraction = ((time - from.time) / (to.time - from.time).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let nearest = if fraction < 0.5 { before } else { after };
        let mut state = ExecutedState { time, ..self.course[nearest] };
        let [from, to] = [from, to].map(|state| state.believed.pose().isometry());
        state.believed = State::new(&Pose::from(&interpolate(&from, &to, fraction)), &state.believed.twist());
        (state, self.distances[nearest])
    }

    /// The results as sentences without full stops.
    pub fn sentences(&self) -> Vec<String> {
        let in_words = |grasp: &GraspError| {
            let length = Vector3::from(grasp.offset).norm();
            format!(
                "{} ({} mm of the {} mm planned for)",
                GraspRecord::from(grasp),
                Millimetres(length),
                Millimetres(self.offset_magnitude)
            )
        };
        let mut sentences = match &self.ending {
            Ending::AtGoal => {
                vec![format!("if the part ended at its goal, it sat in the gripper with {}", in_words(&self.grasp))]
            }
            Ending::Missed(grasp) => vec![format!(
                "the part did not end at its goal: reaching it would imply a grasp error of {}, larger than planned for",
                in_words(grasp)
            )],
            Ending::Stopped(reason) => vec![format!(
                "the robot was stopped {:.2} s after the plan started: {}",
                self.duration(),
                reason.as_deref().unwrap_or("the log gives no reason")
            )],
        };
        let (largest, time) = self.largest_distance();
        let compared = match self.ending {
            Ending::AtGoal => "with this grasp error".to_owned(),
            _ => format!(
                "the grasp error is unknown; of the planned ones, that with {} is closest: with it",
                GraspRecord::from(&self.grasp)
            ),
        };
        sentences.push(format!(
            "{compared}, a rollout at friction {} {} the goal; the robot was up to {:.1} mm from it (at {time:.2} s), {:.1} mm \
             on average",
            self.friction,
            if self.rollout_succeeds { "reaches" } else { "misses" },
            1e3 * largest,
            1e3 * self.mean_distance()
        ));
        sentences
    }
}

impl Header {
    /// Refuses logs of other plans and of dry runs.
    fn require_comparable(&self, file: &Path, plan: &StoredPlan) -> Result<(), PlannerError> {
        if !self.problem.is_empty() && self.problem != plan.result.made_from.problem {
            let problem = format!(
                "the log is of another plan than {}, of scene `{}`; name the folder of the plan that was exported",
                plan.folder.display(),
                self.scene
            );
            return Err(PlannerError::line(file, 1, problem));
        }
        if self.dry_run_m > 0.0 {
            let problem = format!(
                "a dry run, {:.0} mm from the goal, touches nothing, and there is nothing to compare; `assembly-plan calibrate` \
                 reads it",
                1e3 * self.dry_run_m
            );
            return Err(PlannerError::line(file, 1, problem));
        }
        Ok(())
    }
}

/// Refuses logs that last much longer than their plan.
fn require_duration(file: &Path, course: &[ExecutedState], reference: &Reference) -> Result<(), PlannerError> {
    /// Longest rest at the end of a plan (s).
    const LONGEST_REST: f64 = 60.0;
    let (plan, log) =
        (reference.intervals() as f64 * reference.time_step(), course.last().map_or(0.0, |state| state.time));
    if log > plan + LONGEST_REST {
        let problem = format!(
            "column time_s: the log lasts {log:.0} s after the plan started, which takes {plan:.1} s; name the folder of \
             the plan that was exported, and keep the rows as the player wrote them"
        );
        return Err(PlannerError::file(file, problem));
    }
    Ok(())
}

/// How a motion ended that was not stopped.
fn ending(problem: &Problem, course: &[ExecutedState]) -> Ending {
    let grasp = grasp_at_end(problem, course);
    let (success, rotation_error) = (problem.success(), problem.scene().robustness.rotation_error);
    let is_planned = Vector3::from(grasp.offset).norm() <= problem.offset_magnitude() + success.position
        && Vector3::from(grasp.rotation).norm() <= rotation_error + success.orientation;
    if is_planned { Ending::AtGoal } else { Ending::Missed(grasp) }
}

/// A part at its goal is believed beside it by the grasp error.
fn grasp_at_end(problem: &Problem, course: &[ExecutedState]) -> GraspError {
    let end = course.last().map_or_else(Isometry3::identity, |state| state.believed.pose().isometry());
    GraspError::of_believed(&(problem.scene().goal.isometry().inverse() * end))
}

/// Distance (m) to the first pose of a rollout at or after the time of a state. At its end, a rollout rests.
fn distance(rollout: &[(f64, Isometry3<f64>)], state: &ExecutedState) -> f64 {
    let index = rollout.partition_point(|(time, _)| *time < state.time);
    let position = Vector3::from_column_slice(&state.believed[..3]);
    let beside = rollout.get(index).or(rollout.last());
    beside.map_or(f64::NAN, |(_, pose)| (pose.translation.vector - position).norm())
}

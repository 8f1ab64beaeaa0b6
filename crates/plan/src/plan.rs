//! A plan and everything that it was made with.

use std::fmt;

use serde::{Deserialize, Serialize};
use simulation::Reference;
use task::{AssemblyTask, Trajectory};

use crate::iteration::PlanIteration;
use crate::problem::Problem;
use crate::records::{AttemptRecord, MotionRecord};
use crate::robustness::{RobustnessReport, TestReport};
use crate::success_rates::max_force;
use crate::variant::Variant;

/// A plan of a problem. It states how it was made: a robust plan may come from another horizon, other scenarios or
/// other smoothing than the problem's own.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The problem, with the homotopy and the horizon of the attempt that was kept.
    pub problem: Problem,
    /// Attempts until a plan reached the goal.
    pub attempts: Vec<AttemptRecord>,
    /// The variant that the homotopy has solved.
    pub variant: Variant,
    /// All homotopy steps that ran.
    pub iterations: Vec<PlanIteration>,
    /// The plan: its reference and the motion of every scenario.
    pub trajectory: Trajectory,
    /// The task whose pairs, offsets and horizon the trajectory has.
    pub task: AssemblyTask,
    /// For a refined plan, whose scenarios are rollouts with hard contact.
    pub robustness: Option<RobustnessReport>,
    /// How the plan of the solver does in rollouts with hard contact, where it was played and not refined.
    pub tested: Option<TestReport>,
    /// Threads of the solve.
    pub threads: usize,
    /// Reason for an early end of the work on it.
    pub stopped: Option<Stop>,
}

/// Reasons for an early end of the work on a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The user.
    User,
    /// The end of the session's time.
    TimeLimit,
    /// Its homotopy has led far enough for the rollouts that decide about it.
    Enough,
    /// Only the start of the first homotopy step is known: rollouts have shown that none is needed, or there was no time for it.
    Unsolved,
}

/// Status of a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PlanStatus {
    /// A refined plan: in rollouts with hard contact every planned offset succeeds at each friction, and the target
    /// success rate holds at each.
    Done,
    /// The solver converged and every planned offset reaches the goal in its smoothed model of contact.
    Planned,
    /// The solver converged, but not every planned offset reaches the goal.
    GoalMissed,
    /// The solver did not converge.
    NotConverged {
        /// Number of the homotopy step, from 1.
        iteration: usize,
        /// How it ended, in words.
        status: String,
    },
    /// Refinement did not reach the target success rate.
    NotRobust,
    /// Every planned offset reaches the goal, but exact shapes penetrate by more than the problem's largest penetration.
    Penetrating,
    /// The session's time ended before it was known whether the plan meets the requirements.
    OutOfTime(Cut),
    /// The user stopped it.
    Interrupted,
}

/// Work that the end of the time has cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cut {
    /// The homotopy.
    Homotopy {
        /// Homotopy steps that were finished.
        finished: usize,
        /// How many there are, at least.
        of: usize,
    },
    /// The last evaluation of a refined plan.
    Evaluation {
        /// Rollouts that were played.
        played: usize,
        /// How many there are.
        of: usize,
    },
}

/// Status of a plan, without details.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs, reason = "as PlanStatus")]
pub enum Outcome {
    Done,
    Planned,
    GoalMissed,
    NotConverged,
    NotRobust,
    #[serde(alias = "overlapping")]
    Penetrating,
    OutOfTime,
    Interrupted,
}

impl PlanStatus {
    /// Without details.
    pub fn outcome(&self) -> Outcome {
        match self {
            Self::Done => Outcome::Done,
            Self::Planned => Outcome::Planned,
            Self::GoalMissed => Outcome::GoalMissed,
            Self::NotConverged { .. } => Outcome::NotConverged,
            Self::NotRobust => Outcome::NotRobust,
            Self::Penetrating => Outcome::Penetrating,
            Self::OutOfTime(_) => Outcome::OutOfTime,
            Self::Interrupted => Outcome::Interrupted,
        }
    }
}

impl fmt::Display for PlanStatus {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Done => formatter.write_str("done"),
            Self::Planned => formatter.write_str("planned, not tested"),
            Self::GoalMissed => formatter.write_str("converged, but the goal is not reached"),
            Self::NotConverged { iteration, status } => write!(formatter, "homotopy step {iteration}: {status}"),
            Self::NotRobust => formatter.write_str("the target success rate is not reached"),
            Self::Penetrating => formatter.write_str("the exact shapes penetrate too deep"),
            Self::OutOfTime(cut) => write!(formatter, "out of time: {cut}"),
            Self::Interrupted => formatter.write_str("interrupted"),
        }
    }
}

impl fmt::Display for Cut {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Homotopy { finished, of } => {
                write!(formatter, "the time limit ended the solve after {finished} of at least {of} homotopy steps")
            }
            Self::Evaluation { played: 0, .. } => {
                formatter.write_str("the time limit ended before the plan was tested")
            }
            Self::Evaluation { played, of } => {
                write!(formatter, "the time limit ended the last evaluation after {played} of {of} rollouts")
            }
        }
    }
}

impl Plan {
    /// From a homotopy that has run at least one step, on some threads.
    pub fn new(
        problem: &Problem,
        variant: Variant,
        iterations: Vec<PlanIteration>,
        threads: usize,
        stopped: Option<Stop>,
    ) -> Self {
        let trajectory = iterations[iterations.len() - 1].trajectory.clone();
        let problem = problem.clone();
        let task = AssemblyTask { limits: problem.task().limits, ..variant.task.clone() };
        let mut plan = Self {
            problem,
            attempts: Vec::new(),
            variant,
            iterations,
            trajectory,
            task,
            robustness: None,
            tested: None,
            threads,
            stopped,
        };
        let PlanIteration { record, trajectory, .. } = plan.chosen().clone();
        // A plan that was stopped early may have fewer steps.
        (plan.task, plan.trajectory) = (record.task(&plan.task), trajectory);
        plan
    }

    /// Number, from 1, of the homotopy step that is the plan. It is the last one, unless continuing beyond the regular
    /// number made the plan worse: then it is the last that converged and reaches the goal, or at least converged.
    pub fn chosen_stage(&self) -> usize {
        let worth = |&number: &usize| {
            let PlanIteration { record, trajectory, .. } = &self.iterations[number - 1];
            let error = trajectory.worst_error();
            (record.converged, record.converged && self.problem.success().reached(error.position, error.orientation))
        };
        let count = self.iterations.len();
        // Of equally good steps, the last.
        (self.variant.settings.iterations..=count).max_by_key(worth).unwrap_or(count)
    }

    /// The homotopy step that is the plan.
    pub fn chosen(&self) -> &PlanIteration {
        &self.iterations[self.chosen_stage() - 1]
    }

    /// The motion to track.
    pub fn reference(&self) -> Reference {
        Reference::from(&self.trajectory)
    }

    /// Duration, forces and departures of its motion, in its scenarios and in the rollouts that tested it.
    pub fn motion(&self) -> MotionRecord {
        let motion = MotionRecord::new(&self.trajectory, &self.task);
        let played = self.robustness.as_ref().map(|report| &report.after);
        let played =
            played.or(self.tested.as_ref().map(|report| &report.rates)).map_or(0.0, |rates| max_force(&rates.0));
        MotionRecord { max_force_n: motion.max_force_n.max(played), ..motion }
    }

    /// Whether all regular steps of its own homotopy ran and the one that is the plan found a solution.
    pub fn is_converged(&self) -> bool {
        self.iterations.len() >= self.variant.settings.iterations && self.chosen().record.converged
    }

    /// Whether every planned offset reaches the goal; for a refined plan at every friction.
    pub fn reaches_goal(&self) -> bool {
        let error = self.trajectory.worst_error();
        match &self.robustness {
            Some(report) => report.planned_offsets_succeed(),
            None => self.problem.success().reached(error.position, error.orientation),
        }
    }

    /// Whether the penetration of exact shapes is within the problem's limit; for an unrefined plan, within what its
    /// last smoothing explains.
    pub fn keeps_apart(&self) -> bool {
        let smoothing = match self.robustness {
            Some(_) => 0.0,
            None => self.task.smoothing_gap(self.chosen().record.tau),
        };
        self.trajectory.max_penetration() <= self.problem.allowed_penetration().max(smoothing)
    }

    /// Its status.
    pub fn status(&self) -> PlanStatus {
        if self.stopped == Some(Stop::User) {
            return PlanStatus::Interrupted;
        }
        match &self.robustness {
            Some(report) if report.unplayed > 0 => {
                let played = report.after.rollouts();
                PlanStatus::OutOfTime(Cut::Evaluation { played, of: played + report.unplayed })
            }
            Some(report) if !report.reached => PlanStatus::NotRobust,
            None if !self.is_converged() => self.unconverged(),
            None if !self.reaches_goal() => PlanStatus::GoalMissed,
            _ if !self.keeps_apart() => PlanStatus::Penetrating,
            Some(_) => PlanStatus::Done,
            None => PlanStatus::Planned,
        }
    }

    fn unconverged(&self) -> PlanStatus {
        let (finished, of) = (self.iterations.len(), self.variant.settings.iterations);
        match self.stopped {
            Some(Stop::TimeLimit) if finished < of => PlanStatus::OutOfTime(Cut::Homotopy { finished, of }),
            _ => {
                PlanStatus::NotConverged { iteration: self.chosen_stage(), status: self.chosen().record.status.clone() }
            }
        }
    }

    /// Whether the end of the time has stopped work that another run can resume.
    pub fn can_go_on(&self) -> bool {
        let is_finished = matches!(self.status(), PlanStatus::Done | PlanStatus::Planned);
        matches!(self.stopped, Some(Stop::User | Stop::TimeLimit)) && !is_finished
    }

    /// Whether it has fewer steps than its problem, because the time ended before the homotopy went over to all of them.
    pub fn is_coarse(&self) -> bool {
        self.robustness.is_none() && self.chosen().record.is_coarse(&self.variant.task)
    }
}

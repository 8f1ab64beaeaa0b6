//! A plan and everything that it was made with.

use std::fmt;

use simulation::Reference;
use task::{AssemblyTask, Trajectory};

use crate::attempt::AttemptRecord;
use crate::files::MotionRecord;
use crate::iteration::PlanIteration;
use crate::problem::Problem;
use crate::robustness::RobustnessReport;
use crate::variant::Variant;

/// A plan of a problem. It says itself what it was made with: a robust plan may come from another horizon, other
/// scenarios or other smoothing than the problem's own.
#[derive(Debug, Clone)]
pub struct Plan {
    /// What was asked for, with the homotopy and the horizon of the attempt that was kept.
    pub problem: Problem,
    /// What was tried until a plan reached the goal.
    pub attempts: Vec<AttemptRecord>,
    /// What the homotopy has really solved.
    pub variant: Variant,
    /// All homotopy iterations that ran.
    pub iterations: Vec<PlanIteration>,
    /// The plan: its reference and the motion of every scenario.
    pub trajectory: Trajectory,
    /// The task whose pairs, offsets and horizon the trajectory has.
    pub task: AssemblyTask,
    /// Of a refined plan, whose scenarios are rollouts with hard contact.
    pub robustness: Option<RobustnessReport>,
    /// Threads of the solve.
    pub threads: usize,
    /// Whether the user stopped it.
    pub interrupted: bool,
}

/// What has become of a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PlanStatus {
    /// The solver converged and every planned offset reaches the goal; a refined plan reaches the wanted success rate.
    Done,
    /// The solver converged, but not every planned offset reaches the goal.
    GoalMissed,
    /// The solver did not converge.
    NotConverged {
        /// Number of the homotopy iteration, from 1.
        iteration: usize,
        /// How it ended, in words.
        status: String,
    },
    /// Refinement did not reach the wanted success rate.
    NotRobust,
    /// Every planned offset reaches the goal, but exact shapes overlap by more than the problem's largest overlap.
    Overlapping,
    /// The user stopped it.
    Interrupted,
}

impl fmt::Display for PlanStatus {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Done => formatter.write_str("done"),
            Self::GoalMissed => formatter.write_str("converged, but the goal is not reached"),
            Self::NotConverged { iteration, status } => write!(formatter, "homotopy iteration {iteration}: {status}"),
            Self::NotRobust => formatter.write_str("the wanted success rate is not reached"),
            Self::Overlapping => formatter.write_str("the exact shapes overlap too deep"),
            Self::Interrupted => formatter.write_str("interrupted"),
        }
    }
}

impl Plan {
    /// Of a homotopy that has run at least one iteration, on some threads.
    pub(crate) fn new(
        problem: &Problem,
        variant: Variant,
        iterations: Vec<PlanIteration>,
        threads: usize,
        interrupted: bool,
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
            threads,
            interrupted,
        };
        plan.trajectory = plan.chosen().trajectory.clone();
        plan
    }

    /// Number, from 1, of the homotopy iteration that is the plan. It is the last one, unless going on beyond the wanted
    /// number made the plan worse: then it is the last that converged and reaches the goal, or at least converged.
    pub fn chosen_stage(&self) -> usize {
        let worth = |&number: &usize| {
            let PlanIteration { record, trajectory, .. } = &self.iterations[number - 1];
            let (position, orientation) = trajectory.worst_errors();
            (record.converged, record.converged && self.problem.success().reached(position, orientation))
        };
        let count = self.iterations.len();
        // Of equals, the last.
        (self.variant.settings.iterations..=count).max_by_key(worth).unwrap_or(count)
    }

    /// The homotopy iteration that is the plan.
    pub fn chosen(&self) -> &PlanIteration {
        &self.iterations[self.chosen_stage() - 1]
    }

    /// The motion to track.
    pub fn reference(&self) -> Reference {
        Reference::new(self.trajectory.time_step, &self.trajectory.reference)
    }

    /// How it moves and how hard it presses.
    pub fn motion(&self) -> MotionRecord {
        MotionRecord::new(&self.trajectory, &self.task)
    }

    /// Whether all wanted iterations of its own homotopy ran and the one that is the plan found a solution.
    pub fn is_converged(&self) -> bool {
        self.iterations.len() >= self.variant.settings.iterations && self.chosen().record.converged
    }

    /// Whether every planned offset reaches the goal; for a refined plan at every friction.
    pub fn reaches_goal(&self) -> bool {
        let (position, orientation) = self.trajectory.worst_errors();
        match &self.robustness {
            Some(report) => report.planned_offsets_succeed(),
            None => self.problem.success().reached(position, orientation),
        }
    }

    /// Whether exact shapes overlap no deeper than the problem allows.
    pub fn keeps_apart(&self) -> bool {
        self.trajectory.max_penetration() <= self.problem.max_overlap()
    }

    /// What has become of it.
    pub fn status(&self) -> PlanStatus {
        if self.interrupted {
            return PlanStatus::Interrupted;
        }
        match &self.robustness {
            Some(report) if !report.is_reached() => PlanStatus::NotRobust,
            None if !self.is_converged() => {
                PlanStatus::NotConverged { iteration: self.chosen_stage(), status: self.chosen().record.status.clone() }
            }
            None if !self.reaches_goal() => PlanStatus::GoalMissed,
            _ if !self.keeps_apart() => PlanStatus::Overlapping,
            _ => PlanStatus::Done,
        }
    }
}

//! A plan before it is written.

use nlp::SolveStatus;
use ocp::HomotopyIteration;
use task::{AssemblyTask, Trajectory};

use crate::robust::Report;
use crate::stage::Stage;

/// A plan and where it comes from.
pub struct Planned {
    /// Records of all homotopy iterations that ran.
    pub stages: Vec<Stage>,
    /// The last of them.
    pub last: HomotopyIteration,
    /// The plan.
    pub trajectory: Trajectory,
    /// The problem whose pairs and horizon the trajectory has.
    pub task: AssemblyTask,
    /// Of a robust plan.
    pub report: Option<Report>,
}

impl Planned {
    /// Whether the user stopped its homotopy.
    pub fn is_interrupted(&self) -> bool {
        self.last.status == SolveStatus::Interrupted
    }
}

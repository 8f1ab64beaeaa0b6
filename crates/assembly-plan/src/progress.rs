//! What the user sees while a problem is solved: one line that is rewritten on a terminal, one line per homotopy
//! iteration otherwise.

use std::io::{IsTerminal, Write, stderr};

use ocp::{Event, HomotopyIteration};

/// Progress on standard error.
pub struct Progress {
    rewrites: bool,
}

impl Progress {
    /// Rewrites a line only on a terminal.
    pub fn new() -> Self {
        Self { rewrites: stderr().is_terminal() }
    }

    /// Shows an iteration of the solver.
    pub fn iteration(&self, event: &Event) {
        if !self.rewrites {
            return;
        }
        let progress = event.progress;
        // A terminal that cannot be written to is no reason to stop.
        let _ = write!(
            stderr(),
            "\r\x1b[Kstage {}/{} (tau {:.2e}): iteration {}, objective {:.5}, infeasibility {:.1e}{}",
            event.number,
            event.count,
            event.smoothing.tau,
            progress.iteration,
            progress.objective,
            progress.primal_infeasibility,
            if progress.restoration { ", restoring feasibility" } else { "" }
        );
    }

    /// Shows the end of a homotopy iteration.
    pub fn stage(&self, number: usize, stages: usize, result: &HomotopyIteration) {
        let (position, _) = result.trajectory.worst_errors();
        let clear = if self.rewrites { "\r\x1b[K" } else { "" };
        let _ = writeln!(
            stderr(),
            "{clear}stage {number}/{stages} (tau {:.2e}): {}, {} iterations, {:.1} s, objective {:.5}, goal error {:.2} mm",
            result.smoothing.tau,
            result.status,
            result.iterations,
            result.timing.total,
            result.objective,
            1e3 * position
        );
    }

    /// Shows how far a refinement is.
    pub fn refinement(&self, failing: usize, trials: usize, changes: usize) {
        if self.rewrites {
            // A terminal that cannot be written to is no reason to stop.
            let _ = write!(
                stderr(),
                "\r\x1b[Krefining the reference: {failing} of {trials} rollouts fail, {changes} changes kept"
            );
        }
    }

    /// Says something.
    pub fn say(&self, line: &str) {
        let clear = if self.rewrites { "\r\x1b[K" } else { "" };
        let _ = writeln!(stderr(), "{clear}{line}");
    }
}

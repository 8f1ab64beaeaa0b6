//! What the user sees while a problem is solved and refined: one line that is rewritten on a terminal, one line per event
//! otherwise.

use std::io::{IsTerminal, Write, stderr};

use planner::{Event, Observer};

/// Clears the line that is rewritten.
const CLEAR: &str = "\r\x1b[K";

/// Progress on standard error.
pub struct Progress {
    rewrites: bool,
}

impl Progress {
    /// Rewrites a line only on a terminal.
    pub fn new() -> Self {
        Self { rewrites: stderr().is_terminal() }
    }

    /// Says something that stays.
    fn say(&self, line: &str) {
        let clear = if self.rewrites { CLEAR } else { "" };
        // A terminal that cannot be written to is no reason to stop.
        let _ = writeln!(stderr(), "{clear}{line}");
    }

    /// Says something until something else is said.
    fn flash(&self, line: &str) {
        if self.rewrites {
            let _ = write!(stderr(), "{CLEAR}{line}");
        }
    }
}

impl Observer for Progress {
    fn observe(&self, event: &Event) {
        match event {
            Event::Iteration(event) => self.flash(&solver_iteration(event)),
            Event::Change { failing, trials, changes } => {
                self.flash(&format!(
                    "refining the reference: {failing} of {trials} rollouts fail, {changes} changes kept"
                ));
            }
            other => self.say(&line(other)),
        }
    }
}

fn solver_iteration(event: &planner::SolverEvent) -> String {
    let progress = event.progress;
    format!(
        "homotopy iteration {} of at most {} (tau {:.2e}): iteration {}, objective {:.5}, infeasibility {:.1e}{}",
        event.number,
        event.most,
        event.smoothing.tau,
        progress.iteration,
        progress.objective,
        progress.primal_infeasibility,
        if progress.restoration { ", restoring feasibility" } else { "" }
    )
}

/// An event in words.
fn line(event: &Event) -> String {
    match event {
        Event::HomotopyIteration { number, most, record, position_error } => format!(
            "homotopy iteration {number} of at most {most} (tau {:.2e}): {}, {} iterations, {:.1} s, objective {:.5}, \
             goal error {:.2} mm",
            record.tau,
            record.status,
            record.iterations,
            record.wall_s,
            record.objective,
            1e3 * position_error
        ),
        Event::Attempt { planned, position_error } => {
            format!("the plan misses the goal by {:.2} mm; trying: {planned}", 1e3 * position_error)
        }
        Event::Resumed { refining: true, .. } => "going on with the refinement of an earlier run".to_owned(),
        Event::Resumed { done, most, .. } => {
            format!("going on after homotopy iteration {done} of at most {most} of an earlier run")
        }
        Event::Discarded { reason } => format!("the unfinished work of an earlier run is not used: {reason}"),
        Event::Evaluated { rate } => format!("{:.1} % of rollouts succeed", 100.0 * rate),
        Event::Refining { planned } => format!("refining: {planned}"),
        Event::Refined { rate } => format!("  {:.1} % succeed at offsets not trained on", 100.0 * rate),
        Event::Variant { name, number, count } => {
            format!("refinement is stuck; solving variant {number}/{count}: {name}")
        }
        Event::VariantSolved { status } => format!("  {status}"),
        Event::VariantTried { failing, trials } => format!("  {failing} of {trials} training rollouts fail"),
        Event::Iteration(_) | Event::Change { .. } => String::new(),
    }
}

//! Events of solving and refining: what is shown, said and logged of each.

use planner::{Event, Observer, SolverEvent};
use serde_json::{Value, json};

use super::Progress;
use super::words::{iteration, line};

impl Observer for Progress {
    fn observe(&self, event: &Event) {
        if self.log.is_some() {
            let (name, fields) = fields(event);
            self.record(name, &fields);
        }
        self.refinement.note(event);
        match event {
            Event::Iteration(SolverEvent { progress, number, most, smoothing, .. }) => {
                if self.is_verbose {
                    self.say(&iteration(progress));
                }
                let doing = if progress.restoration { ", restoring feasibility" } else { "" };
                let detail = format!(
                    "tau {:.2e}, iteration {}: objective {:.5}, infeasibility {:.1e}{doing}",
                    smoothing.tau, progress.iteration, progress.objective, progress.primal_infeasibility
                );
                let details = [vec![detail], self.refinement.lines()].concat();
                self.show("homotopy iterations", (*number - 1, *most), &details);
            }
            Event::Change { failing, trials, changes } => {
                let kept = if *changes == 1 { "change" } else { "changes" };
                let details = [self.refinement.lines(), vec![format!("{changes} {kept} kept")]].concat();
                self.show("training rollouts succeed", (trials - failing, *trials), &details);
            }
            Event::Rollouts { done, count } => self.show_with_end("rollouts", (*done, *count)),
            other => self.say(&line(other)),
        }
    }
}

/// Name and fields of an event in the log.
fn fields(event: &Event) -> (&'static str, Value) {
    match event {
        Event::Iteration(SolverEvent { progress, number, smoothing, .. }) => (
            "solver_iteration",
            json!({
                "homotopy_iteration": number,
                "tau": smoothing.tau,
                "iteration": progress.iteration,
                "objective": progress.objective,
                "primal_infeasibility": progress.primal_infeasibility,
                "dual_infeasibility": progress.dual_infeasibility,
                "barrier": progress.mu,
                "restoration": progress.restoration,
            }),
        ),
        Event::HomotopyIteration { number, most, record, position_error } => (
            "homotopy_iteration",
            json!({ "number": number, "most": most, "position_error_m": position_error, "record": record }),
        ),
        Event::Attempt { planned, position_error } => {
            ("attempt", json!({ "planned": planned, "position_error_m": position_error }))
        }
        Event::Resumed { done, most, refining } => {
            ("resumed", json!({ "done": done, "most": most, "refining": refining }))
        }
        Event::Discarded { reason } => ("discarded", json!({ "reason": reason.to_string() })),
        Event::Evaluated { rate } => ("evaluated", json!({ "rate": rate })),
        Event::Refining { planned } => ("refining", json!({ "planned": planned })),
        Event::Change { failing, trials, changes } => {
            ("change", json!({ "failing": failing, "trials": trials, "changes": changes }))
        }
        Event::Refined { rate } => ("refined", json!({ "rate": rate })),
        Event::Variant { name, number, count } => {
            ("variant", json!({ "planned": name, "number": number, "count": count }))
        }
        Event::VariantSolved { status } => ("variant_solved", json!({ "status": status })),
        Event::VariantTried { failing, trials } => ("variant_tried", json!({ "failing": failing, "trials": trials })),
        Event::Rollouts { done, count } => ("rollouts", json!({ "done": done, "count": count })),
    }
}

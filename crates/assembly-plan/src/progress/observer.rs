//! Events of solving and refining: how each is shown, printed and logged.

use planner::{Event, Observer, SolverEvent};

use super::Progress;
use super::words::{iteration, line};

impl Observer for Progress {
    fn observe(&self, event: &Event) {
        if self.log.is_some() {
            let (name, fields) = event.record();
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
                self.show("homotopy steps", *number - 1, *most, &details);
            }
            Event::Perturbation { failing, cases, accepted } => {
                let noun = if *accepted == 1 { "perturbation" } else { "perturbations" };
                let details = [self.refinement.lines(), vec![format!("{accepted} {noun} kept")]].concat();
                self.show("training rollouts succeed", cases - failing, *cases, &details);
            }
            Event::Rollouts { done, count } => self.show_with_end("rollouts", *done, *count),
            other => self.say(&line(other)),
        }
    }
}

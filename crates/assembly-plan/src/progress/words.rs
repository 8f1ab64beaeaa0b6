//! Events in words.

use planner::{Event, SolverProgress};

/// Between two headings of the columns.
const HEADING: usize = 20;

/// An iteration of the solver, in the columns of Ipopt.
pub fn iteration(progress: &SolverProgress) -> String {
    let logarithm = |value: f64| if value > 0.0 { format!("{:.1}", value.log10()) } else { "-".to_owned() };
    let row = format!(
        "{:5}{} {:14.7e} {:.2e} {:.2e} {:>5} {:.2e} {:>5} {:.2e} {:.2e} {:3}",
        progress.iteration,
        if progress.restoration { "r" } else { " " },
        progress.objective,
        progress.primal_infeasibility,
        progress.dual_infeasibility,
        logarithm(progress.mu),
        progress.step_norm,
        logarithm(progress.regularization),
        progress.alpha_dual,
        progress.alpha_primal,
        progress.line_search_trials
    );
    match progress.iteration % HEADING {
        0 => format!("iter        objective   inf_pr   inf_du lg(mu) ||d||  lg(rg) alpha_du alpha_pr  ls\n{row}"),
        _ => row,
    }
}

/// An event in words.
pub fn line(event: &Event) -> String {
    match event {
        Event::HomotopyStep { number, most, record, position_error } => format!(
            "homotopy step {number} of at most {most} (tau {:.2e}): {}, {} iterations, {:.1} s, objective {:.5}, \
             goal error {:.2} mm",
            record.tau,
            record.status,
            record.iterations,
            record.wall_s,
            record.objective,
            1e3 * position_error
        ),
        Event::Attempt { planned, position_error } => {
            format!("not planned, with a goal error of {:.2} mm; trying: {planned}", 1e3 * position_error)
        }
        Event::Resumed { refining: true, .. } => "resuming the refinement of an earlier run".to_owned(),
        Event::Resumed { done, most, .. } => {
            format!("resuming after homotopy step {done} of at most {most} of an earlier run")
        }
        Event::Discarded { reason } => format!("the unfinished work of an earlier run is not used: {reason}"),
        Event::Evaluated { rate } => format!("{:.1} % of rollouts succeed", 100.0 * rate),
        Event::Refining { planned } => format!("refining: {planned}"),
        Event::Refined { rate } => format!("  {:.1} % succeed at offsets not trained on", 100.0 * rate),
        Event::Variant { name, number, count } => {
            format!("planning variant {number} of {count}: {name}")
        }
        Event::VariantSolved { status } => format!("  {status}"),
        Event::VariantTried { failing, cases } => format!("  {failing} of {cases} training rollouts fail"),
        Event::Iteration(_) | Event::Perturbation { .. } | Event::Rollouts { .. } => String::new(),
    }
}

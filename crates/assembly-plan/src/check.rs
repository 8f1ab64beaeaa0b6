//! `check`: what a scene says, and what is wrong with it, without solving it.

use planner::check::{Explanation, PairReport, explain, pair_reports};
use planner::{PlannerError, Problem};

use crate::arguments::CheckArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};

/// Checks a scene and prints what it says.
pub fn run(arguments: &CheckArguments) -> Result<Exit, CommandError> {
    let problem = Problem::load(&arguments.task.scene, &arguments.task.choices())?;
    let tau = arguments.tau.unwrap_or(problem.homotopy().tau);
    let pose = arguments.pose.map(|pose| pose.0);
    if arguments.json {
        problem.warnings().iter().for_each(|warning| tell!("warning: {warning}"));
        let reports = pair_reports(&problem, &pose.unwrap_or(problem.task().start), tau)?;
        let json = serde_json::to_string_pretty(&reports).map_err(|_| PlannerError::Internal("a report"))?;
        say!("{json}");
    } else if let Some(pose) = pose {
        problem.warnings().iter().for_each(|warning| tell!("warning: {warning}"));
        print_pairs(&pair_reports(&problem, &pose, tau)?, tau);
    } else {
        pair_reports(&problem, &problem.task().start, tau)?;
        print_explanation(&problem, &explain(&problem));
    }
    Ok(Exit::Done)
}

fn print_pairs(reports: &[PairReport], tau: f64) {
    say!("{:<20} {:<20} {:>12} {:>16}", "body", "environment", "exact (mm)", "smoothed (mm)");
    for report in reports {
        say!(
            "{:<20} {:<20} {:>12.4} {:>16.4}",
            report.body,
            report.environment,
            1e3 * report.exact_distance_m,
            1e3 * report.smoothed_distance_m
        );
    }
    say!("smoothed with tau = {tau}");
}

fn print_explanation(problem: &Problem, explanation: &Explanation) {
    let (scene, task) = (problem.scene(), problem.task());
    say!("{}: {} pairs of parts may touch", scene.title, task.pairs.len());
    for (parent, parts) in [("body", &scene.body), ("environment", &scene.environment)] {
        say!("\n{parent}");
        for part in parts {
            let (facets, vertices) = (part.shape.normals().len(), part.shape.vertices().len());
            say!("  {:<16} {:8.2} mm long, {facets} facets, {vertices} vertices", part.name, 1e3 * part.shape.size());
        }
    }
    let starts: Vec<&str> = scene.starts.iter().map(|start| start.name.as_str()).collect();
    say!("\nstarts: {}", starts.join(", "));
    say!("\nsmallest exact distance (negative: overlap)");
    say!("  goal                            {:8.3} mm", 1e3 * explanation.goal_clearance);
    say!("  start                           {:8.3} mm", 1e3 * explanation.start_clearance);
    for (number, (offset, distance)) in (1..).zip(&explanation.offset_clearances) {
        let [x, y, z] = offset.map(|component| 1e3 * component);
        say!("  start, offset {number} ({x:6.2} {y:6.2} {z:6.2}) {:7.3} mm", 1e3 * distance);
    }
    for (name, unit, limit) in task.limits.named() {
        if limit.is_finite() {
            say!("limit: {name} {limit} {unit}");
        }
    }
    say!(
        "\nproblem: {} steps of {} s, {} scenarios, {} variables, {} constraints; {} to {} homotopy iterations",
        explanation.steps,
        task.horizon.time_step,
        explanation.scenarios,
        explanation.variables,
        explanation.constraints,
        problem.homotopy().iterations,
        problem.homotopy().most_iterations()
    );
    explanation.warnings.iter().for_each(|warning| tell!("warning: {warning}"));
}

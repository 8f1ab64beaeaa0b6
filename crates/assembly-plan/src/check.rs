//! `check`: what a scene says, and what is wrong with it, without solving it.

use ocp::Transcription;
use scene::Scene;
use serde::Serialize;
use task::AssemblyTask;
use task::HomotopySettings;

use crate::DONE;
use crate::arguments::CheckArguments;
use crate::console::{say, tell};
use crate::failure::Failure;

/// Distances of one pair at one pose.
#[derive(Debug, Serialize)]
struct PairReport {
    body: String,
    environment: String,
    smoothed_distance_m: f64,
    exact_distance_m: f64,
    normal: [f64; 7],
}

/// Checks a scene and prints what it says.
pub fn run(arguments: &CheckArguments) -> Result<u8, Failure> {
    let scene = Scene::load(&arguments.task.scene)?;
    let start = arguments.task.start.as_deref();
    let task = scene.task(start, arguments.task.delta)?;
    let homotopy = scene.homotopy.clone().unwrap_or_else(scene::default_homotopy);
    let tau = arguments.tau.unwrap_or(homotopy.tau);
    if !(tau > 0.0 && tau.is_finite()) {
        return Err(Failure::Input(format!("--tau {tau}: must be positive")));
    }
    for warning in &scene.warnings {
        tell!("warning: {warning}");
    }
    let pose = arguments.pose.map(|pose| pose.0);
    if arguments.json {
        let report = pair_reports(&task, &pose.unwrap_or(task.start), tau)?;
        let json = serde_json::to_string_pretty(&report).map_err(|error| Failure::Internal(error.to_string()))?;
        say!("{json}");
    } else if let Some(pose) = pose {
        print_pairs(&pair_reports(&task, &pose, tau)?, tau);
    } else {
        explain(&scene, &task, &homotopy);
    }
    Ok(DONE)
}

fn pair_reports(task: &AssemblyTask, pose: &[f64; 7], tau: f64) -> Result<Vec<PairReport>, Failure> {
    let report = |pair: &task::ContactPair| {
        let distance = pair.shapes.distance(pose, tau).map_err(|error| {
            Failure::Internal(format!("distance of {} and {}: {error}", pair.body, pair.environment))
        })?;
        Ok(PairReport {
            body: pair.body.clone(),
            environment: pair.environment.clone(),
            smoothed_distance_m: distance.smoothed_distance,
            exact_distance_m: pair.shapes.exact_distance(pose),
            normal: distance.contact_normal,
        })
    };
    task.pairs.iter().map(report).collect()
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

fn explain(scene: &Scene, task: &AssemblyTask, homotopy: &HomotopySettings) {
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
    say!("  goal                            {:8.3} mm", 1e3 * task.clearance(&task.goal));
    say!("  start                           {:8.3} mm", 1e3 * task.clearance(&task.start));
    for (index, offset) in task.offsets.iter().enumerate() {
        let distance = task.clearance(&task::pose::without_offset(&task.start, offset));
        let [x, y, z] = offset.map(|component| 1e3 * component);
        say!("  start, offset {} ({x:6.2} {y:6.2} {z:6.2}) {:7.3} mm", index + 1, 1e3 * distance);
        if distance < 0.0 {
            tell!("warning: with offset {} the body overlaps the environment at the start", index + 1);
        }
    }
    if task.clearance(&task.goal) < 0.0 {
        tell!("warning: the body overlaps the environment at the goal; it cannot be reached");
    }
    for (name, unit, limit) in task.limits.named() {
        if limit.is_finite() {
            say!("limit: {name} {limit} {unit}");
        }
    }
    let settings = homotopy;
    let transcription = Transcription::new(task, settings.complementarity, settings.hessian);
    let layout = transcription.layout();
    say!(
        "\nproblem: {} steps of {} s, {} scenarios, {} variables, {} constraints; {} homotopy iterations",
        layout.steps,
        task.horizon.time_step,
        layout.scenarios,
        layout.variable_count(),
        layout.constraint_count(),
        settings.iterations
    );
    warn_about_smoothing(task, homotopy);
}

/// Warns when the first smoothing is smaller than the offset: the plan may then end in a wrong optimum. It often does not,
/// and success is not monotone in the first smoothing, so that this is no more than a hint.
fn warn_about_smoothing(task: &AssemblyTask, homotopy: &HomotopySettings) {
    let norm = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    let largest = task.offsets.iter().map(norm).fold(0.0, f64::max);
    let rows = task.pairs.iter().map(|pair| pair.shapes.row_count()).min().unwrap_or(0);
    let reach = homotopy.tau * rows as f64;
    if reach < 1.5 * largest {
        tell!(
            "warning: the first smoothing reaches {:.1} mm, the offset is {:.1} mm; if plans miss the goal, try a larger \
             homotopy.tau",
            1e3 * reach,
            1e3 * largest
        );
    }
}

//! `new`: write a scene to begin with, and say what was found and chosen.

use planner::files::write_new_scene;
use planner::{Problem, Starter, StarterFit, axis_name, starter, warnings};
use scene_templates::{Axis, FilePair, StarterValues};

use crate::arguments::NewArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::shell::word;

/// Writes the scene.
pub fn run(arguments: &NewArguments) -> Result<Exit, CommandError> {
    let starter = starter(&arguments.file, arguments.files().as_ref(), arguments.axis, &arguments.values())?;
    write_new_scene(&arguments.file, &starter.text, arguments.force)?;
    say!("written to {}", arguments.file.display());
    print_starter(&starter);
    warnings::of_problem(&starter.problem).iter().for_each(|warning| tell!("warning: {warning}"));
    say!("next: assembly-plan check {}", word(&arguments.file));
    Ok(Exit::Done)
}

fn print_starter(Starter { problem, fit, .. }: &Starter) {
    if let Some(StarterFit { edges_m: [body, environment], out, others, .. }) = fit {
        row("body", &edges(body));
        row("environment", &edges(environment));
        row(
            "insertion",
            &format!("along {}, so that the body is taken out along {out}{}", out.opposite(), free(others)),
        );
    }
    row("engagement", &engagement(problem));
    let clearance = problem.task().clearance(&problem.task().goal);
    row("clearance", &format!("{:.3} mm at the goal", 1e3 * clearance));
    let start = fit.as_ref().map(|fit| format!("{:.2} mm from the goal", 1e3 * fit.distance_m));
    start.iter().for_each(|start| row("start", start));
    row(
        "offset",
        &format!("{:.2} mm, how far the body may be off in the gripper (--offset)", 1e3 * problem.offset_magnitude()),
    );
    let chosen = problem.chosen_tolerance().map(|chosen| format!(": {}", chosen.reason())).unwrap_or_default();
    row(
        "tolerance",
        &format!(
            "{:.3} mm from the goal is a success{chosen} (--position-tolerance)",
            1e3 * problem.success().position
        ),
    );
    row("contact force", &format!("at most {} N (--contact-force)", problem.task().limits.contact_force));
}

fn row(name: &str, text: &str) {
    say!("  {name:<14} {text}");
}

fn edges([x, y, z]: &[f64; 3]) -> String {
    format!("{:.2} x {:.2} x {:.2} mm", 1e3 * x, 1e3 * y, 1e3 * z)
}

fn free(others: &[Axis]) -> String {
    let names: Vec<String> = others.iter().map(Axis::to_string).collect();
    if names.is_empty() { String::new() } else { format!("; it also gets out along {} (--axis)", names.join(", ")) }
}

/// What guides the body, in words.
fn engagement(problem: &Problem) -> String {
    let engagement = problem.engagement();
    let names: Vec<String> = engagement.free.iter().map(axis_name).collect();
    let depth = match (engagement.depth_m, engagement.clearance_m) {
        (Some(depth), Some(clearance)) => {
            format!("{:.2} mm deep, clearance of {:.3} mm where it is tightest", 1e3 * depth, 1e3 * clearance)
        }
        _ => "nothing guides the body on both sides".to_owned(),
    };
    if names.is_empty() { depth } else { format!("{depth}; the body is free along {}", names.join(" and ")) }
}

impl NewArguments {
    /// The files of parts, if any are named; the command line wants both or none.
    fn files(&self) -> Option<FilePair> {
        Some(FilePair {
            body: self.body.clone()?,
            body_link: self.link.clone(),
            environment: self.environment.clone()?,
            environment_link: self.environment_link.clone(),
            unit: self.unit.clone(),
        })
    }

    fn values(&self) -> StarterValues {
        let default = StarterValues::default();
        StarterValues {
            offset: self.offset,
            position_tolerance: self.position_tolerance,
            contact_force: self.contact_force.unwrap_or(default.contact_force),
        }
    }
}

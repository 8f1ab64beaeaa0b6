//! `simulate`: play plans closed loop under injected offsets and count how often they succeed.

use std::path::Path;
use std::time::Instant;

use scene::Scene;
use simulation::{Grasp, Reference, Rollout, Settings, Success, offsets};
use task::AssemblyTask;

use crate::DONE;
use crate::arguments::{SimulateArguments, threads};
use crate::console::{say, tell};
use crate::failure::Failure;
use crate::interrupt::exit_at_once;
use crate::output::{table, write_file};
use crate::plan::{Plan, read_numbers};
use crate::played::{Motion, Played};
use crate::success_table::SuccessTable;
use crate::trace::trace;

/// Poses closer than this (m, rad) are the same: files keep all digits.
const SAME_POSE: f64 = 1e-6;

/// Offsets that are counted together.
struct Injection {
    /// Magnitude, or the largest length in a list (m).
    magnitude: f64,
    /// Errors of the grasp.
    grasps: Vec<Grasp>,
}

/// Plays everything, writes both tables and prints the one of successes.
pub fn run(arguments: &SimulateArguments) -> Result<u8, Failure> {
    let scene = Scene::load(&arguments.scene)?;
    let plans = Plan::find(&arguments.folder)?;
    exit_at_once()?;
    let begin = Instant::now();
    let jobs = threads(arguments.jobs);
    let magnitudes = magnitudes(arguments, &plans);
    let mut played = Vec::new();
    for plan in &plans {
        if !plan.converged {
            tell!("warning: {}: the plan did not converge", plan.folder.display());
        }
        played.extend(play(arguments, &scene, plan, &magnitudes, jobs)?);
    }
    let seconds = begin.elapsed().as_secs_f64();
    warn_about_overlap(&played);
    let successes = SuccessTable::new(&played);
    let folder = arguments.out.as_ref().unwrap_or(&arguments.folder);
    write_file(&folder.join("rollouts.csv"), &rollouts(&played)?)?;
    write_file(&folder.join("success.csv"), &successes.to_csv()?)?;
    if let Some(file) = &arguments.trace {
        write_trace(file, arguments, &scene, &played)?;
    }
    say!(
        "{}: success is to end within {} mm and {} rad of the goal, in brackets Wilson's interval of 95 %; errors, overlap \
         and force are the largest of all rollouts\n\n{successes}",
        scene.title,
        1e3 * arguments.tolerance.position_tolerance,
        arguments.tolerance.angle_tolerance
    );
    let rate = 60.0 * played.len() as f64 / seconds;
    say!("{} rollouts in {seconds:.1} s, {rate:.0} per minute with {jobs} {}", played.len(), in_words(jobs));
    say!("written to {}", folder.display());
    Ok(DONE)
}

/// Plays all motions of one plan with all frictions and offsets.
fn play<'plan>(
    arguments: &SimulateArguments,
    scene: &Scene,
    plan: &'plan Plan,
    magnitudes: &[f64],
    jobs: usize,
) -> Result<Vec<Played<'plan>>, Failure> {
    let task = world(scene, plan)?;
    let motions = motions(arguments, plan, &task)?;
    let injections = injections(arguments, scene, magnitudes)?;
    let success = Success::from(&arguments.tolerance);
    let mut played = Vec::new();
    for &friction in &arguments.friction {
        let rollout = Rollout::new(&task, settings(arguments, friction));
        for (motion, reference) in &motions {
            for Injection { magnitude, grasps } in &injections {
                let outcomes = rollout.simulate(reference, grasps, jobs);
                played.extend(grasps.iter().zip(outcomes).map(|(&grasp, outcome)| Played {
                    plan,
                    motion: *motion,
                    friction,
                    magnitude: *magnitude,
                    grasp,
                    outcome,
                    success: outcome.is(&success),
                }));
            }
        }
    }
    Ok(played)
}

/// The task of a plan as it is in reality, which does not know which pairs the plan has left out.
fn world(scene: &Scene, plan: &Plan) -> Result<AssemblyTask, Failure> {
    let about_plan = |problem: scene::TaskError| Failure::Input(format!("{}: {problem}", plan.folder.display()));
    let task = scene.task(Some(&plan.start), Some(plan.delta)).map_err(about_plan)?;
    Ok(AssemblyTask { pairs: scene.all_pairs(), ..task })
}

fn settings(arguments: &SimulateArguments, friction: f64) -> Settings {
    Settings { time_step: arguments.time_step, friction, settling_time: arguments.settling_time }
}

/// `--trace`: plays the plan's first rollout again and writes its course.
fn write_trace(file: &Path, arguments: &SimulateArguments, scene: &Scene, played: &[Played]) -> Result<(), Failure> {
    let first = played.iter().find(|played| played.motion == Motion::Plan);
    let first = first.ok_or_else(|| Failure::Internal("no plan was played".to_owned()))?;
    let rollout = Rollout::new(&world(scene, first.plan)?, settings(arguments, first.friction));
    write_file(file, &trace(&rollout, &first.plan.reference()?, &first.grasp)?)
}

fn motions(
    arguments: &SimulateArguments,
    plan: &Plan,
    task: &AssemblyTask,
) -> Result<Vec<(Motion, Reference)>, Failure> {
    let mut motions = Vec::new();
    if arguments.stages {
        let stages = plan.stage_references()?.into_iter().enumerate();
        motions.extend(stages.map(|(index, reference)| (Motion::Stage(index + 1), reference)));
    }
    motions.push((Motion::Plan, plan.reference()?));
    for (_, reference) in &motions {
        let (distance, angle) = task::pose::errors(&reference.start(), &task.start);
        if distance > SAME_POSE || angle > SAME_POSE {
            return Err(Failure::Input(format!(
                "{}: the plan does not begin at start `{}` of {}; was it made from another scene?",
                plan.folder.display(),
                plan.start,
                arguments.scene.display()
            )));
        }
    }
    motions.push((Motion::StraightPush, Reference::straight(&task.start, &task.goal, task.horizon)));
    Ok(motions)
}

/// What the user asks for, else delta-hat of every plan; increasing.
fn magnitudes(arguments: &SimulateArguments, plans: &[Plan]) -> Vec<f64> {
    let mut magnitudes = arguments.magnitude.clone();
    if magnitudes.is_empty() {
        magnitudes = plans.iter().map(|plan| plan.delta).collect();
    }
    magnitudes.sort_by(f64::total_cmp);
    magnitudes.dedup();
    magnitudes
}

fn injections(arguments: &SimulateArguments, scene: &Scene, magnitudes: &[f64]) -> Result<Vec<Injection>, Failure> {
    if let Some(file) = &arguments.offsets {
        return Ok(vec![listed(file, arguments)?]);
    }
    let of_magnitude = |&magnitude: &f64| {
        let planned = scene.offsets(magnitude)?;
        let offsets = match (arguments.random, arguments.grid) {
            (Some(count), _) if arguments.ball => offsets::ball(magnitude, count as usize, arguments.seed),
            (Some(count), _) => offsets::hull(&planned, count as usize, arguments.seed),
            (_, Some(divisions)) => grid(&planned, divisions as usize)?,
            (None, None) => planned,
        };
        Ok(Injection { magnitude, grasps: grasps(&offsets, arguments) })
    };
    magnitudes.iter().map(of_magnitude).collect()
}

fn grid(planned: &[[f64; 3]], divisions: usize) -> Result<Vec<[f64; 3]>, Failure> {
    const LARGEST: f64 = 10_000.0;
    let size = offsets::grid_size(planned.len(), divisions);
    if size > LARGEST {
        let problem = format!("a grid of {size:.0} offsets, more than {LARGEST}; use a smaller N, or --random");
        return Err(Failure::Input(format!("--grid {divisions}: {problem}")));
    }
    Ok(offsets::grid(planned, divisions))
}

fn listed(file: &Path, arguments: &SimulateArguments) -> Result<Injection, Failure> {
    let rows = read_numbers(file, &["x_m", "y_m", "z_m"])?;
    if rows.is_empty() {
        return Err(Failure::Input(format!("{}: no offsets", file.display())));
    }
    let offsets: Vec<[f64; 3]> = rows.iter().map(|row| [row[0], row[1], row[2]]).collect();
    let length = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    Ok(Injection { magnitude: offsets.iter().map(length).fold(0.0, f64::max), grasps: grasps(&offsets, arguments) })
}

/// Every offset with a turn of its own.
fn grasps(offsets: &[[f64; 3]], arguments: &SimulateArguments) -> Vec<Grasp> {
    let turns = offsets::ball(arguments.turn, offsets.len(), arguments.seed);
    Grasp::distinct(offsets.iter().zip(turns).map(|(&offset, turn)| Grasp { offset, turn }))
}

/// Contacts are hard: what overlaps has done so from the beginning.
fn warn_about_overlap(played: &[Played]) {
    /// More than time steps leave (m).
    const OVERLAP: f64 = 1e-4;
    let count = played.iter().filter(|played| played.outcome.max_penetration > OVERLAP).count();
    if count > 0 {
        tell!(
            "warning: in {count} of {} rollouts parts overlap; is the offset so large that the body starts inside the \
             environment?",
            played.len()
        );
    }
}

fn rollouts(played: &[Played]) -> Result<Vec<u8>, Failure> {
    let header = [
        "plan",
        "start",
        "delta_m",
        "motion",
        "friction",
        "magnitude_m",
        "x_m",
        "y_m",
        "z_m",
        "success",
        "position_error_m",
        "orientation_error_rad",
        "max_penetration_m",
        "max_force_n",
        "turn_x_rad",
        "turn_y_rad",
        "turn_z_rad",
    ];
    let rows = played.iter().map(|played| {
        let outcome = &played.outcome;
        let [x, y, z] = played.grasp.offset.map(|component| component.to_string());
        let [turn_x, turn_y, turn_z] = played.grasp.turn.map(|component| component.to_string());
        vec![
            played.plan.folder.display().to_string(),
            played.plan.start.clone(),
            played.plan.delta.to_string(),
            played.motion.to_string(),
            played.friction.to_string(),
            played.magnitude.to_string(),
            x,
            y,
            z,
            u8::from(played.success).to_string(),
            outcome.position_error.to_string(),
            outcome.orientation_error.to_string(),
            outcome.max_penetration.to_string(),
            outcome.max_force.to_string(),
            turn_x,
            turn_y,
            turn_z,
        ]
    });
    table(header.into_iter(), rows)
}

fn in_words(jobs: usize) -> &'static str {
    if jobs == 1 { "thread" } else { "threads" }
}

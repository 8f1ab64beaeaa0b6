//! `simulate`: plays plans under injected grasp errors and counts successes.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use planner::files::{
    RolloutRow, RolloutTables, SimulationRecord, StateRow, StoredPlan, SuccessRow, is_rollout_table, require_folder,
    require_rollout_tables, to_csv, write_file,
};
use planner::{
    Ending, Execution, Motion, PlannerError, Problem, RolloutRemarks, Session, SimulationRequest, SuccessTable,
    simulate_each,
};
use simulation::Reference;

use crate::arguments::SimulateArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::played::problem_of;
use crate::progress::Progress;
use crate::report;
use crate::shell::word;
use crate::values::threads;

/// Plays everything, writes both tables and prints the one of successes.
pub fn run(arguments: &SimulateArguments) -> Result<Exit, CommandError> {
    let mut request = arguments.request()?;
    require_order(arguments)?;
    let plans = StoredPlan::find(&arguments.folder)?;
    let played: Vec<(StoredPlan, Problem)> = plans
        .into_iter()
        .map(|plan| problem_of(arguments.scene.as_deref(), &arguments.tolerance, plan))
        .collect::<Result<_, _>>()?;
    require_one_scene(&played)?;
    if let Some(log) = &arguments.executed {
        return show_execution(&played, &request, log);
    }
    if request.errors.magnitudes.is_empty() {
        request.errors.magnitudes = magnitudes(&played);
    }
    let folder = arguments.out.as_ref().unwrap_or(&arguments.folder);
    require_free(arguments, folder)?;
    if arguments.report {
        report::require_writable(folder)?;
    }

    let progress = Progress::new(&arguments.progress)?;
    let (never, threads) = (AtomicBool::new(false), threads(arguments.jobs));
    let session = Session { threads, ..Session::new(&progress, &never) };
    let begin = Instant::now();
    let limit = played.iter().map(|(_, problem)| problem.task().limits.contact_force).fold(f64::INFINITY, f64::min);
    let (mut tables, mut table, mut remarks) =
        (RolloutTables::begin(folder)?, SuccessTable::default(), RolloutRemarks::default());
    let (mut count, mut trace) = (0, None);
    for (plan, problem) in &played {
        let motions = motions(arguments, plan)?;
        let mut first = None;
        simulate_each(problem, &motions, &request, &session, &mut |rollout| {
            if first.is_none() && rollout.motion == Motion::Plan {
                first = Some((rollout.friction, rollout.grasp));
            }
            count += 1;
            table.add(&rollout);
            remarks.add(&rollout, limit);
            tables.add(&RolloutRow::new(&plan.folder, &plan.result.start, &rollout))
        })?;
        if let (true, None, Some((_, reference))) = (arguments.trace.is_some(), &trace, motions.last()) {
            let course = |(friction, grasp)| course(problem, reference, &request, friction, grasp);
            trace = first.map(course).transpose()?;
        }
    }
    progress.end();
    let seconds = begin.elapsed().as_secs_f64();
    let warnings = [remarks.penetration_warning(), remarks.force_warning(limit)];
    warnings.into_iter().flatten().for_each(|warning| tell!("warning: {warning}"));
    let successes: Vec<SuccessRow> = table.groups().iter().map(SuccessRow::from).collect();
    if let Some((_, problem)) = played.first() {
        let plans = played.iter().map(|(plan, _)| plan.folder.display().to_string()).collect();
        tables.finish(&SimulationRecord::new(problem, plans, &request.errors), &successes)?;
    }
    if let (Some(file), Some(rows)) = (&arguments.trace, trace) {
        write_file(file, &to_csv(rows)?)?;
    }
    if let Some((_, problem)) = played.first() {
        say!(
            "{}: {}; a success ends within {:.2} mm and {} rad of the goal and keeps the forces of [limits]; Wilson's interval \
             of 95 % in brackets; errors, penetration and force are the largest of all rollouts\n\n{table}",
            problem.scene().title,
            request.errors.offsets_in_words(problem),
            1e3 * problem.success().position,
            problem.success().orientation
        );
    }
    let rate = 60.0 * count as f64 / seconds;
    let in_words = if threads == 1 { "thread" } else { "threads" };
    say!("{count} rollouts in {seconds:.1} s, {rate:.0} per minute with {threads} {in_words}");
    say!("written to {}", folder.display());
    if arguments.report {
        report::write_into(folder)?;
    }
    Ok(Exit::Done)
}

/// Refuses plans that are judged by different rules: one table would mix them.
fn require_one_scene(played: &[(StoredPlan, Problem)]) -> Result<(), CommandError> {
    let rules =
        |problem: &Problem| (problem.scene().title.clone(), problem.success(), problem.task().limits.contact_force);
    let Some(((first, problem), others)) = played.split_first() else { return Ok(()) };
    match others.iter().find(|(_, other)| rules(other) != rules(problem)) {
        Some((other, _)) => Err(CommandError::Usage(format!(
            "{} and {} are plans of different scenes, or with different tolerances or limits: name one of them, or a batch of one \
             scene",
            first.folder.display(),
            other.folder.display()
        ))),
        None => Ok(()),
    }
}

/// Refuses a plan before its scene.
fn require_order(arguments: &SimulateArguments) -> Result<(), CommandError> {
    let SimulateArguments { scene, folder, .. } = arguments;
    match scene {
        Some(scene) if scene.is_dir() && folder.is_file() => {
            let (scene, folder) = (word(scene), word(folder));
            Err(CommandError::Usage(format!(
                "{scene} is a folder and {folder} a file; the scene comes first: `assembly-plan simulate {folder} {scene}`"
            )))
        }
        _ => Ok(()),
    }
}

/// Compares the log of a robot with a rollout.
fn show_execution(
    played: &[(StoredPlan, Problem)],
    request: &SimulationRequest,
    log: &Path,
) -> Result<Exit, CommandError> {
    let ([(plan, problem)], [friction]) = (played, request.frictions.as_slice()) else {
        let problem = "--executed compares one plan with one rollout: name the folder of a plan, and one friction";
        return Err(CommandError::Usage(problem.to_owned()));
    };
    let execution = Execution::read(log, problem, plan, &[request.settings(*friction)])?;
    execution.sentences().iter().for_each(|sentence| say!("{sentence}"));
    Ok(if execution.ending == Ending::AtGoal { Exit::Done } else { Exit::NoPlan })
}

/// Delta-hat of every plan.
fn magnitudes(played: &[(StoredPlan, Problem)]) -> Vec<f64> {
    let mut magnitudes: Vec<f64> = played.iter().map(|(_, problem)| problem.offset_magnitude()).collect();
    magnitudes.sort_by(f64::total_cmp);
    magnitudes.dedup();
    magnitudes
}

/// The references to play, that of the plan last.
fn motions(arguments: &SimulateArguments, plan: &StoredPlan) -> Result<Vec<(Motion, Reference)>, PlannerError> {
    let mut motions = Vec::new();
    if arguments.stages {
        motions.extend((1..).map(Motion::HomotopyStep).zip(plan.iteration_references()?));
    }
    motions.push((Motion::Plan, plan.reference()?));
    Ok(motions)
}

/// The course of a rollout: the start and every time step.
fn course(
    problem: &Problem,
    reference: &Reference,
    request: &SimulationRequest,
    friction: f64,
    grasp: task::GraspError,
) -> Result<Vec<StateRow>, PlannerError> {
    let mut rows = vec![StateRow::new(0.0, &grasp.actual(&reference.start()).at_rest())];
    let rollout = problem.rollout(request.settings(friction))?;
    rollout.play(reference, grasp, |state, _| rows.push(StateRow::new(state.time, &state.state())));
    Ok(rows)
}

/// Refuses to write where something else stands, before anything is computed.
fn require_free(arguments: &SimulateArguments, folder: &Path) -> Result<(), PlannerError> {
    require_rollout_tables(folder)?;
    arguments.trace.iter().filter_map(|file| file.parent()).try_for_each(require_folder)?;
    match &arguments.trace {
        Some(file) if file.symlink_metadata().is_ok() => {
            Err(PlannerError::file(file, "exists, and a trace replaces nothing; choose another name for --trace"))
        }
        Some(file) if arguments.progress.log.as_ref() == Some(file) => {
            Err(PlannerError::file(file, "is the file of --log as well; choose another name for --trace"))
        }
        Some(file) if is_rollout_table(file, folder) => {
            Err(PlannerError::file(file, "is a table of this simulation; choose another name for --trace"))
        }
        _ => Ok(()),
    }
}

//! `solve`: plan one motion and write its files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use planner::check::refusal;
use planner::files::{PlanFolder, PlanResult, StoredPlan};
use planner::{Keeper, Outcome, Plan, PlannerError, Problem, RunClock, Session, Stop, warnings};

use crate::arguments::SolveArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::{stop_flag, stop_with_parent};
use crate::progress::Progress;
use crate::report;
use crate::shell::word;
use crate::summary::summary;
use crate::values::threads;

/// What is said where a run begins from the start.
pub const DISCARDED: &str = "unfinished work of an earlier run is discarded; --resume would have continued it";

/// Plans, writes all files and prints a summary. The clock started with the program.
pub fn run(arguments: &SolveArguments, clock: RunClock) -> Result<Exit, CommandError> {
    let clock = clock.limited(arguments.time_limit());
    let (scene, choices) = (arguments.task.scene.clone(), arguments.choices());
    let problem = clock.wait_for(move || Problem::load(&scene, &choices)).ok_or(PlannerError::NoTimeToRead)??;
    require_cell(arguments, &problem)?;
    if let Some(reason) = refusal(&problem) {
        return Err(PlannerError::file(&arguments.task.scene, reason).into());
    }
    let target = arguments.target(problem.scene())?;
    target.validate()?;
    let problem = match &arguments.robust.from {
        Some(folder) => StoredPlan::open(folder)?.tried_first_for(problem)?,
        None => problem,
    };
    warnings::of_problem(&problem).iter().for_each(|warning| tell!("warning: {warning}"));
    let progress = Progress::new(&arguments.progress)?.until(clock.deadline());
    let chosen = problem.chosen();
    if !chosen.is_empty() {
        progress.say(&format!("defaults chosen for this scene: {}", chosen.join(", ")));
    }
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(&problem));
    let folder = PlanFolder::claim(&out, &inputs(arguments))?;
    if arguments.report {
        report::require_writable(&out)?;
    }
    if !arguments.resume && folder.discard()? {
        tell!("{DISCARDED}");
    }
    if arguments.resume && !folder.has_unfinished_work() {
        tell!("{}: there is no unfinished work to resume; the scene is solved from the beginning", out.display());
    }

    let stopped = stop_flag();
    if arguments.cell.is_some() {
        stop_with_parent(Arc::clone(&stopped));
    }
    let threads = threads(arguments.jobs);
    let session = Session { folder: Some(&folder), threads, clock, ..Session::new(&progress, &stopped) };
    let mut plan = match arguments.robust.robust {
        true => planner::solve_robust(&problem, &target, &session)?,
        false => planner::solve(&problem, &session)?,
    };
    if plan.stopped == Some(Stop::User) {
        progress.end();
        tell_interrupted(arguments, &plan);
        return Ok(Exit::Interrupted);
    }
    // The plan is written whatever the result of the test.
    match planner::test(&plan, &target, &session) {
        Ok(tested) => plan.tested = tested,
        Err(error) => tell!("warning: the plan could not be tested: {error}"),
    }
    let was_interrupted = session.is_interrupted();
    progress.end();
    warnings::of_plan(&plan).iter().for_each(|warning| tell!("warning: {warning}"));
    let result: PlanResult = folder.finish(&plan)?;
    say!("{}", summary(&result));
    plan.can_go_on().then(|| say!("{}", going_on(arguments, &out)));
    say!("written to {}", out.display());
    let page = report::page_of(&out);
    if arguments.report {
        report::write_into(&out)?;
    } else if page.exists() {
        tell!("{} shows an older plan; `assembly-plan report {}` rewrites it", page.display(), word(&out));
    } else {
        say!("{}", next(&result, &out));
    }
    let wanted = if arguments.robust.robust { Outcome::Done } else { Outcome::Planned };
    Ok(match (was_interrupted, result.outcome == wanted) {
        (true, _) => Exit::Interrupted,
        (_, true) => Exit::Done,
        (_, false) => Exit::NoPlan,
    })
}

fn tell_interrupted(arguments: &SolveArguments, plan: &Plan) {
    let again = if arguments.resume { "the same command" } else { "the same command with --resume" };
    match &plan.robustness {
        Some(report) => tell!(
            "interrupted while refining, at a success rate of {:.1} %; {again} resumes it",
            100.0 * report.rate_after
        ),
        // Only finished homotopy steps are kept.
        None if plan.iterations.len() <= 1 && plan.attempts.len() <= 1 => {
            tell!("interrupted in homotopy step 1, of which nothing is kept; the same command begins again");
        }
        None => tell!("interrupted in homotopy step {}; {again} resumes it", plan.iterations.len()),
    }
}

/// How another run resumes what the time limit has ended.
fn going_on(arguments: &SolveArguments, out: &Path) -> String {
    let robust = if arguments.robust.robust { " --robust" } else { "" };
    format!(
        "to resume: assembly-plan solve {}{robust} --resume --out {} --time-limit S, with all other flags as they were",
        word(&arguments.task.scene),
        word(out)
    )
}

/// The command that follows.
fn next(result: &PlanResult, out: &Path) -> String {
    let out = word(out);
    match result.done || result.planned {
        true => format!(
            "next: `assembly-plan report {out}` shows it, `assembly-plan export {out} --to csv` writes what a robot reads"
        ),
        false => format!("next: `assembly-plan report {out}` shows it"),
    }
}

/// A cell of a batch is solved only as the manifest has it.
fn require_cell(arguments: &SolveArguments, problem: &Problem) -> Result<(), PlannerError> {
    match &arguments.cell {
        Some(identity) if identity != problem.identity() => Err(PlannerError::file(
            &arguments.task.scene,
            "the scene, a mesh, the homotopy or the version of assembly-plan is not the one of the manifest; expand the \
             batch into another folder",
        )),
        _ => Ok(()),
    }
}

/// Files that the user has named, which the run must not replace.
fn inputs(arguments: &SolveArguments) -> Vec<&Path> {
    std::iter::once(&arguments.task.scene).chain(&arguments.homotopy).map(PathBuf::as_path).collect()
}

/// The folder of a plan for which no other is named.
pub fn default_folder(problem: &Problem) -> PathBuf {
    let is_plain = |letter: char| letter.is_alphanumeric() || "-_".contains(letter);
    let name: String = format!("{}-{}", problem.scene().title, problem.start().name)
        .chars()
        .take(100)
        .map(|letter| if is_plain(letter) { letter } else { '_' })
        .collect();
    Path::new("out").join(name)
}

//! `solve`: plan one motion and write its files.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use planner::check::refusal;
use planner::files::{PlanFolder, PlanResult};
use planner::{PlanStatus, PlannerError, Problem, RobustnessTarget, Session, refine};

use crate::arguments::SolveArguments;
use crate::console::{say, tell};
use crate::exit::{CommandError, Exit};
use crate::interrupt::{stop_flag, stop_with_parent};
use crate::progress::Progress;
use crate::report;
use crate::summary::summary;
use crate::values::threads;

/// Plans, writes all files and says what happened.
pub fn run(arguments: &SolveArguments) -> Result<Exit, CommandError> {
    let problem = Problem::load(&arguments.task.scene, &arguments.choices())?;
    require_cell(arguments, &problem)?;
    if let Some(reason) = refusal(&problem) {
        return Err(PlannerError::file(&arguments.task.scene, reason).into());
    }
    let target = arguments.robust_target(problem.scene());
    target.iter().try_for_each(RobustnessTarget::validate)?;
    problem.warnings().iter().for_each(|warning| tell!("warning: {warning}"));
    let deadline = target.as_ref().and_then(|target| Instant::now().checked_add(target.time_limit));
    let progress = Progress::new(&arguments.progress)?.until(deadline);
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
        tell!("unfinished work of an earlier run is discarded; --resume would have continued it");
    }

    let stopped = stop_flag()?;
    if arguments.cell.is_some() {
        stop_with_parent(Arc::clone(&stopped));
    }
    let threads = threads(arguments.jobs);
    let session = Session { folder: Some(&folder), threads, deadline, ..Session::new(&progress, &stopped) };
    let mut plan = planner::solve(&problem, &session)?;
    if let Some(target) = &target {
        plan = refine(plan, target, &session)?;
    }
    progress.end();
    if plan.interrupted {
        let again = if arguments.resume { "the same command" } else { "the same command with --resume" };
        match &plan.robustness {
            Some(report) => tell!(
                "interrupted while refining, at a success rate of {:.1} %; {again} resumes it",
                100.0 * report.rate_after
            ),
            None => tell!("interrupted in homotopy iteration {}; {again} resumes it", plan.iterations.len()),
        }
        return Ok(Exit::Interrupted);
    }
    plan.own_warnings().iter().for_each(|warning| tell!("warning: {warning}"));
    let result: PlanResult = folder.finish(&plan)?;
    say!("{}\nwritten to {}", summary(&result), out.display());
    let page = report::page_of(&out);
    if arguments.report {
        report::write_into(&out)?;
    } else if page.exists() {
        tell!("{} shows an older plan; `assembly-plan report {}` rewrites it", page.display(), out.display());
    }
    Ok(if plan.status() == PlanStatus::Done { Exit::Done } else { Exit::NoPlan })
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

fn default_folder(problem: &Problem) -> PathBuf {
    let is_plain = |letter: char| letter.is_alphanumeric() || "-_".contains(letter);
    let name: String = format!("{}-{}", problem.scene().title, problem.start().name)
        .chars()
        .take(100)
        .map(|letter| if is_plain(letter) { letter } else { '_' })
        .collect();
    Path::new("out").join(name)
}

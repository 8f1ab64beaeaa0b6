//! `solve`: plan one motion and write its files.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use nlp::{Control, SolveStatus, Start};
use ocp::{Event, HomotopyIteration};
use scene::{Scene, StartPose};
use simulation::Success;

use crate::arguments::SolveArguments;
use crate::checkpoint::Checkpoint;
use crate::console::{say, tell};
use crate::failure::Failure;
use crate::interrupt::{stop_flag, stop_with_parent};
use crate::limits;
use crate::output::{remove_file, write_file, write_trajectory};
use crate::planned::Planned;
use crate::problem::{Problem, homotopy};
use crate::progress::Progress;
use crate::result::PlanResult;
use crate::robust::plan_robustly;
use crate::smoothing;
use crate::stage::Stage;
use crate::{DONE, INTERRUPTED, NO_PLAN};

/// Plans, writes all files and says what happened.
pub fn run(arguments: &SolveArguments) -> Result<u8, Failure> {
    let scene = Scene::load(&arguments.task.scene)?;
    let settings = homotopy(&scene, arguments.homotopy.as_deref(), arguments.linear_solver.as_deref())?;
    let problem = Problem::new(&scene, arguments.task.start.as_deref(), arguments.task.delta, settings)?;
    if arguments.cell.as_ref().is_some_and(|identity| *identity != problem.identity) {
        let message = "the scene, a mesh, the homotopy or the version of assembly-plan is not the one of the manifest; \
                       expand the batch into another folder";
        return Err(Failure::Input(format!("{}: {message}", arguments.task.scene.display())));
    }
    let mut warnings = warnings(&problem);
    warnings.iter().for_each(|warning| tell!("warning: {warning}"));
    let folder = arguments.out.clone().unwrap_or_else(|| default_folder(&scene, problem.start));
    let checkpoint = if arguments.resume { Checkpoint::load(&folder, &problem.identity) } else { None };
    prepare(&folder, checkpoint.is_some())?;
    write_file(&folder.join("resolved.toml"), problem.resolved.as_bytes())?;

    let stopped = stop_flag()?;
    if arguments.cell.is_some() {
        stop_with_parent(Arc::clone(&stopped));
    }
    let success = Success::from(&arguments.tolerance);
    let plan = match arguments.robust.robust {
        true => plan_robustly(&problem, &folder, (&arguments.robust, success), &stopped)?,
        false => plan(&problem, &folder, checkpoint, &stopped)?,
    };
    // A robust plan has stopped its homotopies itself, when time was up.
    let interrupted = stopped.load(Ordering::Relaxed) && (plan.report.is_some() || plan.is_interrupted());
    if interrupted && arguments.resume {
        tell!("interrupted in stage {}; the same command goes on with it", plan.stages.len());
        return Ok(INTERRUPTED);
    }
    write_trajectory(&folder, &plan.trajectory, &plan.task.pairs)?;
    let late = late_warnings(&problem, &plan);
    late.iter().for_each(|warning| tell!("warning: {warning}"));
    warnings.extend(late);
    let result = PlanResult::new(&problem, plan, &success, warnings);
    let json = serde_json::to_vec_pretty(&result).map_err(|error| Failure::Internal(error.to_string()))?;
    write_file(&folder.join("result.json"), &json)?;
    say!("{}\nwritten to {}", result.summary(), folder.display());
    if interrupted {
        return Ok(INTERRUPTED);
    }
    Checkpoint::remove(&folder)?;
    Ok(if result.is_done() { DONE } else { NO_PLAN })
}

/// What is odd about a problem before it is solved.
fn warnings(problem: &Problem) -> Vec<String> {
    let mut warnings = problem.scene.warnings.clone();
    if problem.homotopy.linear_solver == task::LinearSolver::Stage && !nlp::TAKES_OWN_SOLVER {
        let version = nlp::IPOPT_VERSION;
        warnings.push(format!("Ipopt {version} cannot run linear_solver = \"stage\"; MUMPS is used, which is slower"));
    }
    warnings
}

/// What is wrong with a plan. A robust one leans on nothing: its scenarios are rollouts with hard contact.
fn late_warnings(problem: &Problem, plan: &Planned) -> Vec<String> {
    let mut warnings = limits::warnings(&problem.task.limits, &plan.trajectory.keeps());
    if plan.report.is_none() && plan.last.status.is_success() {
        warnings.extend(smoothing::warning(problem, &plan.stages, &plan.last));
    }
    warnings
}

/// Runs the homotopy, from the checkpoint where there is one, and writes what each iteration finds; the last one is the
/// plan.
fn plan(
    problem: &Problem,
    folder: &Path,
    checkpoint: Option<Checkpoint>,
    stopped: &AtomicBool,
) -> Result<Planned, Failure> {
    let planned = problem.homotopy.iterations;
    let progress = Progress::new();
    let observe = |event: Event| {
        progress.iteration(&event);
        if stopped.load(Ordering::Relaxed) { Control::Stop } else { Control::Continue }
    };
    let mut stages = checkpoint.as_ref().map_or_else(Vec::new, |checkpoint| checkpoint.stages.clone());
    let mut written = Ok(());
    let finished = |number: usize, stage: &HomotopyIteration| {
        progress.stage(number, planned, stage);
        stages.push(Stage::from(stage));
        if written.is_ok() {
            written = write_stage(problem, folder, &stages, stage);
        }
    };
    let mut homotopy = ocp::Homotopy::new(&problem.task, problem.homotopy.clone());
    let mut results = match checkpoint {
        None => homotopy.run(observe, finished)?,
        Some(checkpoint) => {
            let done = checkpoint.stages.len();
            tell!("going on after stage {done}/{planned} of an earlier run");
            homotopy.run_from(done, Start::Warm(checkpoint.iterate()), observe, finished)?
        }
    };
    written?;
    let last = results.pop().ok_or_else(|| Failure::Internal("no homotopy iteration was left to run".to_owned()))?;
    let (trajectory, task) = (last.trajectory.clone(), problem.task.clone());
    Ok(Planned { stages, last, trajectory, task, report: None })
}

/// Writes the tables of a stage, then the checkpoint from which the next one can start.
fn write_stage(problem: &Problem, folder: &Path, stages: &[Stage], last: &HomotopyIteration) -> Result<(), Failure> {
    let stage_folder = folder.join("stages").join(stages.len().to_string());
    write_trajectory(&stage_folder, &last.trajectory, &problem.task.pairs)?;
    let is_final = stages.len() == problem.homotopy.iterations;
    if is_final || last.status == SolveStatus::Interrupted {
        return Ok(());
    }
    Checkpoint::new(&problem.identity, stages, last).save(folder)
}

fn default_folder(scene: &Scene, start: &StartPose) -> PathBuf {
    let name: String = format!("{}-{}", scene.title, start.name)
        .chars()
        .map(|letter| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '_' })
        .collect();
    Path::new("out").join(name)
}

/// Removes an older plan's mark of being whole before anything of it is replaced and, unless its finished stages are
/// kept, these and its checkpoint.
fn prepare(folder: &Path, keeps_stages: bool) -> Result<(), Failure> {
    remove_file(&folder.join("result.json"))?;
    if !keeps_stages {
        Checkpoint::remove(folder)?;
        let stages = folder.join("stages");
        match fs::remove_dir_all(&stages) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(Failure::io(&stages, &error)),
            _ => {}
        }
    }
    fs::create_dir_all(folder).map_err(|error| Failure::io(folder, &error))
}

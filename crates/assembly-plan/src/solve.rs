//! `solve`: plan one motion and write its files.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use nlp::{Control, SolveStatus};
use ocp::{Event, StageResult};
use scene::{Homotopy, Scene, StartPose, resolved};

use crate::arguments::SolveArguments;
use crate::failure::Failure;
use crate::output::{write_file, write_trajectory};
use crate::progress::Progress;
use crate::result::PlanResult;
use crate::{DONE, INTERRUPTED, NO_PLAN};

/// Plans, writes all files and says what happened.
pub fn run(arguments: &SolveArguments) -> Result<u8, Failure> {
    let scene = Scene::load(&arguments.task.scene)?;
    let start = scene.start(arguments.task.start.as_deref()).map_err(Failure::Input)?;
    let delta = arguments.task.delta.unwrap_or(scene.offset_magnitude);
    let task = scene.task(Some(&start.name), Some(delta)).map_err(Failure::Input)?;
    let homotopy = homotopy(arguments, &scene)?;
    for warning in &scene.warnings {
        eprintln!("warning: {warning}");
    }
    if homotopy.0.linear_solver == ocp::STAGE && !nlp::TAKES_OWN_SOLVER {
        let version = nlp::IPOPT_VERSION;
        eprintln!("warning: Ipopt {version} cannot run linear_solver = \"stage\"; MUMPS is used, which is slower");
    }
    let folder = arguments.out.clone().unwrap_or_else(|| default_folder(&scene, start));
    prepare(&folder)?;
    write_file(&folder.join("resolved.toml"), resolved(&scene, start, delta, &homotopy).as_bytes())?;

    let planned = homotopy.0.iterations;
    let stopped = stop_on_interrupt()?;
    let progress = Progress::new();
    let observe = |event: Event| {
        progress.iteration(&event);
        if stopped.load(Ordering::Relaxed) { Control::Stop } else { Control::Continue }
    };
    let mut written = Ok(());
    let finished = |number: usize, stage: &StageResult| {
        progress.stage(number, planned, stage);
        let stage_folder = folder.join("stages").join(number.to_string());
        if written.is_ok() {
            written = write_trajectory(&stage_folder, &stage.trajectory, &task.pairs);
        }
    };
    let stages = ocp::Homotopy::new(&task, homotopy.0).run(observe, finished)?;
    written?;
    let last = &stages[stages.len() - 1];
    write_trajectory(&folder, &last.trajectory, &task.pairs)?;
    let result = PlanResult::new(&scene, start, delta, planned, &stages);
    let json = serde_json::to_vec_pretty(&result).map_err(|error| Failure::Internal(error.to_string()))?;
    write_file(&folder.join("result.json"), &json)?;
    println!("{}\nwritten to {}", result.summary(), folder.display());
    Ok(match last.status {
        SolveStatus::Interrupted => INTERRUPTED,
        _ if result.is_done() => DONE,
        _ => NO_PLAN,
    })
}

fn homotopy(arguments: &SolveArguments, scene: &Scene) -> Result<Homotopy, Failure> {
    let mut homotopy = match &arguments.homotopy {
        Some(file) => Homotopy::load(file)?,
        None => scene.homotopy.clone().unwrap_or_default(),
    };
    if let Some(name) = &arguments.linear_solver {
        homotopy.0.linear_solver.clone_from(name);
    }
    Ok(homotopy)
}

fn default_folder(scene: &Scene, start: &StartPose) -> PathBuf {
    let name: String = format!("{}-{}", scene.title, start.name)
        .chars()
        .map(|letter| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '_' })
        .collect();
    Path::new("out").join(name)
}

/// Removes an older plan's mark of being whole before anything of it is replaced, and its stages.
fn prepare(folder: &Path) -> Result<(), Failure> {
    let missing_is_fine = |path: &Path, outcome: std::io::Result<()>| match outcome {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::io(path, &error)),
        _ => Ok(()),
    };
    let result = folder.join("result.json");
    missing_is_fine(&result, fs::remove_file(&result))?;
    let stages = folder.join("stages");
    missing_is_fine(&stages, fs::remove_dir_all(&stages))?;
    fs::create_dir_all(folder).map_err(|error| Failure::io(folder, &error))
}

/// A flag that Ctrl-C sets: the solve then ends with its last iterate.
fn stop_on_interrupt() -> Result<Arc<AtomicBool>, Failure> {
    let stopped = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stopped);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed))
        .map_err(|error| Failure::Internal(format!("interrupts cannot be handled: {error}")))?;
    Ok(stopped)
}

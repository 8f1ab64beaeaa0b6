//! `solve`: plan one motion and write its files.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use nlp::Control;
use ocp::{AssemblyTask, ContactPair, Event, HomotopySettings, StageResult, Trajectory};
use scene::{Homotopy, Scene, StartPose, resolved};
use simulation::{Examiner, Rollout, Settings, Success};

use crate::arguments::{RobustArguments, SolveArguments};
use crate::failure::Failure;
use crate::output::{write_file, write_trajectory};
use crate::progress::Progress;
use crate::result::PlanResult;
use crate::robust::{Report, Robust, RobustPlan, Wishes};
use crate::simulate::processors;
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

    let job =
        Job { scene: &scene, task: &task, delta, settings: homotopy.0, folder: &folder, progress: Progress::new() };
    let stopped = stop_on_interrupt()?;
    let Planned { stages, trajectory, pairs, report } =
        if arguments.robust.robust { job.robust(&arguments.robust, &stopped)? } else { job.plain(&stopped)? };
    write_trajectory(&folder, &trajectory, &pairs)?;
    let result = PlanResult::new(&scene, start, delta, job.settings.iterations, &stages, &trajectory, report);
    let json = serde_json::to_vec_pretty(&result).map_err(|error| Failure::Internal(error.to_string()))?;
    write_file(&folder.join("result.json"), &json)?;
    println!("{}\nwritten to {}", result.summary(), folder.display());
    Ok(if stopped.load(Ordering::Relaxed) {
        INTERRUPTED
    } else if result.is_done() {
        DONE
    } else {
        NO_PLAN
    })
}

/// One motion to be planned.
struct Job<'run> {
    scene: &'run Scene,
    task: &'run AssemblyTask,
    delta: f64,
    settings: HomotopySettings,
    folder: &'run Path,
    progress: Progress,
}

/// A plan.
struct Planned {
    stages: Vec<StageResult>,
    trajectory: Trajectory,
    /// Pairs whose contacts the trajectory knows.
    pairs: Vec<ContactPair>,
    report: Option<Report>,
}

impl Job<'_> {
    /// The last homotopy iteration is the plan.
    fn plain(&self, stopped: &AtomicBool) -> Result<Planned, Failure> {
        let mut written = Ok(());
        let stages = self.homotopy(self.task, &|| stopped.load(Ordering::Relaxed), |number, stage| {
            if written.is_ok() {
                written = self.write_stage(number, stage);
            }
        })?;
        written?;
        let trajectory = stages[stages.len() - 1].trajectory.clone();
        Ok(Planned { stages, trajectory, pairs: self.task.pairs.clone(), report: None })
    }

    /// The plan is refined by rollouts, and its scenarios are rollouts without friction.
    fn robust(&self, arguments: &RobustArguments, stopped: &AtomicBool) -> Result<Planned, Failure> {
        let mut world = self.task.clone();
        // Reality does not know which pairs the plan leaves out.
        world.pairs = self.scene.all_pairs();
        let wishes = Wishes {
            rate: arguments.wanted_rate,
            time_limit: Duration::try_from_secs_f64(arguments.time_limit).unwrap_or(Duration::MAX),
            frictions: arguments.friction.clone(),
            jobs: arguments.jobs.map_or_else(processors, usize::from),
        };
        let examiner = Examiner::new(&world, &wishes.frictions, Success::default());
        let robust = Robust::new(self.task, &examiner, self.delta, wishes, &self.progress, stopped);
        let RobustPlan { stages, reference, report } = robust
            .run(|task, is_over| self.homotopy(task, &|| stopped.load(Ordering::Relaxed) || is_over(), |_, _| {}))?;
        for (index, stage) in stages.iter().enumerate() {
            self.write_stage(index + 1, stage)?;
        }
        let tau = stages[stages.len() - 1].smoothing.tau;
        let rollout = Rollout::new(&world, Settings::default());
        let trajectory = rollout.trajectory(&reference, &self.task.offsets, tau);
        Ok(Planned { stages, trajectory, pairs: world.pairs, report: Some(report) })
    }

    fn homotopy(
        &self,
        task: &AssemblyTask,
        stop: &dyn Fn() -> bool,
        mut finished: impl FnMut(usize, &StageResult),
    ) -> Result<Vec<StageResult>, Failure> {
        let observe = |event: Event| {
            self.progress.iteration(&event);
            if stop() { Control::Stop } else { Control::Continue }
        };
        let finished = |number: usize, stage: &StageResult| {
            self.progress.stage(number, self.settings.iterations, stage);
            finished(number, stage);
        };
        Ok(ocp::Homotopy::new(task, self.settings.clone()).run(observe, finished)?)
    }

    fn write_stage(&self, number: usize, stage: &StageResult) -> Result<(), Failure> {
        let folder = self.folder.join("stages").join(number.to_string());
        write_trajectory(&folder, &stage.trajectory, &self.task.pairs)
    }
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

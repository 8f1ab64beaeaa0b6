//! A robust plan of one problem.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use nlp::{Control, Start};
use ocp::{Event, HomotopyIteration};
use simulation::{Evaluator, Rollout, Settings, Success};

use crate::arguments::{RobustArguments, threads};
use crate::failure::Failure;
use crate::output::write_trajectory;
use crate::planned::Planned;
use crate::problem::Problem;
use crate::progress::Progress;
use crate::robust::portfolio::Variant;
use crate::robust::{Robust, RobustPlan, Wishes};
use crate::stage::Stage;

/// The plan is refined by rollouts, and its scenarios are rollouts without friction.
pub fn plan_robustly(
    problem: &Problem,
    folder: &Path,
    (arguments, success): (&RobustArguments, Success),
    stopped: &AtomicBool,
) -> Result<Planned, Failure> {
    let mut world = problem.task.clone();
    // Reality does not know which pairs the plan leaves out.
    world.pairs = problem.scene.all_pairs();
    let wishes = Wishes {
        rate: arguments.wanted_rate,
        time_limit: Duration::try_from_secs_f64(arguments.time_limit).unwrap_or(Duration::MAX),
        patience: arguments.patience as usize,
        turn: arguments.turn,
        frictions: arguments.friction.clone(),
        jobs: threads(arguments.jobs),
    };
    let examiner = Evaluator::new(&world, &wishes.frictions, success);
    let progress = Progress::new();
    let settings = &problem.homotopy;
    let robust = Robust::new((&problem.task, settings), &examiner, problem.delta, wishes, &progress, stopped);
    let homotopy = |variant: &Variant, shown: bool, is_over: &dyn Fn() -> bool| {
        let observe = |event: Event| {
            if shown {
                progress.iteration(&event);
            }
            if stopped.load(Ordering::Relaxed) || is_over() { Control::Stop } else { Control::Continue }
        };
        let finished = |number: usize, stage: &HomotopyIteration| {
            if shown {
                progress.stage(number, variant.settings.iterations, stage);
            }
        };
        let mut homotopy = ocp::Homotopy::new(&variant.task, variant.settings.clone());
        let transcription = homotopy.transcription();
        let start = match &variant.near {
            None => transcription.initial_guess(),
            Some(motion) => transcription.point_at(motion),
        };
        Ok(homotopy.run_from(0, Start::Cold(start), observe, finished)?)
    };
    let RobustPlan { mut stages, reference, report } = robust.run(&homotopy)?;
    for (index, stage) in stages.iter().enumerate() {
        let stage_folder = folder.join("stages").join((index + 1).to_string());
        write_trajectory(&stage_folder, &stage.trajectory, &problem.task.pairs)?;
    }
    let records = stages.iter().map(Stage::from).collect();
    let last = stages.pop().ok_or_else(|| Failure::Internal("no homotopy iteration ran".to_owned()))?;
    let rollout = Rollout::new(&world, Settings::default());
    let trajectory = rollout.trajectory(&reference, &problem.task.offsets, last.smoothing.tau);
    Ok(Planned { stages: records, last, trajectory, task: world, report: Some(report) })
}

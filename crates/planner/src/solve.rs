//! One plan of a problem: the homotopy, from where an earlier run has left it.

use std::collections::BTreeMap;

use nlp::{Control, SolveStatus, Start};
use ocp::{Event as SolverEvent, Homotopy, HomotopyIteration, IterationEnd};

use crate::error::{PlannerError, Unusable};
use crate::files::{Checkpoint, PlanFolder};
use crate::iteration::{IterationRecord, PlanIteration};
use crate::plan::Plan;
use crate::problem::Problem;
use crate::refine::require_threads;
use crate::session::{Event, Session};
use crate::variant::Variant;

/// Plans a problem. With a folder in the session, finished homotopy iterations are kept there, and those of an earlier
/// run of the same problem are not solved again.
///
/// # Errors
/// When a linear solver or a file fails, or the session's deadline passes before there is a plan. A solve that does not
/// converge is a plan whose status says so.
pub fn solve(problem: &Problem, session: &Session) -> Result<Plan, PlannerError> {
    let variant = Variant::of_scene(problem);
    let earlier = earlier_work(problem, &variant, session)?;
    let most = variant.settings.most_iterations();
    let (mut iterations, start, mut finished) = match earlier {
        Some(Earlier { iterations, checkpoint }) => {
            session.tell(Event::Resumed { done: iterations.len(), most, refining: false });
            let start = Some(Start::Warm(checkpoint.iterate()));
            (iterations, start, Finished { records: checkpoint.iterations, tables: checkpoint.tables })
        }
        None => (Vec::new(), None, Finished::default()),
    };
    let mut kept = Ok(());
    let on_finished = |number: usize, iteration: &HomotopyIteration| {
        let record = IterationRecord::from(iteration);
        announce(session, number, most, &record, iteration);
        finished.records.push(record);
        if let (Some(folder), Ok(()), false) = (session.folder, &kept, is_interrupted(iteration)) {
            kept = finished.keep(folder, problem, &variant, iteration);
        }
    };
    let observe = |event: &SolverEvent| {
        session.tell(Event::Iteration(*event));
        if session.is_interrupted() || session.is_over() { Control::Stop } else { Control::Continue }
    };
    require_threads(session.threads)?;
    let mut new = run_homotopy(&variant, session.threads, &iterations, start, observe, on_finished)?;
    kept?;
    let is_cut = new.last().is_some_and(is_interrupted);
    let interrupted = is_cut && session.is_interrupted();
    if is_cut && !interrupted {
        new.pop();
    }
    iterations.extend(new.into_iter().map(PlanIteration::from));
    let is_coarse = |iteration: &PlanIteration| iteration.record.is_coarse(&variant.task);
    if !interrupted && iterations.iter().all(is_coarse) {
        return Err(PlannerError::OutOfTime);
    }
    Ok(Plan::new(problem, variant, iterations, session.threads, interrupted))
}

/// Runs the homotopy of a variant on some threads after its `earlier` iterations, from a given start or the variant's
/// own.
pub(crate) fn run_homotopy(
    variant: &Variant,
    threads: usize,
    earlier: &[PlanIteration],
    start: Option<Start>,
    mut observe: impl FnMut(&SolverEvent) -> Control,
    finished: impl FnMut(usize, &HomotopyIteration),
) -> Result<Vec<HomotopyIteration>, PlannerError> {
    let mut homotopy = Homotopy::new(&variant.task, variant.settings.clone()).with_threads(threads);
    let transcription = homotopy.transcription(earlier.len() + 1);
    let start = start.unwrap_or_else(|| {
        Start::Cold(match &variant.near {
            None => transcription.initial_guess(),
            Some(motion) => transcription.point_at(motion),
        })
    });
    let ends: Vec<IterationEnd> = earlier.iter().map(PlanIteration::end).collect();
    Ok(homotopy.run_from(&ends, start, |event| observe(&event), finished)?)
}

/// Finished homotopy iterations of another run.
struct Earlier {
    iterations: Vec<PlanIteration>,
    checkpoint: Checkpoint,
}

fn earlier_work(problem: &Problem, variant: &Variant, session: &Session) -> Result<Option<Earlier>, PlannerError> {
    let Some(folder) = session.folder else { return Ok(None) };
    let checkpoint = match folder.checkpoint(problem.identity()) {
        Ok(Some(checkpoint)) => checkpoint,
        Ok(None) => return Ok(None),
        Err(reason) => {
            session.tell(Event::Discarded { reason });
            folder.discard()?;
            return Ok(None);
        }
    };
    let read = |(number, record): (usize, &IterationRecord)| {
        let trajectory = folder.read_iteration(number, &record.task(&variant.task))?;
        Ok::<_, PlannerError>(PlanIteration { record: record.clone(), trajectory })
    };
    match (1..).zip(&checkpoint.iterations).map(read).collect() {
        Ok(iterations) => Ok(Some(Earlier { iterations, checkpoint })),
        Err(_) => {
            session.tell(Event::Discarded { reason: Unusable::DamagedTables });
            folder.discard()?;
            Ok(None)
        }
    }
}

/// What is known of the finished homotopy iterations.
#[derive(Default)]
struct Finished {
    records: Vec<IterationRecord>,
    /// Hashes of their tables, by their paths in the folder.
    tables: BTreeMap<String, String>,
}

impl Finished {
    /// Keeps the tables of the last iteration, then the checkpoint from which the next one can start.
    fn keep(
        &mut self,
        folder: &PlanFolder,
        problem: &Problem,
        variant: &Variant,
        last: &HomotopyIteration,
    ) -> Result<(), PlannerError> {
        self.tables.extend(folder.keep_iteration(self.records.len(), &last.trajectory, &variant.task)?);
        let mut checkpoint = Checkpoint::new(problem.identity(), self.records.clone(), &last.iterate);
        checkpoint.tables.clone_from(&self.tables);
        folder.keep_checkpoint(&checkpoint)
    }
}

fn announce(session: &Session, number: usize, most: usize, record: &IterationRecord, iteration: &HomotopyIteration) {
    let (position_error, _) = iteration.trajectory.worst_errors();
    session.tell(Event::HomotopyIteration { number, most, record, position_error });
}

fn is_interrupted(iteration: &HomotopyIteration) -> bool {
    iteration.status == SolveStatus::Interrupted
}

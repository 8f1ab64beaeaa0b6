//! One plan of a problem: the homotopy, from where an earlier run has left it.

use nlp::{Control, SolveStatus, Start};
use ocp::{Event as SolverEvent, Homotopy, HomotopyIteration};

use crate::error::{PlannerError, Unusable};
use crate::files::{Checkpoint, PlanFolder};
use crate::iteration::IterationRecord;
use crate::iteration::PlanIteration;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::session::{Event, Session};
use crate::variant::Variant;

/// Plans a problem. With a folder in the session, finished homotopy iterations are kept there, and those of an earlier
/// run of the same problem are not solved again.
///
/// # Errors
/// When a linear solver or a file fails; a solve that does not converge is a plan whose status says so.
pub fn solve(problem: &Problem, session: &Session) -> Result<Plan, PlannerError> {
    let variant = Variant::of_scene(problem);
    let earlier = earlier_work(problem, &variant, session)?;
    let count = variant.settings.iterations;
    let (mut iterations, start) = match earlier {
        Some(Earlier { iterations, checkpoint }) => {
            session.tell(Event::Resumed { done: iterations.len(), count, refining: false });
            (iterations, Some(Start::Warm(checkpoint.iterate())))
        }
        None => (Vec::new(), None),
    };
    let mut kept = Ok(());
    let mut records: Vec<IterationRecord> = iterations.iter().map(|iteration| iteration.record.clone()).collect();
    let finished = |number: usize, iteration: &HomotopyIteration| {
        records.push(IterationRecord::from(iteration));
        announce(session, number, count, iteration);
        if let (Some(folder), Ok(()), false) = (session.folder, &kept, is_interrupted(iteration)) {
            kept = keep(folder, problem, &variant, &records, iteration);
        }
    };
    let observe = |event: &SolverEvent| {
        session.tell(Event::Iteration(*event));
        if session.is_interrupted() { Control::Stop } else { Control::Continue }
    };
    let new = run_homotopy(&variant, iterations.len(), start, observe, finished)?;
    kept?;
    let interrupted = new.last().is_some_and(is_interrupted);
    iterations.extend(new.into_iter().map(PlanIteration::from));
    Ok(Plan::new(problem, variant, iterations, interrupted))
}

/// Runs the homotopy of a variant after its first `done` iterations, from a given start or the variant's own.
pub(crate) fn run_homotopy(
    variant: &Variant,
    done: usize,
    start: Option<Start>,
    mut observe: impl FnMut(&SolverEvent) -> Control,
    finished: impl FnMut(usize, &HomotopyIteration),
) -> Result<Vec<HomotopyIteration>, PlannerError> {
    let mut homotopy = Homotopy::new(&variant.task, variant.settings.clone());
    let transcription = homotopy.transcription();
    let start = start.unwrap_or_else(|| {
        Start::Cold(match &variant.near {
            None => transcription.initial_guess(),
            Some(motion) => transcription.point_at(motion),
        })
    });
    Ok(homotopy.run_from(done, start, |event| observe(&event), finished)?)
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
        let trajectory = folder.read_iteration(number, &variant.task)?;
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

fn keep(
    folder: &PlanFolder,
    problem: &Problem,
    variant: &Variant,
    records: &[IterationRecord],
    last: &HomotopyIteration,
) -> Result<(), PlannerError> {
    let checkpoint = Checkpoint::new(problem.identity(), records.to_vec(), &last.iterate);
    folder.keep_iteration(&last.trajectory, &variant.task, checkpoint)
}

fn announce(session: &Session, number: usize, count: usize, iteration: &HomotopyIteration) {
    let (position_error, _) = iteration.trajectory.worst_errors();
    let record = &IterationRecord::from(iteration);
    session.tell(Event::HomotopyIteration { number, count, record, position_error });
}

fn is_interrupted(iteration: &HomotopyIteration) -> bool {
    iteration.status == SolveStatus::Interrupted
}

//! One plan of a problem: the homotopy, from where an earlier run has left it.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use nlp::{Control, Iterate, Start};
use ocp::Event as SolverEvent;

use crate::attempt::{self, Change, is_better, leads_away};
use crate::checkpoint::Checkpoint;
use crate::error::{PlannerError, Unusable};
use crate::homotopy_run::{Ended, HomotopyRun, Solved};
use crate::iteration::{IterationRecord, PlanIteration};
use crate::keeper::Keeper;
use crate::plan::{Plan, PlanStatus, Stop};
use crate::problem::Problem;
use crate::ranges::require_threads;
use crate::records::AttemptRecord;
use crate::session::{Event, Session};
use crate::variant::Variant;

/// Plans a problem. Where the built-in homotopy misses the goal, others are tried, and the best plan is kept. With a
/// folder in the session, finished homotopy steps are stored there, and those of an earlier run of the same problem are
/// not solved again.
///
/// # Errors
/// When a linear solver or a file fails, or the session's time ends before the first homotopy step. A solve
/// that does not converge, or has no time to, returns a plan with that status.
pub fn solve(problem: &Problem, session: &Session) -> Result<Plan, PlannerError> {
    solve_until(problem, session, &EarlyEnd::NEVER)
}

/// The end of a homotopy before its last step, for plans that rollouts decide about.
pub struct EarlyEnd<'run> {
    /// Whether no homotopy step of a variant has to follow after one.
    pub is_enough: &'run dyn Fn(&Variant, &PlanIteration) -> bool,
    /// When it ends in any case, as time since the run began.
    pub until: Duration,
    /// Whether its first step is finished even then.
    pub needs_step: bool,
}

impl EarlyEnd<'_> {
    /// All homotopy steps are solved.
    const NEVER: Self = EarlyEnd { is_enough: &|_, _| false, until: Duration::MAX, needs_step: true };

    /// Whether its time is over.
    fn is_late(&self, session: &Session) -> bool {
        session.clock.elapsed() >= self.until
    }
}

/// As [`solve`], but the homotopy may end early; the plan then says that it was [`Stop::Enough`], or [`Stop::Unsolved`].
///
/// # Errors
/// As [`solve`].
pub fn solve_until(problem: &Problem, session: &Session, early: &EarlyEnd) -> Result<Plan, PlannerError> {
    require_threads(session.threads)?;
    let changes = Change::all(problem);
    let mut earlier = earlier_work(problem, changes, session)?;
    // Attempts before the interrupted one were no plans: they come last. Whether an attempt gives up is the same in any order.
    let first = earlier.as_ref().map_or(0, |earlier| earlier.attempt);
    let order = (first..changes.len()).chain(0..first);
    let mut best: Option<Plan> = None;
    let mut attempts: BTreeMap<usize, AttemptRecord> = BTreeMap::new();
    for index in order {
        let gives_up = index + 1 < changes.len();
        let attempt = Attempt { index, problem: changes[index].of(problem), gives_up };
        if let Some(position_error) = attempts.values().map(|record| record.position_error_m).reduce(f64::min) {
            session.tell(Event::Attempt { planned: changes[index].name(), position_error });
        }
        let Some(plan) = attempt.solve(earlier.take(), session, early)? else { break };
        attempts.insert(index, attempt::record(changes[index], &plan));
        let is_interrupted = plan.stopped == Some(Stop::User);
        let is_over = session.is_over() || early.is_late(session);
        let ends = plan.stopped.is_some() || plan.status() == PlanStatus::Planned || is_over;
        if best.as_ref().is_none_or(|best| is_interrupted || is_better(&plan, best)) {
            best = Some(plan);
        }
        if ends {
            break;
        }
    }
    let best = best.ok_or_else(|| out_of_time(problem))?;
    let stopped = best.stopped.or(session.is_over().then_some(Stop::TimeLimit));
    Ok(Plan { attempts: attempts.into_values().collect(), stopped, ..best })
}

fn out_of_time(problem: &Problem) -> PlannerError {
    let task = problem.task();
    PlannerError::OutOfTime { pairs: task.pairs.len(), scenarios: task.scenarios().len(), steps: task.horizon.steps }
}

/// An attempt at a problem.
struct Attempt {
    /// Among all changes of the problem.
    index: usize,
    problem: Problem,
    /// Whether it ends as soon as it leads away from the goal.
    gives_up: bool,
}

impl Attempt {
    /// `None` where the session's time ends before the first homotopy step.
    fn solve(
        &self,
        earlier: Option<Earlier>,
        session: &Session,
        early: &EarlyEnd,
    ) -> Result<Option<Plan>, PlannerError> {
        let scene = Variant::of_scene(&self.problem);
        let variant = match self.problem.guess() {
            Some(guess) => scene.started_from(guess),
            None => scene,
        };
        let most = variant.settings.most_iterations();
        let (start, mut finished) = match earlier {
            Some(Earlier { start, finished, .. }) => {
                session.tell(Event::Resumed { done: finished.iterations.len(), most, refining: false });
                (Some(Start::Warm(start)), finished)
            }
            None => (None, Finished::default()),
        };
        let is_lost = |iterations: &[PlanIteration]| self.gives_up && leads_away(&self.problem, iterations);
        let is_enough = |iterations: &[PlanIteration]| {
            iterations.last().is_some_and(|last| early.is_late(session) || (early.is_enough)(&variant, last))
        };
        let is_done = is_enough(&finished.iterations);
        let mut stopped = is_done.then_some(Stop::Enough);
        if !is_done && !is_lost(&finished.iterations) {
            let earlier = finished.iterations.clone();
            let run = HomotopyRun { variant: &variant, threads: session.threads, earlier: &earlier, start };
            let may_end = Cell::new(!earlier.is_empty() || !early.needs_step);
            let (ends_early, is_unsolved) = (Cell::new(false), Cell::new(false));
            let observe = |event: &SolverEvent| {
                session.tell(Event::Iteration(*event));
                ends_early.set(may_end.get() && early.is_late(session));
                if session.is_interrupted() || ends_early.get() { Control::Stop } else { Control::Continue }
            };
            let mut kept = Ok(());
            let on_finished = |Solved { number, iteration, is_cut }: Solved| {
                if is_cut && ends_early.get() {
                    // Of a step that was cut, nothing is of use but that there is one.
                    is_unsolved.set(finished.iterations.is_empty());
                    finished.iterations.extend(is_unsolved.get().then_some(iteration));
                    return Control::Stop;
                }
                finished.iterations.push(iteration);
                announce(session, number, most, &finished.iterations[number - 1]);
                if let (Some(folder), Ok(()), false) = (session.folder, &kept, is_cut) {
                    kept = finished.keep(folder, self, &variant);
                }
                may_end.set(true);
                ends_early.set(!is_cut && is_enough(&finished.iterations));
                let ends = ends_early.get() || is_lost(&finished.iterations) || kept.is_err();
                if ends { Control::Stop } else { Control::Continue }
            };
            let ended = run.run(session, observe, on_finished)?;
            kept?;
            stopped = match ended {
                Ended::OutOfTime => Some(Stop::TimeLimit),
                Ended::Cut if !ends_early.get() => Some(Stop::User),
                _ if is_unsolved.get() => Some(Stop::Unsolved),
                Ended::Cut | Ended::ByItself => ends_early.get().then_some(Stop::Enough),
            };
        }
        let is_plan = !finished.iterations.is_empty();
        Ok(is_plan.then(|| Plan::new(&self.problem, variant, finished.iterations, session.threads, stopped)))
    }
}

/// The finished part of an interrupted attempt.
struct Earlier {
    attempt: usize,
    finished: Finished,
    start: Iterate,
}

fn earlier_work(problem: &Problem, changes: &[Change], session: &Session) -> Result<Option<Earlier>, PlannerError> {
    let Some(folder) = session.folder else { return Ok(None) };
    let discard = |reason: Unusable| {
        session.tell(Event::Discarded { reason });
        folder.discard().map(|_| None)
    };
    let checkpoint = match Checkpoint::load(folder, problem.identity()) {
        Ok(Some(checkpoint)) => checkpoint,
        Ok(None) => return Ok(None),
        Err(reason) => return discard(reason),
    };
    let Some(change) = changes.get(checkpoint.attempt) else { return discard(Unusable::DamagedCheckpoint) };
    let (changed, last) = (change.of(problem), checkpoint.iterations.last());
    let (task, settings) = (changed.task().clone(), changed.homotopy());
    if !last.is_some_and(|last| checkpoint.is_point_of(&last.task(&task), settings.complementarity)) {
        return discard(Unusable::DamagedCheckpoint);
    }
    let read = |(number, record): (usize, &IterationRecord)| {
        let trajectory = folder.iteration(number, &record.task(&task))?;
        Ok::<_, PlannerError>(PlanIteration { record: record.clone(), trajectory, point: None })
    };
    let iterations: Result<Vec<PlanIteration>, _> = (1..).zip(&checkpoint.iterations).map(read).collect();
    let Ok(mut iterations) = iterations else { return discard(Unusable::DamagedTables) };
    let start = checkpoint.iterate();
    if let Some(last) = iterations.last_mut() {
        last.point = Some(Arc::new(start.clone()));
    }
    let finished = Finished { iterations, tables: checkpoint.tables };
    Ok(Some(Earlier { attempt: checkpoint.attempt, start, finished }))
}

/// The finished homotopy steps.
#[derive(Default)]
struct Finished {
    iterations: Vec<PlanIteration>,
    /// Hashes of their tables, by their paths in the folder.
    tables: BTreeMap<String, String>,
}

impl Finished {
    /// Stores the tables of the last homotopy step, then the checkpoint from which the next one can start.
    fn keep(&mut self, keeper: &dyn Keeper, attempt: &Attempt, variant: &Variant) -> Result<(), PlannerError> {
        let Some(PlanIteration { trajectory, point: Some(point), .. }) = self.iterations.last() else { return Ok(()) };
        self.tables.extend(keeper.keep_iteration(self.iterations.len(), trajectory, &variant.task)?);
        let records = self.iterations.iter().map(|iteration| iteration.record.clone()).collect();
        let mut checkpoint = Checkpoint::new(attempt.problem.identity(), attempt.index, records, point);
        checkpoint.tables.clone_from(&self.tables);
        checkpoint.save(keeper)
    }
}

fn announce(session: &Session, number: usize, most: usize, iteration: &PlanIteration) {
    let position_error = iteration.trajectory.worst_error().position;
    session.tell(Event::HomotopyStep { number, most, record: &iteration.record, position_error });
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use task::HomotopySettings;

    use super::*;
    use crate::problem::Choices;
    use crate::testing::corner;

    /// The plan of the corner scene whose homotopy ends early.
    fn ended(early: &EarlyEnd) -> Plan {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let interrupted = AtomicBool::new(false);
        solve_until(&problem, &Session::new(&|_: &Event| {}, &interrupted), early).unwrap()
    }

    #[test]
    fn a_homotopy_starts_from_a_guess() {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let settings = HomotopySettings { iterations: 1, coarse_iterations: 0, ..problem.homotopy().clone() };
        let (problem, interrupted) = (problem.with_homotopy(settings), AtomicBool::new(false));
        let solved = |problem: &Problem| solve(problem, &Session::new(&|_: &Event| {}, &interrupted)).unwrap();
        let cold = solved(&problem);
        let guessed = problem.clone().with_guess(cold.reference());
        assert_ne!(guessed.identity(), problem.identity());
        let warm = solved(&guessed);
        let iterations = |plan: &Plan| plan.iterations[0].record.iterations;
        assert!(iterations(&warm) < iterations(&cold), "{} and {}", iterations(&warm), iterations(&cold));
        let [first, second] = [&cold, &warm].map(|plan| plan.iterations[0].record.objective);
        assert!((first - second).abs() < 1e-2 * first.abs(), "{first} and {second}: the same optimum");
    }

    #[test]
    fn a_homotopy_ends_early_when_its_steps_are_enough_or_its_time_is_over() {
        let never = ended(&EarlyEnd::NEVER);
        assert_eq!((never.stopped, never.status()), (None, PlanStatus::Planned));
        let second = ended(&EarlyEnd {
            is_enough: &|_, last| last.record.tau < never.iterations[0].record.tau,
            ..EarlyEnd::NEVER
        });
        assert_eq!((second.iterations.len(), second.stopped, second.attempts.len()), (2, Some(Stop::Enough), 1));
        assert_eq!(second.trajectory.reference, never.iterations[1].trajectory.reference, "the same steps");
        let late = ended(&EarlyEnd { until: Duration::ZERO, ..EarlyEnd::NEVER });
        assert_eq!((late.iterations.len(), late.stopped), (1, Some(Stop::Enough)));
        assert!(!late.can_go_on(), "no time limit has ended it");
        let later = ended(&EarlyEnd { until: Duration::ZERO, needs_step: false, ..EarlyEnd::NEVER });
        assert_eq!((later.iterations.len(), later.stopped), (1, Some(Stop::Unsolved)));
    }
}

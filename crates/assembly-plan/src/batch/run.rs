//! Solves the cells of a batch, some at a time, each in a process of its own.

use std::collections::VecDeque;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use planner::batch::{Cell, Manifest};
use planner::files::PlanResult;

use super::process::{Begun, Ended, Process};
use super::tally::Tally;
use crate::console::tell;
use crate::exit::{CommandError, Exit};
use crate::interrupt::stop_flag;
use crate::progress::ProgressArguments;
use crate::values::threads;

/// Between two looks at the processes; short beside any solve.
const PAUSE: Duration = Duration::from_millis(10);

/// Variables with which job arrays number their tasks.
const INDEX_VARIABLES: [&str; 2] = ["HQ_TASK_ID", "SLURM_ARRAY_TASK_ID"];

/// The cells that `--index` and `--count`, or the task of a job array, stand for.
///
/// # Errors
/// When there are no such cells.
pub fn select(manifest: &Manifest, index: Option<usize>, count: Option<usize>) -> Result<&[Cell], CommandError> {
    let from_flag = index.map(|index| ("--index", index));
    let Some((name, index)) = from_flag.map_or_else(index_of_task, |index| Ok(Some(index)))? else {
        return match count {
            None => Ok(&manifest.cells),
            Some(_) => Err(CommandError::Usage("--count needs --index, the first cell".to_owned())),
        };
    };
    let last = manifest.cells.len().saturating_sub(1);
    let end = index.saturating_add(count.unwrap_or(1)).min(manifest.cells.len());
    manifest.cells.get(index..end).filter(|cells| !cells.is_empty()).ok_or_else(|| {
        CommandError::Usage(format!("{name} {index}: the cells of {} are 0 to {last}", manifest.file().display()))
    })
}

fn index_of_task() -> Result<Option<(&'static str, usize)>, CommandError> {
    let set = INDEX_VARIABLES.into_iter().find_map(|name| std::env::var(name).ok().map(|value| (name, value)));
    let Some((name, value)) = set else { return Ok(None) };
    match value.parse() {
        Ok(index) => Ok(Some((name, index))),
        Err(_) => {
            Err(CommandError::Usage(format!("{name}={value}: must be the number of a cell; unset it or give --index")))
        }
    }
}

/// Solves the cells that are not finished, `jobs` at a time, and names those that failed.
///
/// # Errors
/// When interrupts cannot be handled, or the log file cannot be opened.
pub fn run(
    manifest: &Manifest,
    cells: &[Cell],
    jobs: Option<u16>,
    progress: &ProgressArguments,
) -> Result<Exit, CommandError> {
    let stopped = stop_flag();
    let mut pool = Pool::new(manifest, cells, threads(jobs), Tally::new(cells.len(), progress)?);
    while !pool.is_empty() {
        if stopped.load(Ordering::Relaxed) {
            pool.stop();
        }
        pool.reap();
        pool.fill();
        pool.tally.show(pool.processes.len(), pool.waiting.len());
        thread::sleep(PAUSE);
    }
    pool.report();
    Ok(match (pool.interrupted.is_empty(), pool.failed.is_empty()) {
        (true, true) => Exit::Done,
        (false, _) if pool.stopped => Exit::Interrupted,
        _ => Exit::NoPlan,
    })
}

/// Cells that wait or run.
struct Pool<'manifest> {
    manifest: &'manifest Manifest,
    jobs: usize,
    waiting: VecDeque<&'manifest Cell>,
    processes: Vec<Process>,
    failed: Vec<(&'manifest Cell, String)>,
    interrupted: Vec<&'manifest Cell>,
    stopped: bool,
    tally: Tally,
}

impl<'manifest> Pool<'manifest> {
    fn new(manifest: &'manifest Manifest, cells: &'manifest [Cell], jobs: usize, tally: Tally) -> Self {
        Self {
            manifest,
            jobs,
            waiting: cells.iter().collect(),
            processes: Vec::new(),
            failed: Vec::new(),
            interrupted: Vec::new(),
            stopped: false,
            tally,
        }
    }

    fn is_empty(&self) -> bool {
        self.waiting.is_empty() && self.processes.is_empty()
    }

    /// Begins no more cells and stops those that are being solved.
    fn stop(&mut self) {
        self.stopped = true;
        self.interrupted.extend(self.waiting.drain(..));
        self.processes.iter_mut().for_each(Process::stop);
    }

    /// Takes the processes out that have ended.
    fn reap(&mut self) {
        for mut process in std::mem::take(&mut self.processes) {
            let cell = &self.manifest.cells[process.cell];
            match process.ended() {
                Ok(None) => self.processes.push(process),
                Ok(Some(Ended::Finished(result))) => {
                    self.tally.solved(cell, &result.status);
                    self.finished(cell, &result);
                }
                Ok(Some(Ended::Interrupted)) => self.interrupted.push(cell),
                Ok(Some(Ended::Crashed(reason))) => self.crashed(cell, reason),
                Err(error) => {
                    process.stop();
                    self.crashed(cell, error.to_string());
                }
            }
        }
    }

    /// Starts cells while there is room. Cells that another run solves wait until it has finished or failed.
    fn fill(&mut self) {
        for _ in 0..self.waiting.len() {
            if self.processes.len() == self.jobs {
                return;
            }
            let Some(cell) = self.waiting.pop_front() else { return };
            match Process::begin(self.manifest, cell) {
                Ok(Begun::Process(process)) => self.processes.push(*process),
                Ok(Begun::Finished(result)) => self.finished(cell, &result),
                Ok(Begun::Busy) => self.waiting.push_back(cell),
                Err(error) => self.crashed(cell, error.to_string()),
            }
        }
    }

    fn finished(&mut self, cell: &'manifest Cell, result: &PlanResult) {
        if result.planned {
            self.tally.planned += 1;
        } else {
            self.fail(cell, result.status.clone());
        }
    }

    fn crashed(&mut self, cell: &'manifest Cell, reason: String) {
        self.tally.solved(cell, &reason);
        self.fail(cell, reason);
    }

    fn fail(&mut self, cell: &'manifest Cell, reason: String) {
        self.tally.failed += 1;
        self.failed.push((cell, reason));
    }

    /// Reports the state of all cells.
    fn report(&mut self) {
        self.tally.end();
        self.failed.sort_by_key(|(cell, _)| cell.index);
        for (cell, reason) in &self.failed {
            tell!("failed: {}: {reason} (see {})", cell.label(), self.manifest.folder.join(&cell.folder).display());
        }
        if !self.interrupted.is_empty() {
            tell!("interrupted; {} cells left; the same command resumes", self.interrupted.len());
        }
    }
}

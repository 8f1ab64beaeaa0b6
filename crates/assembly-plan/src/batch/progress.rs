//! What the user sees while a batch runs: one line that is rewritten on a terminal, a line now and then otherwise.

use crate::console::tell;
use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Between two lines off a terminal, and between two looks of the line on one.
const PLAIN: Duration = Duration::from_secs(10);
const REWRITTEN: Duration = Duration::from_millis(200);

/// Progress on standard error.
pub struct Progress {
    /// Cells that reach their goal.
    pub done: usize,
    /// Cells that do not, or have crashed.
    pub failed: usize,
    total: usize,
    solved: usize,
    begun: Instant,
    shown: Option<Instant>,
    rewrites: bool,
}

impl Progress {
    /// Of so many cells.
    pub fn new(total: usize) -> Self {
        let rewrites = stderr().is_terminal();
        Self { done: 0, failed: 0, total, solved: 0, begun: Instant::now(), shown: None, rewrites }
    }

    /// Counts a cell that was solved now and not before.
    pub fn solved(&mut self) {
        self.solved += 1;
    }

    /// Shows where the batch stands, unless it has just done so.
    pub fn show(&mut self, running: usize, waiting: usize) {
        let pause = if self.rewrites { REWRITTEN } else { PLAIN };
        let is_recent = self.shown.is_some_and(|shown| shown.elapsed() < pause);
        if is_recent || running + waiting == 0 {
            return;
        }
        self.shown = Some(Instant::now());
        let Self { done, failed, total, .. } = &self;
        let left =
            self.left(running + waiting).map_or_else(String::new, |left| format!(", about {} left", words(left)));
        let line = format!("{done}/{total} cells done, {running} running, {failed} failed{left}");
        // A terminal that cannot be written to is no reason to stop.
        let _ = if self.rewrites { write!(stderr(), "\r\x1b[K{line}") } else { writeln!(stderr(), "{line}") };
    }

    /// Shows how the batch has ended.
    pub fn end(&self) {
        let clear = if self.rewrites && self.shown.is_some() { "\r\x1b[K" } else { "" };
        let Self { done, failed, total, solved, .. } = self;
        if *solved == 0 && done + failed == *total {
            tell!("{clear}nothing to do: all {total} cells are finished, {done} done, {failed} failed");
        } else {
            let time = words(self.begun.elapsed());
            tell!("{clear}{done}/{total} cells done, {failed} failed; {solved} solves in {time}");
        }
    }

    /// Time until so many more cells are solved, at the pace so far.
    fn left(&self, cells: usize) -> Option<Duration> {
        (self.solved > 0).then(|| self.begun.elapsed().mul_f64(cells as f64 / self.solved as f64))
    }
}

fn words(time: Duration) -> String {
    let seconds = time.as_secs();
    match seconds {
        0..60 => format!("{:.1} s", time.as_secs_f64()),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        _ => format!("{} h {} min", seconds / 3600, seconds % 3600 / 60),
    }
}

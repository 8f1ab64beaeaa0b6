//! How far a batch is, as the user sees it.

use std::time::{Duration, Instant};

use planner::batch::Cell;
use serde_json::json;

use crate::exit::CommandError;
use crate::progress::{Progress, ProgressArguments};

/// Between two lines where there is no bar, and between two looks of the bar.
const PLAIN: Duration = Duration::from_secs(10);
const DRAWN: Duration = Duration::from_millis(200);

/// Counts cells.
pub struct Tally {
    /// Cells whose plans reach their goal.
    pub planned: usize,
    /// Cells that do not, or have crashed.
    pub failed: usize,
    total: usize,
    solved: usize,
    begun: Instant,
    shown: Option<Instant>,
    progress: Progress,
}

impl Tally {
    /// For `total` cells.
    ///
    /// # Errors
    /// When the log file cannot be opened.
    pub fn new(total: usize, arguments: &ProgressArguments) -> Result<Self, CommandError> {
        let progress = Progress::new(arguments)?;
        Ok(Self { planned: 0, failed: 0, total, solved: 0, begun: Instant::now(), shown: None, progress })
    }

    /// Counts a cell that was solved now and not before.
    pub fn solved(&mut self, cell: &Cell, status: &str) {
        self.solved += 1;
        self.progress.record("cell", &json!({ "cell": cell.index, "folder": cell.folder, "status": status }));
    }

    /// Shows where the batch stands, unless it has just done so.
    pub fn show(&mut self, running: usize, waiting: usize) {
        let pause = if self.progress.has_no_bar() { PLAIN } else { DRAWN };
        let is_recent = self.shown.is_some_and(|shown| shown.elapsed() < pause);
        if is_recent || running + waiting == 0 {
            return;
        }
        self.shown = Some(Instant::now());
        let Self { planned, failed, total, .. } = &self;
        let left =
            self.left(running + waiting).map_or_else(String::new, |left| format!(", about {} left", words(left)));
        self.progress.show("cells planned", *planned, *total, &[format!("{running} running, {failed} failed{left}")]);
        if self.progress.has_no_bar() {
            self.progress.say(&format!("{planned}/{total} cells planned, {running} running, {failed} failed{left}"));
        }
    }

    /// Shows how the batch has ended.
    pub fn end(&self) {
        self.progress.end();
        let Self { planned, failed, total, solved, .. } = self;
        let line = if *solved == 0 && planned + failed == *total {
            format!("nothing to do: all {total} cells are finished, {planned} planned, {failed} failed")
        } else {
            let time = words(self.begun.elapsed());
            format!("{planned}/{total} cells planned, {failed} failed; {solved} solves in {time}")
        };
        self.progress.say(&line);
    }

    /// Time until `cells` more cells are solved, at the present pace.
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

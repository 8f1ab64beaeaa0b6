//! What the user sees of long work: on a terminal a bar and a line for each event that stays, elsewhere the lines alone; and
//! a log file of everything, if wanted.

mod log;
mod observer;
mod words;

use std::io::{Write, stderr};
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::exit::CommandError;
use log::Log;

/// How much is said on the way.
#[derive(Debug, Clone, Args)]
pub struct ProgressArguments {
    /// Say nothing on the way but warnings
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Also print every iteration of the solver, in the columns of Ipopt
    #[arg(short, long)]
    pub verbose: bool,
    /// Add everything that happens to this file, one JSON object per line
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,
}

/// The line below everything else: what is being done, how far it is, and for how long.
const TEMPLATE: &str = "{bar:24} {pos}/{len} {msg} ({elapsed} elapsed)";
const TEMPLATE_WITH_END: &str = "{bar:24} {pos}/{len} {msg} ({elapsed} elapsed, {eta} left)";
/// Between two changes of the time that is shown.
const TICK: Duration = Duration::from_millis(500);

/// Progress on standard error and in a log file.
pub struct Progress {
    bar: ProgressBar,
    is_quiet: bool,
    is_verbose: bool,
    log: Option<Log>,
}

impl Progress {
    /// As the command line asks for.
    ///
    /// # Errors
    /// When the log file cannot be opened.
    pub fn new(arguments: &ProgressArguments) -> Result<Self, CommandError> {
        let ProgressArguments { quiet, verbose, log } = arguments;
        // A bar is drawn on terminals only.
        let bar = if *quiet { ProgressBar::hidden() } else { ProgressBar::no_length() };
        let log = log.as_deref().map(Log::open).transpose()?;
        Ok(Self { bar, is_quiet: *quiet, is_verbose: *verbose, log })
    }

    /// Says something that stays.
    pub fn say(&self, line: &str) {
        if !self.is_quiet {
            self.warn(line);
        }
    }

    /// Says something that stays, also to those who want quiet.
    pub fn warn(&self, line: &str) {
        // A terminal that cannot be written to is no reason to stop.
        self.bar.suspend(|| drop(writeln!(stderr(), "{line}")));
    }

    /// Shows what is being done and how far it is, until something else is shown.
    pub fn show(&self, what: String, done: usize, of: usize) {
        self.draw(TEMPLATE, what, done, of);
    }

    /// Likewise, for work whose end can be foretold from what is done.
    pub fn show_with_end(&self, what: String, done: usize, of: usize) {
        self.draw(TEMPLATE_WITH_END, what, done, of);
    }

    fn draw(&self, template: &str, what: String, done: usize, of: usize) {
        if self.bar.is_hidden() {
            return;
        }
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
        self.bar.enable_steady_tick(TICK);
        self.bar.set_length(of as u64);
        self.bar.set_position(done as u64);
        self.bar.set_message(what);
    }

    /// Whether nobody sees the bar: what is worth a line now and then has to be said.
    pub fn has_no_bar(&self) -> bool {
        self.bar.is_hidden()
    }

    /// Adds an event with its fields to the log.
    pub fn record(&self, event: &'static str, fields: &impl Serialize) {
        if let Some(log) = &self.log {
            log.add(event, fields);
        }
    }

    /// Takes the bar away.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }
}

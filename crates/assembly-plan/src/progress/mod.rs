//! Display of long work: on a terminal a bar and a line for each event that stays, elsewhere the lines alone; and a log
//! file of everything, if requested.

mod log;
mod observer;
mod refinement;
mod words;

use std::fmt::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{HumanDuration, ProgressBar, ProgressState, ProgressStyle};
use serde::Serialize;

use crate::console::{keep_below, remove_bar, tell};
use crate::exit::CommandError;
use log::Log;
use refinement::Refinement;

/// Verbosity during the work.
#[derive(Debug, Clone, Args)]
pub struct ProgressArguments {
    /// Print no progress: standard error has only warnings and errors
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Also print every solver iteration, in Ipopt's columns
    #[arg(short, long)]
    pub verbose: bool,
    /// Append all events to this file, one JSON object per line
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,
}

/// Last line of the terminal: the present work, its progress, its time, and its results so far.
const TEMPLATE: &str = "{bar:12} {pos}/{len} {prefix} ({elapsed} elapsed{left}){msg}";
/// Between two changes of the time that is shown.
const TICK: Duration = Duration::from_millis(500);

/// When work ends.
#[derive(Debug, Clone, Copy)]
enum End {
    /// Nobody knows.
    Unknown,
    /// As is foretold by what is done.
    Foretold,
    /// At the latest.
    Deadline(Instant),
}

/// Progress on standard error and in a log file.
pub struct Progress {
    bar: ProgressBar,
    is_quiet: bool,
    is_verbose: bool,
    log: Option<Log>,
    deadline: Option<Instant>,
    refinement: Refinement,
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
        Ok(Self { bar, is_quiet: *quiet, is_verbose: *verbose, log, deadline: None, refinement: Refinement::default() })
    }

    /// With a deadline for everything.
    pub fn until(mut self, deadline: Option<Instant>) -> Self {
        self.deadline = deadline;
        self
    }

    /// Says something that stays, unless the user wants quiet.
    pub fn say(&self, line: &str) {
        if !self.is_quiet {
            tell!("{line}");
        }
    }

    /// Shows what is being done, how far it is and what it has come to, until something else is shown.
    pub fn show(&self, what: &str, done: usize, of: usize, details: &[String]) {
        let end = self.deadline.map_or(End::Unknown, End::Deadline);
        self.draw(what, done, of, details, end);
    }

    /// The same for work whose end can be foretold from what is done.
    pub fn show_with_end(&self, what: &str, done: usize, of: usize) {
        self.draw(what, done, of, &[], End::Foretold);
    }

    fn draw(&self, what: &str, done: usize, of: usize, details: &[String], end: End) {
        if self.bar.is_hidden() {
            return;
        }
        if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
            self.bar.set_style(style.with_key("left", move |state: &ProgressState, text: &mut dyn Write| {
                // Text in memory takes everything.
                let _ = write_left(state, end, text);
            }));
        }
        self.bar.set_length(of as u64);
        self.bar.set_position(done as u64);
        self.bar.set_prefix(what.to_owned());
        self.bar.set_message(details.iter().map(|detail| format!("\n  {detail}")).collect::<String>());
        self.bar.enable_steady_tick(TICK);
        keep_below(&self.bar);
    }

    /// Whether the bar is invisible: then progress needs lines now and then.
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
        remove_bar();
    }
}

/// An error ends the work, too.
impl Drop for Progress {
    fn drop(&mut self) {
        self.end();
    }
}

fn write_left(state: &ProgressState, end: End, text: &mut dyn Write) -> std::fmt::Result {
    match end {
        End::Unknown => Ok(()),
        End::Foretold if state.pos() == 0 => Ok(()),
        End::Foretold => write!(text, ", about {:#} left", HumanDuration(state.eta())),
        End::Deadline(deadline) => {
            let left = deadline.saturating_duration_since(Instant::now());
            write!(text, ", at most {:#} left", HumanDuration(left))
        }
    }
}

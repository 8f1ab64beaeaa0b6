//! Output for the user. It may contain text of files, so characters that a terminal would obey are shown by their
//! number.
//!
//! A reader that stops must not stop the program: lines that cannot be written are dropped, and losses for other
//! reasons are remembered for the exit code.

use std::fmt;
use std::io::{Error, ErrorKind, Write, stderr, stdout};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use indicatif::ProgressBar;
use input::{is_control, shown};
use planner::PlannerError;
use serde::Serialize;

/// The bar at the bottom of the terminal, if there is one.
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);
/// Why the first of the results that are lost could not be written.
static LOST: OnceLock<String> = OnceLock::new();

/// Prints a result on standard output.
macro_rules! say {
    ($($argument:tt)*) => { $crate::console::result(format_args!($($argument)*)) };
}

/// Tells on standard error what happens.
macro_rules! tell {
    ($($argument:tt)*) => { $crate::console::message(format_args!($($argument)*)) };
}

pub(crate) use {say, tell};

/// A line of standard output.
pub fn result(line: fmt::Arguments) {
    above_bar(|| print(&format!("{}\n", shown(&line.to_string()))));
}

/// Text of standard output, as it is.
pub fn print(text: &str) {
    let mut stdout = stdout();
    if let Err(error) = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        lose("standard output", &error);
    }
}

/// Remembers that a result could not be written to a place.
pub fn lose(place: &str, error: &Error) {
    if error.kind() != ErrorKind::BrokenPipe {
        LOST.get_or_init(|| format!("{place}: cannot be written: {error}"));
    }
}

/// Why a result is lost, if one is.
pub fn lost() -> Option<&'static str> {
    LOST.get().map(String::as_str)
}

/// Prints a result as JSON.
///
/// # Errors
/// When it cannot be, which no result of ours causes.
pub fn print_json(value: &impl Serialize) -> Result<(), PlannerError> {
    let json = serde_json::to_string_pretty(value).map_err(|_| PlannerError::Internal("a report"))?;
    // In JSON, what a terminal might obey has escapes of four digits.
    let escaped = |character: char| match is_control(character) && character != '\n' {
        true => format!("\\u{:04x}", u32::from(character)),
        false => character.to_string(),
    };
    above_bar(|| print(&format!("{}\n", json.chars().map(escaped).collect::<String>())));
    Ok(())
}

/// A line of standard error.
pub fn message(line: fmt::Arguments) {
    above_bar(|| drop(writeln!(stderr(), "{}", shown(&line.to_string()))));
}

/// Keeps a bar below all lines until it is removed.
pub fn keep_below(bar: &ProgressBar) {
    *standing() = Some(bar.clone());
}

/// Takes the bar away.
pub fn remove_bar() {
    if let Some(bar) = standing().take() {
        bar.finish_and_clear();
    }
}

fn above_bar(write: impl FnOnce()) {
    match &*standing() {
        Some(bar) => bar.suspend(write),
        None => write(),
    }
}

fn standing() -> MutexGuard<'static, Option<ProgressBar>> {
    BAR.lock().unwrap_or_else(PoisonError::into_inner)
}

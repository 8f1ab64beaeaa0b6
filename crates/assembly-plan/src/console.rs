//! What the user is told. Whoever stops reading must not stop the program: lines that cannot be written are dropped.

use std::fmt;
use std::io::{Write, stderr, stdout};
use std::sync::{Mutex, MutexGuard, PoisonError};

use indicatif::ProgressBar;
use planner::PlannerError;
use serde::Serialize;

/// The bar that stands on the terminal, if there is one.
static BAR: Mutex<Option<ProgressBar>> = Mutex::new(None);

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
    above_bar(|| drop(writeln!(stdout(), "{line}")));
}

/// Prints a result as JSON.
///
/// # Errors
/// When it cannot be, which no result of ours causes.
pub fn print_json(value: &impl Serialize) -> Result<(), PlannerError> {
    let json = serde_json::to_string_pretty(value).map_err(|_| PlannerError::Internal("a report"))?;
    say!("{json}");
    Ok(())
}

/// A line of standard error.
pub fn message(line: fmt::Arguments) {
    above_bar(|| drop(writeln!(stderr(), "{line}")));
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

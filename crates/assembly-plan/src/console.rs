//! What the user is told. Whoever stops reading must not stop the program: lines that cannot be written are dropped.

use std::fmt;
use std::io::{Write, stderr, stdout};

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
    let _ = writeln!(stdout(), "{line}");
}

/// A line of standard error.
pub fn message(line: fmt::Arguments) {
    let _ = writeln!(stderr(), "{line}");
}

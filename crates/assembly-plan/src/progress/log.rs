//! A log of JSON lines.

use std::fmt::Display;
use std::fs::{File, TryLockError};
use std::io::{ErrorKind, Read, Write};
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use input::require_regular;
use serde::Serialize;

use crate::console::lose;
use crate::exit::CommandError;

/// The beginning of every line of a log.
const BEGIN: &str = r#"{"elapsed_s":"#;

/// A file that grows by one line per event.
pub struct Log {
    file: Mutex<File>,
    begin: Instant,
}

#[derive(Serialize)]
struct Line<'fields, F> {
    /// Time since the start of the program.
    elapsed_s: f64,
    event: &'static str,
    #[serde(flatten)]
    fields: &'fields F,
}

impl Log {
    /// Adds to a file, which is made if need be.
    ///
    /// # Errors
    /// When it is no log of an earlier run, another run writes to it, or it cannot be opened.
    pub fn open(path: &Path) -> Result<Self, CommandError> {
        if path.symlink_metadata().is_ok() {
            require_log(path)?;
        }
        let about = |problem: &dyn Display| format!("--log {}: {problem}", path.display());
        let file = input::append(path).map_err(|error| match error.kind() {
            ErrorKind::NotFound => CommandError::Usage(about(&"its folder does not exist")),
            _ => CommandError::System(about(&error)),
        })?;
        match file.try_lock() {
            // Times of two runs would be mixed.
            Err(TryLockError::WouldBlock) => {
                return Err(CommandError::Usage(about(&"another run writes to it; name another file")));
            }
            Err(TryLockError::Error(error)) => return Err(CommandError::System(about(&error))),
            Ok(()) => {}
        }
        Ok(Self { file: Mutex::new(file), begin: Instant::now() })
    }

    /// Adds an event. A log that cannot be written any more does not stop the program; it is reported at the end.
    pub fn add(&self, event: &'static str, fields: &impl Serialize) {
        let elapsed_s = (1e3 * self.begin.elapsed().as_secs_f64()).round() / 1e3;
        let Ok(mut line) = serde_json::to_string(&Line { elapsed_s, event, fields }) else { return };
        line.push('\n');
        if let Ok(mut file) = self.file.lock() {
            file.write_all(line.as_bytes()).unwrap_or_else(|error| lose("--log", &error));
        }
    }
}

/// Refuses to add to what is neither empty nor a log, such as a scene or a file of a plan.
fn require_log(path: &Path) -> Result<(), CommandError> {
    let refuse = |reason: &str| Err(CommandError::Usage(format!("--log {}: {reason}", path.display())));
    if let Err(error) = require_regular(path) {
        return refuse(&error.to_string());
    }
    let mut begin = Vec::new();
    match File::open(path).and_then(|file| file.take(BEGIN.len() as u64).read_to_end(&mut begin)) {
        Err(error) => refuse(&error.to_string()),
        Ok(_) if begin.is_empty() || begin == BEGIN.as_bytes() => Ok(()),
        Ok(_) => refuse("exists and is no log; choose another name"),
    }
}

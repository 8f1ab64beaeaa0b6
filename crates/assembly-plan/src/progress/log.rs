//! A log of JSON lines.

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use input::require_regular;
use serde::Serialize;

use crate::console::lose;
use crate::exit::CommandError;

/// How every line of a log begins.
const BEGIN: &str = r#"{"elapsed_s":"#;

/// A file that grows by one line per event.
pub struct Log {
    file: Mutex<File>,
    begin: Instant,
}

#[derive(Serialize)]
struct Line<'fields, F> {
    /// Since the program has begun.
    elapsed_s: f64,
    event: &'static str,
    #[serde(flatten)]
    fields: &'fields F,
}

impl Log {
    /// Adds to a file, which is made if need be.
    ///
    /// # Errors
    /// When it is no log of an earlier run, or cannot be opened.
    pub fn open(path: &Path) -> Result<Self, CommandError> {
        if path.symlink_metadata().is_ok() {
            require_log(path)?;
        }
        let file = input::append(path);
        let file = file.map_err(|error| CommandError::System(format!("--log {}: {error}", path.display())))?;
        Ok(Self { file: Mutex::new(file), begin: Instant::now() })
    }

    /// Adds an event. A log that cannot be written to any more is no reason to stop, only to say so in the end.
    pub fn add(&self, event: &'static str, fields: &impl Serialize) {
        let elapsed_s = (1e3 * self.begin.elapsed().as_secs_f64()).round() / 1e3;
        let Ok(line) = serde_json::to_string(&Line { elapsed_s, event, fields }) else { return };
        if let Ok(mut file) = self.file.lock() {
            writeln!(file, "{line}").unwrap_or_else(|error| lose("--log", &error));
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

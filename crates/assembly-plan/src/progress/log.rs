//! A log of JSON lines.

use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use serde::Serialize;

use crate::exit::CommandError;

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
    /// When it cannot be opened.
    pub fn open(path: &Path) -> Result<Self, CommandError> {
        let file = File::options().append(true).create(true).open(path);
        let file = file.map_err(|error| CommandError::System(format!("--log {}: {error}", path.display())))?;
        Ok(Self { file: Mutex::new(file), begin: Instant::now() })
    }

    /// Adds an event. A log that cannot be written to any more is no reason to stop.
    pub fn add(&self, event: &'static str, fields: &impl Serialize) {
        let elapsed_s = (1e3 * self.begin.elapsed().as_secs_f64()).round() / 1e3;
        let Ok(line) = serde_json::to_string(&Line { elapsed_s, event, fields }) else { return };
        if let Ok(mut file) = self.file.lock() {
            let _ = writeln!(file, "{line}");
        }
    }
}

//! Why a robot's file is refused.

use std::fmt;
use std::path::{Path, PathBuf};

/// An error in a robot's file: its place, what is wrong and what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RobotError {
    file: PathBuf,
    line: Option<usize>,
    message: String,
}

impl RobotError {
    /// At a line (from 1), or about the whole file.
    pub(crate) fn new(file: &Path, Fault { line, message }: Fault) -> Self {
        Self { file: file.to_owned(), line, message }
    }

    /// Line of the error, from 1, where it has one.
    pub fn line(&self) -> Option<usize> {
        self.line
    }

    /// The message without the place.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for RobotError {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let file = self.file.display();
        match self.line {
            Some(line) => write!(formatter, "{file}:{line}: {}", self.message),
            None => write!(formatter, "{file}: {}", self.message),
        }
    }
}

impl std::error::Error for RobotError {}

/// A fault or unusual property of a file, before its name is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    line: Option<usize>,
    message: String,
}

impl Fault {
    pub fn at(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), message: message.into() }
    }

    pub fn somewhere(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into() }
    }
}

/// The nearest valid name as a question, or the first valid names when none is near.
pub fn suggest(unknown: &str, valid: &[&str]) -> String {
    const NEAR: f64 = 0.6;
    const SHOWN: usize = 20;
    let similarities = valid.iter().map(|name| (strsim::jaro_winkler(unknown, name), name));
    match similarities.max_by(|(one, _), (other, _)| one.total_cmp(other)) {
        Some((similarity, name)) if similarity >= NEAR => format!(", did you mean `{name}`?"),
        _ => {
            let more = if valid.len() > SHOWN { ", ..." } else { "" };
            format!("; there are: {}{more}", valid[..valid.len().min(SHOWN)].join(", "))
        }
    }
}

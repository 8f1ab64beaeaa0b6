//! Errors that point into the file.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::Spanned;

/// What is wrong with a file, where, and what would be right.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneError {
    file: PathBuf,
    message: String,
    place: Option<Place>,
}

/// A place in a file, counted from 1, with the line it stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Place {
    line: usize,
    column: usize,
    width: usize,
    text: String,
}

impl SceneError {
    /// An error about the whole file.
    pub fn about(file: &Path, message: impl Into<String>) -> Self {
        Self { file: file.to_owned(), message: message.into(), place: None }
    }

    /// Line of the error, from 1, where it has one.
    pub fn line(&self) -> Option<usize> {
        self.place.as_ref().map(|place| place.line)
    }

    /// Column of the error, from 1, where it has one.
    pub fn column(&self) -> Option<usize> {
        self.place.as_ref().map(|place| place.column)
    }

    /// What is wrong, without the place.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let file = self.file.display();
        let Some(Place { line, column, width, text }) = &self.place else {
            return write!(formatter, "{file}: {}", self.message);
        };
        let margin = " ".repeat(line.to_string().len());
        writeln!(formatter, "{file}:{line}:{column}: {}", self.message)?;
        writeln!(formatter, "{margin} |")?;
        writeln!(formatter, "{line} | {text}")?;
        write!(formatter, "{margin} | {}{}", " ".repeat(column - 1), "^".repeat((*width).max(1)))
    }
}

impl std::error::Error for SceneError {}

/// A file's name and text, to point into.
#[derive(Debug, Clone, Copy)]
pub struct Source<'text> {
    /// Name of the file.
    pub file: &'text Path,
    /// Its text.
    pub text: &'text str,
}

impl Source<'_> {
    /// An error about a range of bytes.
    pub fn error(&self, span: Range<usize>, message: impl Into<String>) -> SceneError {
        let start = span.start.min(self.text.len());
        let before = &self.text[..start];
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        let text = self.text[line_start..].lines().next().unwrap_or_default();
        let column = before[line_start..].chars().count() + 1;
        let rest = text.chars().count().saturating_sub(column - 1);
        let place = Place {
            line: before.matches('\n').count() + 1,
            column,
            width: span.len().min(rest),
            text: text.to_owned(),
        };
        SceneError { file: self.file.to_owned(), message: message.into(), place: Some(place) }
    }

    /// Index of a value among the known ones.
    ///
    /// # Errors
    /// When it is none of them, with the nearest.
    pub fn require_known(&self, value: &Spanned<String>, known: &[&str]) -> Result<usize, SceneError> {
        let name = value.get_ref();
        known
            .iter()
            .position(|known| known == name)
            .ok_or_else(|| self.error(value.span(), format!("unknown value `{name}`{}", suggest(name, known))))
    }

    /// An error of the TOML parser, with the nearest valid key for one that is unknown.
    pub fn parse_error(&self, error: &toml::de::Error) -> SceneError {
        let message = explain(error.message());
        match error.span() {
            Some(span) => self.error(span, message),
            None => SceneError::about(self.file, message),
        }
    }
}

/// Rewords serde's messages: the nearest key for one that is unknown, kinds of numbers in plain words.
fn explain(message: &str) -> String {
    let message = &message.replace("expected i64", "expected an integer").replace("expected f64", "expected a number");
    let mut names = message.split('`').skip(1).step_by(2);
    let is_unknown = message.starts_with("unknown field") || message.starts_with("unknown variant");
    let Some(unknown) = names.next().filter(|_| is_unknown) else { return message.trim_end().to_owned() };
    let valid: Vec<&str> = names.collect();
    format!("unknown key `{unknown}`{}", suggest(unknown, &valid))
}

/// The nearest valid name, or all of them when none is near.
pub fn suggest(unknown: &str, valid: &[&str]) -> String {
    match nearest(unknown, valid) {
        Some(nearest) => format!(", did you mean `{nearest}`?"),
        None => format!("; valid are: {}", valid.join(", ")),
    }
}

/// The nearest valid name, if one is near.
pub fn nearest<'name>(unknown: &str, valid: &[&'name str]) -> Option<&'name str> {
    const NEAR: f64 = 0.6;
    let similarities = valid.iter().map(|name| (strsim::jaro_winkler(unknown, name), *name));
    let (similarity, name) = similarities.max_by(|(one, _), (other, _)| one.total_cmp(other))?;
    (similarity >= NEAR).then_some(name)
}

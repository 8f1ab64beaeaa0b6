//! Errors that point into the file.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::Spanned;

use crate::keys::Key;
use crate::plain_words::plain_words;
use crate::words::{clipped, suggest};

/// An error in a file: its place, and what would be valid instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SceneError {
    file: PathBuf,
    message: String,
    place: Option<Place>,
}

/// A place in a file, counted from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Place {
    line: usize,
    column: usize,
    excerpt: Excerpt,
}

/// The line of a place, or the part of a long line that is around it.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Excerpt {
    text: String,
    /// Characters before the place.
    indent: usize,
    /// Characters of the place in this line.
    width: usize,
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

    /// The message without the place.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// File, place and message in one line.
    pub fn headline(&self) -> String {
        let file = self.file.display();
        match &self.place {
            Some(Place { line, column, .. }) => format!("{file}:{line}:{column}: {}", self.message),
            None => format!("{file}: {}", self.message),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.headline())?;
        let Some(Place { line, excerpt: Excerpt { text, indent, width }, .. }) = &self.place else { return Ok(()) };
        let margin = " ".repeat(line.to_string().len());
        write!(formatter, "\n{margin} |\n{line} | {text}\n")?;
        write!(formatter, "{margin} | {}{}", " ".repeat(*indent), "^".repeat((*width).max(1)))
    }
}

impl std::error::Error for SceneError {}

impl Excerpt {
    /// Longest excerpt, and what is shown of a longer line before the place (characters).
    const LENGTH: usize = 160;
    const BEFORE: usize = 40;

    /// From a line with a place `width` characters wide after the first `indent` characters.
    fn new(line: &str, indent: usize, width: usize) -> Self {
        let skipped = if line.chars().count() > Self::LENGTH { indent.saturating_sub(Self::BEFORE) } else { 0 };
        let shown = line.chars().skip(skipped).take(Self::LENGTH);
        // Tabs would shift the marks below the line, and other control characters would act on the terminal.
        let text: String = shown.map(|shown| if input::is_control(shown) { ' ' } else { shown }).collect();
        let indent = indent - skipped;
        let width = width.min(text.chars().count().saturating_sub(indent));
        Self { text, indent, width }
    }
}

/// Name and text of a file that errors point into.
#[derive(Debug, Clone, Copy)]
pub struct Source<'text> {
    /// Name of the file.
    pub file: &'text Path,
    /// Its text.
    pub text: &'text str,
}

impl Source<'_> {
    /// An error at a range of bytes.
    pub fn error(&self, span: Range<usize>, message: impl Into<String>) -> SceneError {
        // A byte order mark is not part of the first line.
        let first = if self.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let start = self.boundary(span.start).max(first);
        let end = self.boundary(span.end).max(start);
        let before = &self.text[..start];
        let line_start = before.rfind('\n').map_or(first, |end| end + 1);
        let line = self.text[line_start..].lines().next().unwrap_or_default();
        let indent = before[line_start..].chars().count();
        let place = Place {
            line: before.matches('\n').count() + 1,
            column: indent + 1,
            excerpt: Excerpt::new(line, indent, self.text[start..end].chars().count()),
        };
        SceneError { file: self.file.to_owned(), message: message.into(), place: Some(place) }
    }

    /// The start of the character at an index of the text, or its end.
    fn boundary(&self, index: usize) -> usize {
        let index = index.min(self.text.len());
        (0..=index).rev().find(|&index| self.text.is_char_boundary(index)).unwrap_or(0)
    }

    /// Index of a value among the known ones.
    ///
    /// # Errors
    /// When it is not among them. The message suggests the nearest.
    pub fn require_known(&self, value: &Spanned<String>, known: &[&str]) -> Result<usize, SceneError> {
        let name = clipped(value.get_ref());
        known
            .iter()
            .position(|known| *known == name)
            .ok_or_else(|| self.error(value.span(), format!("unknown value `{name}`{}", suggest(&name, known))))
    }

    /// A number in the range of a key. `name` is what messages call it.
    ///
    /// # Errors
    /// When it is outside.
    pub fn require_within(&self, value: &Spanned<f64>, key: &Key, name: &str) -> Result<f64, SceneError> {
        let range = key.bounds();
        if range.contains(*value.get_ref()) {
            return Ok(*value.get_ref());
        }
        let written = clipped(self.text.get(value.span()).unwrap_or_default());
        Err(self.error(value.span(), format!("{name}: {written} must lie {range} {}", key.unit)))
    }

    /// An error of the TOML parser in plain words. For an unknown key it suggests the nearest valid one.
    pub fn parse_error(&self, error: &toml::de::Error) -> SceneError {
        let span = error.span();
        let written = span.clone().and_then(|span| self.text.get(span)).unwrap_or_default();
        let message = plain_words(error.message(), written);
        match span {
            Some(span) => self.error(span, message),
            None => SceneError::about(self.file, message),
        }
    }
}

//! Ranges of numbers, and how messages say them.

use std::ops::Range as Span;

use crate::error::{SceneError, Source};

/// An interval as it is written in mathematics, such as `(0, 0.5]` or `[1, inf)`. Infinite ends do not belong to it, so
/// that only finite numbers lie inside.
#[derive(Debug, Clone, Copy)]
pub struct Range {
    text: &'static str,
    lower: End,
    upper: End,
}

#[derive(Debug, Clone, Copy)]
struct End {
    text: &'static str,
    number: f64,
    belongs: bool,
}

impl Range {
    /// Reads an interval.
    ///
    /// # Panics
    /// When it is none: intervals are written in the program, not by its user.
    pub fn new(text: &'static str) -> Self {
        let inner = text.trim_matches(['(', '[', ']', ')']);
        let (lower, upper) = inner.split_once(", ").expect("an interval has two ends");
        let end = |text: &'static str, belongs| {
            let number = text.parse().expect("the end of an interval is a number");
            End { text, number, belongs }
        };
        Self { text, lower: end(lower, text.starts_with('[')), upper: end(upper, text.ends_with(']')) }
    }

    /// A number that lies inside.
    ///
    /// # Errors
    /// When it does not, with the number as it stands in the file.
    pub fn check(self, source: Source, key: &str, span: Span<usize>, number: f64) -> Result<f64, SceneError> {
        let Self { lower, upper, .. } = self;
        let is_above = number > lower.number || lower.belongs && number == lower.number;
        let is_below = number < upper.number || upper.belongs && number == upper.number;
        if is_above && is_below {
            return Ok(number);
        }
        let written = &source.text[span.clone()];
        let finite = if number.is_finite() { "" } else { " and finite" };
        let words = match (lower.number.is_finite(), upper.number.is_finite()) {
            (false, false) => "be finite".to_owned(),
            (true, false) if lower.belongs => format!("be at least {}{finite}", lower.text),
            (true, false) => format!("be above {}{finite}", lower.text),
            _ => format!("lie in {}", self.text),
        };
        Err(source.error(span, format!("{key} = {written}: must {words}")))
    }
}

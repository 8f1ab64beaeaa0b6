//! Ranges of numbers, and their text in messages.

use std::fmt;

/// An interval. Its ends may or may not belong to it; it never contains NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Whether the lower end belongs to the interval.
    pub includes_low: bool,
    /// Whether the upper end belongs to the interval.
    pub includes_high: bool,
}

impl Range {
    /// All numbers from `low` to `high`.
    pub const fn closed(low: f64, high: f64) -> Self {
        Self { low, high, includes_low: true, includes_high: true }
    }

    /// The numbers between `low` and `high`, without these two.
    pub const fn open(low: f64, high: f64) -> Self {
        Self { low, high, includes_low: false, includes_high: false }
    }

    /// The numbers above `low`, up to `high`.
    pub const fn above(low: f64, high: f64) -> Self {
        Self { low, high, includes_low: false, includes_high: true }
    }

    /// An interval as it is written in mathematics, such as `(0, 0.5]` or `[1, inf)`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (includes_low, inner) = match text.split_at_checked(1)? {
            ("[", inner) => (true, inner),
            ("(", inner) => (false, inner),
            _ => return None,
        };
        let (low, high) = inner.strip_suffix([']', ')'])?.split_once(", ")?;
        Some(Self {
            low: low.parse().ok()?,
            high: high.parse().ok()?,
            includes_low,
            includes_high: text.ends_with(']'),
        })
    }

    /// Whether a number lies in the interval.
    pub fn contains(&self, number: f64) -> bool {
        let above = number > self.low || self.includes_low && number == self.low;
        let below = number < self.high || self.includes_high && number == self.high;
        above && below
    }
}

/// In words that follow "must lie".
impl fmt::Display for Range {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let (low, high) = (short(self.low), short(self.high));
        if self.includes_low && self.includes_high {
            return write!(formatter, "between {low} and {high}");
        }
        let from = if self.includes_low { "at or above" } else { "above" };
        let to = if self.includes_high { "at or below" } else { "below" };
        write!(formatter, "{from} {low} and {to} {high}")
    }
}

/// A number without long rows of zeros.
pub fn short(number: f64) -> String {
    const PLAIN: std::ops::Range<f64> = 1e-3..1e5;
    if number == 0.0 || PLAIN.contains(&number.abs()) { format!("{number}") } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_read_as_they_are_written() {
        assert_eq!(Range::parse("(0, 0.5]"), Some(Range::above(0.0, 0.5)));
        assert_eq!(Range::parse("[-2, 77]"), Some(Range::closed(-2.0, 77.0)));
        assert_eq!(Range::parse("(-inf, inf)"), Some(Range::open(f64::NEG_INFINITY, f64::INFINITY)));
        let from_one = Range::parse("[1, inf)").unwrap();
        assert!(from_one.contains(1.0) && !from_one.contains(f64::INFINITY));
        for wrong in ["", "0, 1", "[0, 1", "0, 1]", "[0]", "[0, one]", "é, 1]"] {
            assert_eq!(Range::parse(wrong), None, "{wrong}");
        }
    }
}

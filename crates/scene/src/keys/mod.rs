//! The keys of scene and homotopy files, declared once: validation reads its ranges and defaults here, and the tables
//! of `docs/scene.md` are made of the same declarations.

mod declared;

use std::fmt;
use std::ops::RangeInclusive;

pub(crate) use declared::UNITS;

/// One key that a file may have.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// Table of the key, such as `horizon`; empty at the top of a scene. `part` stands for both `[[body.part]]` and
    /// `[[environment.part]]`.
    pub table: &'static str,
    /// Name of the key.
    pub name: &'static str,
    /// Values that it takes.
    pub values: Values,
    /// Unit of its numbers, empty where there is none.
    pub unit: &'static str,
    /// What holds when it is not given.
    pub absent: Absent,
    /// What it means, in one line.
    pub meaning: &'static str,
}

/// Values that a key takes. Lists come with the number of entries that they may have.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// One number.
    Number(Range),
    /// One integer.
    Integer(Range),
    /// Three numbers.
    Vector(Range),
    /// A list of numbers.
    Numbers(Range, RangeInclusive<usize>),
    /// A list of three numbers each.
    Vectors(Range, RangeInclusive<usize>),
    /// A list of three numbers each, of norm 1 or all zero.
    Directions(RangeInclusive<usize>),
    /// A unit quaternion `[w, x, y, z]`.
    Quaternion,
    /// Three numbers or a symmetric 3x3 matrix; the range is that of the principal values.
    Inertia(Range),
    /// One of several words.
    Choice(&'static [&'static str]),
    /// A text of 1 to [`MAX_NAME_LENGTH`] characters in one line.
    Name,
    /// Name of a file, relative to the file that names it.
    File,
    /// The name of a file, or a table.
    FileOrTable,
    /// A list of pairs of names.
    Pairs(RangeInclusive<usize>),
    /// A table.
    Table,
    /// Tables, each under a header in double brackets.
    Tables(RangeInclusive<usize>),
}

/// What holds when a key is not given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Absent {
    /// The file is refused.
    Refused,
    /// This number holds.
    Number(f64),
    /// What the words say.
    Means(&'static str),
}

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

/// Longest title or name, in characters.
pub const MAX_NAME_LENGTH: usize = 100;

/// Most contact forces that a problem may have: steps x offset directions x contact pairs.
pub const MAX_CONTACT_FORCES: usize = 1_000_000;

/// Every key of scene and homotopy files, table by table.
pub fn keys() -> &'static [Key] {
    declared::KEYS
}

/// The declaration of a key.
///
/// # Panics
/// When there is none: the reader asks only for declared keys.
pub(crate) fn key(table: &str, name: &str) -> &'static Key {
    let found = keys().iter().find(|key| key.table == table && key.name == name);
    found.unwrap_or_else(|| panic!("`{name}` of `{table}` is declared"))
}

impl Key {
    /// Range of the key's numbers, where it has a range.
    pub fn range(&self) -> Option<Range> {
        match self.values {
            Values::Number(range)
            | Values::Integer(range)
            | Values::Vector(range)
            | Values::Numbers(range, _)
            | Values::Vectors(range, _)
            | Values::Inertia(range) => Some(range),
            _ => None,
        }
    }

    /// Number of entries that the key's list may have, where it takes a list.
    pub fn count(&self) -> Option<&RangeInclusive<usize>> {
        match &self.values {
            Values::Numbers(_, count)
            | Values::Vectors(_, count)
            | Values::Directions(count)
            | Values::Pairs(count)
            | Values::Tables(count) => Some(count),
            _ => None,
        }
    }

    /// The range of a key that has one.
    ///
    /// # Panics
    /// When it has none.
    pub(crate) fn bounds(&self) -> Range {
        self.range().unwrap_or_else(|| panic!("{} has a range", self.path()))
    }

    /// The default of a key that has a number as its default.
    ///
    /// # Panics
    /// When it has none.
    pub(crate) fn default_number(&self) -> f64 {
        match self.absent {
            Absent::Number(default) => default,
            _ => panic!("{} has a default", self.path()),
        }
    }

    /// The key with its table, as messages name it.
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.name.to_owned() } else { format!("{}.{}", self.table, self.name) }
    }
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
pub(crate) fn short(number: f64) -> String {
    const PLAIN: std::ops::Range<f64> = 1e-3..1e5;
    if number == 0.0 || PLAIN.contains(&number.abs()) { format!("{number}") } else { format!("{number:e}") }
}

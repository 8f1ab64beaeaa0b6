//! The keys of scene and homotopy files, declared once: validation reads its ranges and defaults here, and the tables
//! of `docs/reference/scene.md` are made of the same declarations.

mod declared;
mod options;

use std::fmt;
use std::ops::RangeInclusive;

use crate::range::Range;

pub(crate) use declared::{COVERAGES, INTERFACES};
pub use declared::{SCALES, UNITS};

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
    /// Meaning of its absence.
    pub absent: Absent,
    /// Meaning, in one line.
    pub meaning: &'static str,
}

/// Values that a key takes. Lists come with the number of entries that they may have.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// One number.
    Number(Range),
    /// One integer.
    Integer(Range),
    /// A number of metres, or a text with a number and its unit.
    Length(Range),
    /// Three numbers.
    Vector(Range),
    /// A list of numbers.
    Numbers(Range, RangeInclusive<usize>),
    /// One number, or a list of numbers.
    NumberOrNumbers(Range, RangeInclusive<usize>),
    /// A list of three numbers each.
    Vectors(Range, RangeInclusive<usize>),
    /// Three numbers of norm 1.
    Direction,
    /// A list of three numbers each, of norm 1 or all zero.
    Directions(RangeInclusive<usize>),
    /// A unit quaternion `[w, x, y, z]`.
    Quaternion,
    /// Three numbers or a symmetric 3x3 matrix; the range is that of the principal values.
    Matrix(Range),
    /// One number, three numbers or a symmetric 3x3 matrix; the range is that of the principal values.
    NumberOrMatrix(Range),
    /// A symmetric positive definite 6x6 matrix; the range is that of its entries.
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

/// In words, as the documentation has them (Markdown).
impl fmt::Display for Values {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let count = |count: &RangeInclusive<usize>| format!("{} to {}", count.start(), count.end());
        let matrix = "3 numbers, or a symmetric 3x3 matrix; principal values";
        match self {
            Self::Number(range) => write!(formatter, "number {range}"),
            Self::Integer(range) => write!(formatter, "integer {range}"),
            Self::Length(range) => write!(formatter, "number {range}, or text with its unit"),
            Self::Vector(range) => write!(formatter, "3 numbers {range}"),
            Self::Numbers(range, entries) => write!(formatter, "list of {} numbers {range}", count(entries)),
            Self::NumberOrNumbers(range, entries) => {
                write!(formatter, "number {range}, or list of {} such numbers", count(entries))
            }
            Self::Vectors(range, entries) => write!(formatter, "list of {} times 3 numbers {range}", count(entries)),
            Self::Direction => formatter.write_str("3 numbers of norm 1"),
            Self::Directions(entries) => {
                write!(formatter, "list of {} times 3 numbers of norm 1, or `[0, 0, 0]`", count(entries))
            }
            Self::Quaternion => formatter.write_str("4 numbers `[w, x, y, z]` of norm 1"),
            Self::Matrix(range) => write!(formatter, "{matrix} {range}"),
            Self::NumberOrMatrix(range) => write!(formatter, "number, {matrix} {range}"),
            Self::Inertia(range) => write!(formatter, "symmetric positive definite 6x6 matrix of numbers {range}"),
            Self::Choice(words) => write!(formatter, "`\"{}\"`", words.join("\"`, `\"")),
            Self::Name => write!(formatter, "text of 1 to {MAX_NAME_LENGTH} characters in one line"),
            Self::File => formatter.write_str("file name"),
            Self::FileOrTable => formatter.write_str("file name or table"),
            Self::Pairs(entries) => write!(formatter, "list of {} pairs of names", count(entries)),
            Self::Table => formatter.write_str("table"),
            Self::Tables(entries) => write!(formatter, "{} tables", count(entries)),
        }
    }
}

/// Meaning of the absence of a key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Absent {
    /// The file is refused.
    Refused,
    /// This number holds.
    Number(f64),
    /// The meaning in words.
    Means(&'static str),
}

/// In words, as the documentation has them (Markdown).
impl fmt::Display for Absent {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Refused => formatter.write_str("needed"),
            Self::Number(default) => default.fmt(formatter),
            Self::Means(words) => formatter.write_str(words),
        }
    }
}

/// Longest title or name, in characters.
pub const MAX_NAME_LENGTH: usize = 100;

/// Most contact forces that a problem may have: steps x offset directions x contact pairs.
pub const MAX_CONTACT_FORCES: usize = 1_000_000;

/// Every key of scene and homotopy files, table by table.
pub fn keys() -> &'static [Key] {
    declared::KEYS
}

/// The keys of a table; those of `ipopt` are the options of Ipopt.
///
/// # Panics
/// When there is no such table: only declared ones are read.
pub(crate) fn table(name: &str) -> &'static [Key] {
    let mut tables = keys().chunk_by(|one, other| one.table == other.table).chain([options::options()]);
    tables.find(|keys| keys[0].table == name).unwrap_or_else(|| panic!("[{name}] is declared"))
}

/// The declaration of a key.
///
/// # Panics
/// When there is none: only declared ones are read.
pub fn key(table: &str, name: &str) -> &'static Key {
    let found = keys().iter().find(|key| key.table == table && key.name == name);
    found.unwrap_or_else(|| panic!("`{name}` of `{table}` is declared"))
}

/// Which keys a kind of file has.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Form {
    /// Keys at its top.
    pub top: &'static [Key],
    /// Keys of its tables.
    tables: &'static [Key],
}

impl Form {
    /// A scene.
    pub fn scene() -> Self {
        Self { top: table(""), tables: keys() }
    }

    /// A homotopy file.
    pub fn homotopy() -> Self {
        Self { top: declared::HOMOTOPY_FILE, tables: table("homotopy") }
    }

    /// The one table that has a key, if only one has it.
    pub fn owner(&self, name: &str) -> Option<&'static str> {
        let mut tables = self.tables.iter().chain(options::options()).filter(|key| key.name == name);
        match (tables.next()?.table, tables.next()) {
            ("", _) | (_, Some(_)) => None,
            ("part", None) => Some("body.part], [environment.part] or [gripper.part"),
            (table, None) => Some(table),
        }
    }
}

impl Key {
    /// Range of the key's numbers, where it has a range.
    pub fn range(&self) -> Option<Range> {
        match self.values {
            Values::Number(range)
            | Values::Integer(range)
            | Values::Length(range)
            | Values::Vector(range)
            | Values::Numbers(range, _)
            | Values::NumberOrNumbers(range, _)
            | Values::Vectors(range, _)
            | Values::Matrix(range)
            | Values::Inertia(range)
            | Values::NumberOrMatrix(range) => Some(range),
            _ => None,
        }
    }

    /// Number of entries that the key's list may have, where it takes a list.
    pub fn count(&self) -> Option<&RangeInclusive<usize>> {
        match &self.values {
            Values::Numbers(_, count)
            | Values::NumberOrNumbers(_, count)
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

    /// The words of a key that takes one of several.
    ///
    /// # Panics
    /// When it takes none.
    pub(crate) fn words(&self) -> &'static [&'static str] {
        match self.values {
            Values::Choice(words) => words,
            _ => panic!("{} has words", self.path()),
        }
    }

    /// The key with its table, as messages name it.
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.name.to_owned() } else { format!("{}.{}", self.table, self.name) }
    }
}

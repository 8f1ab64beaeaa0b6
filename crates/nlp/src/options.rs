//! Ipopt's options by their own names.

use std::fmt;

use crate::solution::Start;

/// Value of an option.
#[derive(Debug, Clone, PartialEq)]
pub enum OptionValue {
    /// An integer; also accepted by options that take a real number.
    Integer(i32),
    /// A real value.
    Number(f64),
    /// A word.
    Text(String),
}

impl From<i32> for OptionValue {
    fn from(value: i32) -> Self {
        Self::Integer(value)
    }
}

impl From<f64> for OptionValue {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for OptionValue {
    fn from(value: &str) -> Self {
        Self::Text(value.to_owned())
    }
}

impl fmt::Display for OptionValue {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Integer(value) => value.fmt(formatter),
            Self::Number(value) => value.fmt(formatter),
            Self::Text(value) => write!(formatter, "\"{value}\""),
        }
    }
}

/// Options in the order in which they were first set.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    entries: Vec<(String, OptionValue)>,
}

impl Options {
    /// Those that every solve begins with, with one of Ipopt's names of linear solvers.
    pub(crate) fn defaults(start: &Start, linear_solver: &str) -> Self {
        let mut options = Self::default();
        options.set("print_level", 0);
        options.set("sb", "yes");
        // A file ipopt.opt in the working directory must not change results.
        options.set("option_file_name", "");
        options.set("linear_solver", linear_solver);
        options.set("warm_start_init_point", if matches!(start, Start::Warm(_)) { "yes" } else { "no" });
        options
    }

    /// Sets an option and replaces an earlier value. Ipopt checks names and types when a problem is solved.
    pub fn set(&mut self, name: &str, value: impl Into<OptionValue>) {
        let value = value.into();
        match self.entries.iter_mut().find(|(known, _)| known == name) {
            Some((_, old)) => *old = value,
            None => self.entries.push((name.to_owned(), value)),
        }
    }

    /// Sets all options of another collection.
    pub fn extend(&mut self, other: &Options) {
        for (name, value) in &other.entries {
            self.set(name, value.clone());
        }
    }

    /// All names and values.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &OptionValue)> {
        self.entries.iter().map(|(name, value)| (name.as_str(), value))
    }
}

//! Tables as CSV: one type per row, for writing and reading.

use std::path::Path;
use std::str::FromStr;

use csv::StringRecord;
use plan::PlannerError;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::atomic::read_text;

/// A value of a table, written in full and without an exponent, so that it is read back exactly.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Value(pub f64);

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        match f64::from_str(text.trim()) {
            Ok(value) if value.is_finite() => Ok(Self(value)),
            _ => Err(serde::de::Error::custom(format!("`{text}` is not a finite number"))),
        }
    }
}

/// A time (s) without the rounding of its computation.
pub fn seconds(time: f64) -> Value {
    const NANOSECONDS: f64 = 1e9;
    Value((time * NANOSECONDS).round() / NANOSECONDS)
}

/// Rows as CSV with a header; a table without rows has none.
///
/// # Errors
/// When a row cannot be written, which no row type of ours causes.
pub fn to_csv<T: Serialize>(rows: impl IntoIterator<Item = T>) -> Result<Vec<u8>, PlannerError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).map_err(|_| PlannerError::Internal("a row cannot be written"))?;
    }
    writer.into_inner().map_err(|_| PlannerError::Internal("a table cannot be written"))
}

/// Rows of a CSV file. Columns are found by name; others are ignored, as are lines that begin with `#`.
///
/// # Errors
/// With the line that is wrong.
pub fn read_csv<T: DeserializeOwned>(file: &Path) -> Result<Vec<T>, PlannerError> {
    let text = read_text(file)?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(text.as_bytes());
    let refuse = |error: csv::Error, row: &StringRecord| {
        let line = error.position().map_or(1, |position| position.line() as usize);
        PlannerError::line(file, line, describe(&error, row))
    };
    let header = reader.headers().cloned().map_err(|error| refuse(error, &StringRecord::new()))?;
    let parse = |row: Result<StringRecord, csv::Error>| {
        let row = row.map_err(|error| refuse(error, &StringRecord::new()))?;
        row.deserialize(Some(&header)).map_err(|error| refuse(error, &row))
    };
    reader.into_records().map(parse).collect()
}

/// The fault of a row, without its line, which the error states separately.
fn describe(error: &csv::Error, row: &StringRecord) -> String {
    match error.kind() {
        csv::ErrorKind::Deserialize { err, .. } => {
            let problem = err.kind().to_string().replace("missing field", "there is no column");
            let is_wrong = |cell: &str| problem.starts_with(&format!("`{cell}` "));
            let column = err.field().map(|field| field as usize).or_else(|| row.iter().position(is_wrong));
            column.map_or_else(String::new, |column| format!("column {}: ", column + 1)) + &problem
        }
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} columns where the header has {expected_len}")
        }
        _ => error.to_string(),
    }
}

/// Whether a file is a table of this header, so that it may be replaced by another one.
pub fn has_header(file: &Path, header: &str) -> bool {
    read_text(file).is_ok_and(|text| text.lines().next() == Some(header))
}

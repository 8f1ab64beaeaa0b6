//! Records of unfinished work with a hash of themselves: one that was cut or changed is not gone on with.

use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::value::{RawValue, to_raw_value};

use crate::error::PlannerError;
use crate::files::atomic::{hash, write_file};

/// The JSON of a record and its hash (SHA-256, hexadecimal).
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed {
    hash: String,
    record: Box<RawValue>,
}

/// Writes a record.
///
/// # Errors
/// When it cannot be written.
pub fn write_sealed<T: Serialize>(file: &Path, record: &T) -> Result<(), PlannerError> {
    let json = |_| PlannerError::Internal("a record of unfinished work cannot be written");
    let record = to_raw_value(record).map_err(json)?;
    let sealed = Sealed { hash: hash(record.get().as_bytes()), record };
    write_file(file, &serde_json::to_vec(&sealed).map_err(json)?)
}

/// The record in a text; none if it is not the one that was written.
pub fn unseal<T: DeserializeOwned>(text: &str) -> Option<T> {
    let Sealed { hash: expected, record } = serde_json::from_str(text).ok()?;
    if hash(record.get().as_bytes()) != expected {
        return None;
    }
    serde_json::from_str(record.get()).ok()
}

//! Records of unfinished work with a hash of themselves: one that was cut or changed is not gone on with.

use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::error::PlannerError;
use crate::files::atomic::{hash, write_file};

/// A record and the hash (SHA-256, hexadecimal) of its JSON.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed<T> {
    hash: String,
    record: T,
}

/// Writes a record.
///
/// # Errors
/// When it cannot be written.
pub fn write_sealed<T: Serialize>(file: &Path, record: &T) -> Result<(), PlannerError> {
    let json = |_| PlannerError::Internal("a record of unfinished work cannot be written");
    let sealed = Sealed { hash: hash(&serde_json::to_vec(record).map_err(json)?), record };
    write_file(file, &serde_json::to_vec(&sealed).map_err(json)?)
}

/// The record in a text; none if it is not the one that was written.
pub fn unseal<T: Serialize + DeserializeOwned>(text: &str) -> Option<T> {
    let Sealed { hash: expected, record } = serde_json::from_str(text).ok()?;
    (hash(&serde_json::to_vec(&record).ok()?) == expected).then_some(record)
}

//! Records of unfinished work with a hash of themselves: one that was cut or changed is not gone on with.

use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::value::{RawValue, to_raw_value};

use crate::error::{PlannerError, Unusable};
use crate::files::atomic::{hash, write_file};
use crate::files::format::Format;

/// The JSON of a record, its format and its hash (SHA-256, hexadecimal).
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed {
    #[serde(default)]
    format: u32,
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
    let sealed = Sealed { format: Format::CURRENT.into(), hash: hash(record.get().as_bytes()), record };
    write_file(file, &serde_json::to_vec(&sealed).map_err(json)?)
}

/// The record in a text; `damaged` if it is not the one that was written.
///
/// # Errors
/// Why it cannot be resumed from.
pub fn unseal<T: DeserializeOwned>(text: &str, damaged: Unusable) -> Result<T, Unusable> {
    let Sealed { format, hash: expected, record } = serde_json::from_str(text).map_err(|_| damaged)?;
    Format::try_from(format).map_err(|_| Unusable::Newer)?;
    if hash(record.get().as_bytes()) != expected {
        return Err(damaged);
    }
    serde_json::from_str(record.get()).map_err(|_| damaged)
}

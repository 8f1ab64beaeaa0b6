//! Records of unfinished work with a hash of themselves: a truncated or modified checkpoint is never resumed.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::value::{RawValue, to_raw_value};

use crate::digest::hash;
use crate::error::{PlannerError, Unusable};
use crate::format::Format;

/// The JSON of a record, its format and its hash (SHA-256, hexadecimal).
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed {
    #[serde(default)]
    format: u32,
    hash: String,
    record: Box<RawValue>,
}

/// The text of a record with its hash.
///
/// # Errors
/// When it has no JSON.
pub fn seal<T: Serialize>(record: &T) -> Result<Vec<u8>, PlannerError> {
    let json = |_| PlannerError::Internal("a record of unfinished work cannot be written");
    let record = to_raw_value(record).map_err(json)?;
    let sealed = Sealed { format: Format::CURRENT.into(), hash: hash(record.get().as_bytes()), record };
    serde_json::to_vec(&sealed).map_err(json)
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

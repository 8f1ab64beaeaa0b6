//! Reading text files that people have written.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use crate::error::{SceneError, Source};

/// Largest file (MiB).
const LARGEST: u64 = 16;

/// Text of a file in UTF-8. `what` names it in messages.
///
/// # Errors
/// When it is missing, a folder, too large or not in UTF-8.
pub fn read_text(file: &Path, what: &str) -> Result<String, SceneError> {
    let refuse = |reason: &str| SceneError::about(file, format!("the {what} cannot be read: {reason}"));
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => refuse("there is no such file"),
        ErrorKind::IsADirectory => refuse("it is a folder"),
        ErrorKind::PermissionDenied => refuse("permission denied"),
        _ => refuse(&error.to_string()),
    };
    let mut bytes = Vec::new();
    let limit = LARGEST << 20;
    File::open(file).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes)).map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(refuse(&format!("it is larger than {LARGEST} MiB")));
    }
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes());
        let message = format!("the {what} is not in UTF-8 from here on: save it as UTF-8");
        Source { file, text: &text }.error(place..place + 1, message)
    })
}

//! Scene files that are written for people.

use std::path::Path;

use plan::PlannerError;

use crate::atomic::{require_folder, write_file};

/// Writes a scene to a file whose name ends with `.toml`. An existing file is replaced only if `replaces`.
///
/// # Errors
/// When there is a file that must not be replaced, the name has another ending, or it cannot be written.
pub fn write_new_scene(file: &Path, text: &str, replaces: bool) -> Result<(), PlannerError> {
    // So that a typing error does not replace a mesh or a document.
    if file.extension().is_none_or(|ending| ending != "toml") {
        return Err(PlannerError::file(file, "the name of a scene file ends with .toml"));
    }
    if file.is_dir() {
        return Err(PlannerError::file(file, "is a folder; name a file"));
    }
    // A link that leads nowhere is something of the user's, too.
    if file.symlink_metadata().is_ok() && !replaces {
        return Err(PlannerError::file(file, "already exists; name another file, or replace it with --force"));
    }
    file.parent().map_or(Ok(()), require_folder)?;
    write_file(file, text.as_bytes())
}

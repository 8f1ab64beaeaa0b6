//! Files that are written whole or not at all.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::Path;

use sha2::{Digest, Sha256};
use tempfile::NamedTempFile;

use crate::error::PlannerError;

/// Writes a file under a temporary name and renames it, so that it is never half there. Its folder is made where it is
/// missing.
///
/// # Errors
/// When it cannot be written; what stood there before then still stands.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), PlannerError> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(PlannerError::written(folder))?;
    let mut file = NamedTempFile::new_in(folder).map_err(PlannerError::written(folder))?;
    file.write_all(content).map_err(PlannerError::written(path))?;
    make_readable(file.path()).map_err(PlannerError::written(path))?;
    file.persist(path).map_err(|error| PlannerError::written(path)(error.error))?;
    Ok(())
}

/// Refuses the name of a folder on whose way a file stands.
///
/// # Errors
/// With the name of that file.
pub fn require_folder(folder: &Path) -> Result<(), PlannerError> {
    match folder.ancestors().find(|place| place.exists() && !place.is_dir()) {
        None => Ok(()),
        Some(file) if file == folder => Err(PlannerError::file(folder, "is a file; name a folder")),
        Some(file) => Err(PlannerError::file(folder, format!("{} is a file; name another folder", file.display()))),
    }
}

/// Temporary files are private; results are not.
#[cfg(unix)]
fn make_readable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(path, fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_path: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Removes a file, if there is one.
///
/// # Errors
/// When it cannot be removed.
pub fn remove_file(path: &Path) -> Result<(), PlannerError> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(PlannerError::written(path)(error)),
        _ => Ok(()),
    }
}

/// Text of a file of ours.
///
/// # Errors
/// When it cannot be read or is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, PlannerError> {
    let bytes = fs::read(path).map_err(PlannerError::read(path))?;
    String::from_utf8(bytes).map_err(|error| {
        let line =
            1 + error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
        PlannerError::line(path, line, "not UTF-8 text")
    })
}

/// Hash (SHA-256, hexadecimal) of some bytes.
pub fn hash(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}

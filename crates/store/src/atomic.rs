//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use plan::{Hasher, PlannerError};

/// Largest file (bytes) that the program writes.
const LARGEST: u64 = 1 << 28;

/// Writes a file under a temporary name and renames it, so that it is never incomplete. A missing folder is made.
///
/// # Errors
/// When it cannot be written; an older file then stays.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), PlannerError> {
    let mut file = PartialFile::create(path)?;
    file.write_all(content).map_err(PlannerError::written(path))?;
    file.finish().map(|_| ())
}

/// A file that is written in pieces under a temporary name, which it has until it is finished.
#[derive(Debug)]
pub struct PartialFile {
    path: PathBuf,
    partial: PathBuf,
    file: File,
    hasher: Hasher,
    is_finished: bool,
}

impl PartialFile {
    /// Begins a file. A missing folder is made.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn create(path: &Path) -> Result<Self, PlannerError> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(PlannerError::written(folder))?;
        // A device or a pipe is not replaced; a link to nothing is.
        if fs::metadata(path).is_ok() {
            input::require_regular(path).map_err(PlannerError::written(path))?;
        }
        let name = path.file_name().ok_or_else(|| PlannerError::file(path, "is not the name of a file"))?;
        let partial = folder.join(format!(".{}.partial", name.to_string_lossy()));
        let file = claim(&partial).map_err(PlannerError::written(path))?;
        let begun = Self { path: path.to_owned(), partial, file, hasher: Hasher::default(), is_finished: false };
        begun.file.set_len(0).map_err(PlannerError::written(path))?;
        Ok(begun)
    }

    /// Gives it its name. Returns its hash.
    ///
    /// # Errors
    /// When it cannot be written; an older file then stays.
    pub fn finish(mut self) -> Result<String, PlannerError> {
        let written = self.file.sync_data().and_then(|()| fs::rename(&self.partial, &self.path));
        written.map_err(PlannerError::written(&self.path))?;
        self.is_finished = true;
        Ok(std::mem::take(&mut self.hasher).finish())
    }
}

impl Write for PartialFile {
    fn write(&mut self, piece: &[u8]) -> std::io::Result<usize> {
        let count = self.file.write(piece)?;
        self.hasher.add(&piece[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        if !self.is_finished {
            // Nothing is left of a file that cannot be written.
            let _ = fs::remove_file(&self.partial);
        }
    }
}

/// Opens a file that only this process writes, until it is renamed or closed. The file of a killed process is reused,
/// so that none accumulate.
fn claim(partial: &Path) -> std::io::Result<File> {
    loop {
        let file = input::append(partial)?;
        file.lock()?;
        // Who waited for the lock holds a file that has its final name by now.
        if is_at(&file, partial) {
            return Ok(file);
        }
    }
}

/// Whether an open file is still the one at a path.
#[cfg(unix)]
pub(super) fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(one), Ok(other)) => identity(one) == identity(other),
        _ => false,
    }
}

/// Whether an open file is still the one at a path.
#[cfg(not(unix))]
pub(super) fn is_at(_file: &File, path: &Path) -> bool {
    path.exists()
}

/// Refuses the name of a folder whose path leads through a file, or through a link to nothing.
///
/// # Errors
/// With the name of that file.
pub fn require_folder(folder: &Path) -> Result<(), PlannerError> {
    let stands = |place: &&Path| place.symlink_metadata().is_ok() && !place.is_dir();
    let Some(place) = folder.ancestors().find(stands) else { return Ok(()) };
    let what = match place.exists() {
        true => "is a file",
        false => "is a link to what does not exist",
    };
    Err(PlannerError::file(
        folder,
        match place == folder {
            true => format!("{what}; name a folder"),
            false => format!("{} {what}; name another folder", place.display()),
        },
    ))
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

/// Reads a file of the program.
///
/// # Errors
/// When it cannot be read, is another kind of file, or is too large.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, PlannerError> {
    input::read(path, LARGEST).map_err(PlannerError::read(path))
}

/// Text of such a file.
///
/// # Errors
/// As [`read_bytes`], and when it is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, PlannerError> {
    let bytes = read_bytes(path)?;
    String::from_utf8(bytes).map_err(|error| {
        let line =
            1 + error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
        PlannerError::line(path, line, "not UTF-8 text")
    })
}

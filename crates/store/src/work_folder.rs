//! A hidden folder beside the target folder: all work is done there, under a lock, and only whole content is moved in.

use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use plan::PlannerError;

use crate::atomic::{is_at, require_folder};

/// Marks a hidden folder as ours; who works in it holds a lock on this file.
const LOCK: &str = "lock";
/// Folder of what is whole and still to be moved in.
const WHOLE: &str = "whole";

/// A folder that this process alone may write, and the hidden folder of unfinished work beside it.
#[derive(Debug)]
pub struct WorkFolder {
    target: PathBuf,
    path: PathBuf,
    lock: File,
}

impl WorkFolder {
    /// Claims a folder; nothing in it changes.
    ///
    /// # Errors
    /// When another process writes into it, or the hidden folder is a foreign one.
    pub fn claim(target: &Path) -> Result<Self, PlannerError> {
        let target = locate(target)?;
        let path = work_of(&target, target.file_name().unwrap_or_default());
        let lock = lock(&path, &target)?;
        Ok(Self { target, path, lock })
    }

    /// Whether a run has ended while it moved its results into a folder.
    pub fn is_half_moved(target: &Path) -> bool {
        let Ok(target) = target.canonicalize() else { return false };
        let Some(name) = target.file_name() else { return false };
        work_of(&target, name).join(WHOLE).is_dir()
    }

    /// Whether a run on a folder has begun and not ended; nothing is claimed.
    pub fn is_unfinished(target: &Path) -> bool {
        target.file_name().is_some_and(|name| work_of(target, name).is_dir())
    }

    /// The target folder.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Folder of unfinished work.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Folder of whole content until it is moved in.
    pub fn whole(&self) -> PathBuf {
        self.path.join(WHOLE)
    }

    /// Whether an earlier run has left unfinished work.
    pub fn has_unfinished_work(&self) -> bool {
        let mut entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        entries.any(|entry| entry.file_name() != LOCK)
    }

    /// Removes unfinished work; whether there was any.
    ///
    /// # Errors
    /// When it cannot be removed.
    pub fn discard(&self) -> Result<bool, PlannerError> {
        self.discard_all_but(&[LOCK])
    }

    /// Removes all unfinished work but what is whole and still to be moved in.
    ///
    /// # Errors
    /// When it cannot be removed.
    pub fn discard_unfinished(&self) -> Result<bool, PlannerError> {
        self.discard_all_but(&[LOCK, WHOLE])
    }

    fn discard_all_but(&self, kept: &[&str]) -> Result<bool, PlannerError> {
        let mut found = false;
        for entry in fs::read_dir(&self.path).map_err(PlannerError::read(&self.path))? {
            let entry = entry.map_err(PlannerError::read(&self.path))?;
            let path = entry.path();
            if kept.iter().any(|name| entry.file_name() == *name) {
                continue;
            }
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            let removed = if is_folder { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
            removed.map_err(PlannerError::written(&path))?;
            found = true;
        }
        Ok(found)
    }
}

/// A working folder without unfinished work is removed.
impl Drop for WorkFolder {
    fn drop(&mut self) {
        let lock = self.path.join(LOCK);
        let is_idle = fs::read_dir(&self.path).is_ok_and(|entries| entries.flatten().all(|entry| entry.path() == lock));
        if is_idle && is_at(&self.lock, &lock) {
            // Files that cannot be removed do no harm.
            let _ = fs::remove_file(&lock).and_then(|()| fs::remove_dir(&self.path));
        }
    }
}

/// The hidden folder of a folder with a name.
fn work_of(target: &Path, name: &OsStr) -> PathBuf {
    target.with_file_name(format!(".{}.unfinished", name.to_string_lossy()))
}

/// The absolute path of a folder that may be missing; its parent is made.
fn locate(target: &Path) -> Result<PathBuf, PlannerError> {
    require_folder(target)?;
    let target = match target.canonicalize() {
        Ok(path) => path,
        Err(_) => {
            let name = target.file_name().ok_or_else(|| PlannerError::file(target, "is not the name of a folder"))?;
            let parent = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
            fs::create_dir_all(parent).map_err(PlannerError::written(target))?;
            parent.canonicalize().map_err(PlannerError::written(parent))?.join(name)
        }
    };
    match target.file_name() {
        Some(_) => Ok(target),
        None => Err(PlannerError::file(&target, "cannot be the folder to write; choose another --out")),
    }
}

/// Makes the working folder and takes its lock.
fn lock(work: &Path, target: &Path) -> Result<File, PlannerError> {
    let path = work.join(LOCK);
    let busy = || PlannerError::file(target, "another run is writing into it; choose another --out, or wait");
    let is_ours = path.exists() || fs::read_dir(work).is_ok_and(|mut entries| entries.next().is_none());
    if work.symlink_metadata().is_ok() && !is_ours {
        return Err(PlannerError::file(work, "is where unfinished work is kept; move it away"));
    }
    // A run that ends removes its lock. Another run that has opened it just before then holds a useless lock and tries
    // again.
    for _ in 0..10 {
        fs::create_dir_all(work).map_err(PlannerError::written(target))?;
        let file = match input::append(&path) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => continue,
            file => file.map_err(PlannerError::written(&path))?,
        };
        match file.try_lock() {
            Ok(()) if is_at(&file, &path) => return Ok(file),
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(busy()),
            Err(TryLockError::Error(error)) => return Err(PlannerError::written(&path)(error)),
        }
    }
    Err(busy())
}

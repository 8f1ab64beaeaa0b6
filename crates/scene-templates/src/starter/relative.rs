//! Paths of files relative to each other.

use std::io;
use std::path::{Component, Path, PathBuf};

use scene::SceneError;

/// The path of a file as a scene names it: relative to the scene's folder, which need not be there yet.
///
/// # Errors
/// When the file is not there, or its path is not in UTF-8.
pub fn relative_path(file: &Path, scene: &Path) -> Result<String, SceneError> {
    let refuse = |error: io::Error| SceneError::about(file, format!("cannot be found: {error}"));
    let target = file.canonicalize().map_err(refuse)?;
    let scene = std::path::absolute(scene).map_err(refuse)?;
    let folder = physical(scene.parent().unwrap_or(&scene));
    let folder: Vec<Component> = folder.components().collect();
    let target: Vec<Component> = target.components().collect();
    let shared = folder.iter().zip(&target).take_while(|(one, other)| one == other).count();
    let path: PathBuf =
        folder[shared..].iter().map(|_| Component::ParentDir).chain(target[shared..].iter().copied()).collect();
    let path = path.to_str().ok_or_else(|| SceneError::about(file, "the name of this path is not in UTF-8"))?;
    Ok(path.to_owned())
}

/// An absolute path with the links of those folders resolved that are there.
fn physical(path: &Path) -> PathBuf {
    let existing = path.ancestors().find_map(|folder| Some((folder, folder.canonicalize().ok()?)));
    existing.map_or(path.to_owned(), |(folder, resolved)| match path.strip_prefix(folder) {
        Ok(rest) if rest.as_os_str().is_empty() => resolved,
        Ok(rest) => resolved.join(rest),
        Err(_) => path.to_owned(),
    })
}

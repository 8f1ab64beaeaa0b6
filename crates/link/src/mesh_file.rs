//! Files that models name.

use std::path::{Path, PathBuf};

use crate::element::Value;
use crate::error::ModelError;

/// The mesh file of a URI in a model file: a path relative to the model, or `model://` and `package://` with a path in
/// some folder above it.
///
/// # Errors
/// When the URI is of another kind, or no folder above the model has the file.
pub fn mesh_file(uri: &Value, model: &Path) -> Result<PathBuf, ModelError> {
    let folder = model.parent().unwrap_or(model);
    let Some((scheme, rest)) = uri.text.split_once("://") else {
        if uri.text.is_empty() {
            return Err(uri.refuse("must be a file"));
        }
        return Ok(folder.join(uri.text));
    };
    match scheme {
        "file" => Ok(folder.join(rest)),
        "model" | "package" => {
            let folder = std::path::absolute(folder).unwrap_or(folder.to_owned());
            let found = folder.ancestors().map(|above| above.join(rest)).find(|file| file.exists());
            found.ok_or_else(|| uri.refuse(&format!("is not found: no folder above {} has it", folder.display())))
        }
        _ => Err(uri.refuse("must be a file: download it and name it relative to this file")),
    }
}

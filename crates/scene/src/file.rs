//! Reading text files that people have written.

use std::io::ErrorKind;
use std::path::Path;

use crate::error::{SceneError, Source};

/// Largest file (bytes).
const LARGEST: u64 = 16 << 20;

/// Text of a TOML file. `what` names it in messages.
///
/// # Errors
/// As [`read_text`], and when the file is a mesh or a model by its name.
pub fn read_toml(file: &Path, what: &str) -> Result<String, SceneError> {
    match other_kind(file).filter(|_| file.is_file()) {
        Some(advice) => Err(SceneError::about(file, format!("the {what} cannot be read: {advice}"))),
        None => read_text(file, what),
    }
}

/// Text of a file in UTF-8. `what` names it in messages.
///
/// # Errors
/// When it is missing, a folder, too large, binary or not in UTF-8.
pub fn read_text(file: &Path, what: &str) -> Result<String, SceneError> {
    let refuse = |reason: &str| SceneError::about(file, format!("the {what} cannot be read: {reason}"));
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => refuse("there is no such file"),
        ErrorKind::IsADirectory => refuse("it is a folder; name a file"),
        ErrorKind::PermissionDenied => refuse("permission denied"),
        _ => refuse(&error.to_string()),
    };
    let bytes = input::read(file, LARGEST).map_err(failed)?;
    // UTF-16 has zeros as well, but gets a message about its encoding.
    let is_utf_16 = [[0xff, 0xfe], [0xfe, 0xff]].iter().any(|mark| bytes.starts_with(mark));
    if bytes.contains(&0) && !is_utf_16 {
        return Err(refuse("it is not a text file"));
    }
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes());
        let message = format!("the {what} is not in UTF-8 from here on: save it as UTF-8");
        Source { file, text: &text }.error(place..place + 1, message)
    })
}

/// Kind of a file that is neither scene nor homotopy by its name, and advice.
fn other_kind(file: &Path) -> Option<String> {
    let new = |part: &str| {
        let file = file.display();
        format!("it is a {part}; `assembly-plan new SCENE --body {file} --environment FILE` makes a scene with it")
    };
    match file.extension()?.to_str()?.to_lowercase().as_str() {
        "stl" | "obj" => Some(new("mesh")),
        "sdf" | "urdf" | "xml" | "mjcf" => Some(new("model")),
        "step" | "stp" => Some("it is a STEP file; scripts/lab step-to-obj makes meshes of it".to_owned()),
        _ => None,
    }
}

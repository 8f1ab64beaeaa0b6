//! Helpers of tests.

use std::path::{Path, PathBuf};

/// The file of the corner scene.
pub fn corner() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml")
}

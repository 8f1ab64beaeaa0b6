//! Scenes to start from load, and say what was asked for.

mod pegs;
mod starters;

use std::path::Path;

use scene::{Scene, SceneError, Source};

/// Reads a scene from text.
fn parse(text: &str) -> Result<Scene, SceneError> {
    Scene::parse(Source { file: Path::new("test.toml"), text })
}

//! What several tests share.

use std::path::{Path, PathBuf};

use scene::{Scene, SceneError, Source};

/// A small scene.
pub const SCENE: &str = r#"
[[body.part]]
name = "shaft"
box = [0.02, 0.02, 0.1]
[[environment.part]]
name = "wall"
box = [0.1, 0.1, 0.1]
position = [0.1, 0.0, 0.0]
[[start]]
name = "a"
position = [0, 0, 0.09]
orientation = [1, 0, 0, 0]
[goal]
position = [0, 0, 0]
orientation = [1, 0, 0, 0]
[impedance]
translational_stiffness = 50.0
rotational_stiffness = 5.0
[robustness]
offset_magnitude = 0.02
offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]
[horizon]
steps = 10
time_step = 0.04
"#;

/// Reads a scene from text.
pub fn parse(text: &str) -> Result<Scene, SceneError> {
    Scene::parse(Source { file: Path::new("test.toml"), text })
}

/// The small scene after a replacement.
pub fn replaced(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "{from}");
    SCENE.replacen(from, to, 1)
}

/// A folder of the project.
pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

/// Checks that an error has these words and stands in this line and column.
pub fn assert_place(error: &SceneError, words: &str, place: (usize, usize)) {
    assert!(error.message().contains(words), "{error}");
    assert_eq!((error.line(), error.column()), (Some(place.0), Some(place.1)), "{error}");
}

/// A diagonal apparent inertia as a scene gives it.
pub fn apparent_inertia(diagonal: [f64; 6]) -> String {
    let row =
        |row: usize| format!("{:?}", [0, 1, 2, 3, 4, 5].map(|column| if column == row { diagonal[row] } else { 0.0 }));
    format!("[{}]", [0, 1, 2, 3, 4, 5].map(row).join(", "))
}

//! What several tests share.

// Each test file uses some of it.

use std::path::Path;

use link::{LinkShape, Model, ModelError};
use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};

const FILE: &str = "folder/model.xml";

/// The shapes of the link of a name.
pub fn shapes(text: &str, name: &str) -> Result<Vec<LinkShape>, ModelError> {
    shapes_of_file(Path::new(FILE), text, name)
}

/// The shapes of the link of a name, of a model in this file.
pub fn shapes_of_file(file: &Path, text: &str, name: &str) -> Result<Vec<LinkShape>, ModelError> {
    let model = Model::parse(file, text)?;
    let links = model.links()?;
    links.iter().find(|link| link.name == name).unwrap_or_else(|| panic!("{name} in {text}")).shapes()
}

/// Names of the links with shapes.
pub fn names(text: &str) -> Vec<String> {
    let model = Model::parse(Path::new(FILE), text).unwrap();
    model.links().unwrap().into_iter().map(|link| link.name).collect()
}

/// Line, counted from one, and message of what is wrong with a link.
pub fn refusal(text: &str, name: &str) -> (usize, String) {
    let error = shapes(text, name).expect_err(text);
    (text[..error.span().start.min(text.len())].matches('\n').count() + 1, error.to_string())
}

/// Checks that a pose has this position and quaternion (w x y z).
pub fn assert_pose(pose: &Isometry3<f64>, position: [f64; 3], [w, x, y, z]: [f64; 4], name: &str) {
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
    let is_near = (pose.translation.vector - Vector3::from(position)).norm() < 1e-8;
    assert!(is_near && pose.rotation.angle_to(&rotation) < 1e-7, "{name}: {pose:?}");
}

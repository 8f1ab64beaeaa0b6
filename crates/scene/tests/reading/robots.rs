//! The arm that moves the body.

use scene::{Scene, SceneError, Source, default_homotopy, resolved};

use crate::support::{SCENE, apparent_inertia};

fn load(robot: &str) -> Result<Scene, SceneError> {
    Scene::parse(Source { file: "test.toml".as_ref(), text: &format!("{SCENE}[robot]\n{robot}\n") })
}

#[test]
fn an_apparent_inertia_replaces_that_of_the_body() {
    let rows = apparent_inertia([12.0, 7.0, 8.0, 1.5, 1.2, 0.8]).replacen("0.0, 0.0]", "0.0, 0.5]", 1);
    let rows = rows.replacen("[0.0, 0.0, 0.0, 0.0, 0.0, 0.8]", "[0.5, 0.0, 0.0, 0.0, 0.0, 0.8]", 1);
    let scene = load(&format!("apparent_inertia = {rows}")).unwrap();
    assert_eq!((scene.inertia.translational()[(0, 0)], scene.inertia.coupling()[(0, 2)]), (12.0, 0.5));
    assert_eq!(scene.inertia.mass(), None);
    // Critical damping follows.
    let stiffness = scene.impedance.translational_stiffness;
    let damping = scene.impedance.translational_damping[(1, 1)];
    assert!((damping - 2.0 * (7.0 * stiffness).sqrt()).abs() < 1e-9, "{damping}");
    let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
    let again = Scene::parse(Source { file: "resolved.toml".as_ref(), text: &text }).unwrap();
    assert_eq!((again.inertia, again.impedance), (scene.inertia, scene.impedance));
}

#[test]
fn an_apparent_inertia_that_is_none_is_refused() {
    let right = apparent_inertia([1.0; 6]);
    for (wrong, words) in [
        (right.replacen("[1.0, 0.0", "[1.0, 0.5", 1), "robot.apparent_inertia must be symmetric (kg, kg m, kg m^2)"),
        (apparent_inertia([1.0, 1.0, 0.0, 1.0, 1.0, 1.0]), "robot.apparent_inertia must be positive definite"),
        (apparent_inertia([1.0, 1.0, -1.0, 1.0, 1.0, 1.0]), "robot.apparent_inertia must be positive definite"),
        (right.replacen("1.0", "nan", 1), "robot.apparent_inertia: nan must lie between -1e6 and 1e6"),
        (
            "[1, 1, 1, 1, 1, 1]".to_owned(),
            "each row of robot.apparent_inertia must be a list of 6 numbers, not a number",
        ),
        ("[[1]]".to_owned(), "robot.apparent_inertia must have 6 rows, not 1"),
        ("5.0".to_owned(), "robot.apparent_inertia must be a list of 6 rows, not a number"),
    ] {
        let error = load(&format!("apparent_inertia = {wrong}")).unwrap_err();
        assert!(error.message().contains(words), "{error}");
    }
}

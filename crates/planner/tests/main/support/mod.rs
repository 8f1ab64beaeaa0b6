//! What tests share.

use std::path::{Path, PathBuf};

use planner::{Choices, Problem};

/// A box and a corner, moved by an arm with a time between two commands of its controller (s).
pub fn problem_of_arm(control_period: f64, choices: &Choices) -> Problem {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |file: &Path| std::fs::read_to_string(root.join(file)).unwrap();
    let arms = root.join("examples/arms");
    let robot = read(&arms.join("six.toml")).replace("six.urdf", arms.join("six.urdf").to_str().unwrap());
    let robot = robot.replace("control_period = 0.002", &format!("control_period = {control_period}"));
    // The arm has its own inertia and gains.
    let is_of_free_body =
        |line: &&str| ["mass", "inertia", "translational_s", "rotational_s"].iter().any(|key| line.starts_with(key));
    let corner = read(Path::new("scenes/corner.toml"));
    let kept: Vec<&str> = corner.lines().filter(|line| !is_of_free_body(line)).collect();
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("arm.toml");
    std::fs::write(&scene, format!("{}\n{robot}", kept.join("\n"))).unwrap();
    Problem::load(&scene, choices).unwrap()
}

//! A scene that is solved in an instant.

/// A small scene with every section, in which nothing is wrong.
pub const SMALL: &str = r#"title = "small"
[body]
mass = 1.0
inertia = [0.1, 0.1, 0.1]
[[body.part]]
name = "box"
box = [0.1, 0.08, 0.06]
[[environment.part]]
name = "floor"
box = [0.6, 0.6, 0.1]
position = [0.0, 0.0, -0.05]
[[environment.part]]
name = "wall"
vertices = [[-0.1, -0.3, 0], [0, -0.3, 0], [0, 0.3, 0], [-0.1, 0.3, 0], [0, 0, 0.4], [-0.1, 0, 0.4]]
[contact]
pairs = [["box", "floor"], ["box", "wall"]]
[[start]]
name = "a"
position = [0.1, 0.0, 0.08]
orientation = [1, 0, 0, 0]
[[start]]
name = "b"
position = [0.12, 0.0, 0.08]
orientation = [1, 0, 0, 0]
[goal]
position = [0.051, 0.0, 0.031]
orientation = [1, 0, 0, 0]
[impedance]
translational_stiffness = 50.0
rotational_stiffness = 5.0
[robustness]
offset_magnitude = 0.01
offset_directions = [[1, 0, 0], [0, 0, 1]]
[horizon]
steps = 5
time_step = 0.3
[cost]
reference = { translational_velocity = 1 }
[limits]
force = 100.0
[homotopy]
iterations = 1
tau = 0.0025
[ipopt]
tol = 1e-2
max_iter = 500
"#;

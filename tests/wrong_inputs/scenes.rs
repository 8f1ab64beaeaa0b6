//! Wrong scenes. `crates/scene` has a longer list; here are those that matter most, for every command.

use super::Edit;

/// A small scene with every section, in which nothing is wrong.
pub const RIGHT: &str = r#"title = "small"
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

const FILE: &str = "scene.toml";

#[rustfmt::skip]
pub const ROWS: &[(Edit, &str)] = &[
    ((FILE, "", ""), "scene.toml"),
    ((FILE, "", "\n\n"), "scene.toml"),
    ((FILE, "", "hello"), "scene.toml:1:"),
    ((FILE, "", "title = \"x\"\n"), "scene.toml"),
    ((FILE, "", "x_m,y_m,z_m\n0,0,0\n"), "scene.toml:1:"),
    ((FILE, "", "{\"title\": \"x\"}"), "scene.toml:1:"),
    ((FILE, "title = \"small\"", "title = \"\""), "scene.toml:1:9: title is empty"),
    ((FILE, "title = \"small\"", "titel = \"small\""), "did you mean `title`?"),
    ((FILE, "title = \"small\"", "title = \"a\\nb\""), "scene.toml:1:9: title must not contain line breaks"),
    ((FILE, "[body]", "[bodi]"), "did you mean `body`?"),
    ((FILE, "mass = 1.0", "mass = nan"), "scene.toml:3:8: body.mass = nan: must lie between"),
    ((FILE, "mass = 1.0", "mass = inf"), "body.mass = inf: must lie between"),
    ((FILE, "mass = 1.0", "mass = -1"), "body.mass = -1: must lie between"),
    ((FILE, "mass = 1.0", "mass = 0"), "body.mass = 0: must lie between"),
    ((FILE, "mass = 1.0", "mass = 1e300"), "body.mass = 1e300: must lie between"),
    ((FILE, "mass = 1.0", "mass = 1,5"), "decimals are written with a point"),
    ((FILE, "mass = 1.0", "mass = \"1\""), "must be a number, not text in quotes"),
    ((FILE, "mass = 1.0", "mass = 1.0\nmass = 2.0"), "`mass` is given twice"),
    ((FILE, "[0.1, 0.1, 0.1]", "[0.1, 0.1]"), "body.inertia must be 3 numbers or a 3x3 matrix"),
    ((FILE, "[0.1, 0.1, 0.1]", "[0.1, 0.1, -0.1]"), "body.inertia: -0.1 must lie between"),
    ((FILE, "[0.1, 0.1, 0.1]", "[[1, 2, 0], [2, 1, 0], [0, 0, 1]]"), "must be positive definite"),
    ((FILE, "[[body.part]]\nname = \"box\"\nbox = [0.1, 0.08, 0.06]\n", ""), "has no part"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "box = [0.1, 0.08]"), "body.part.box must have 3 numbers, not 2"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "box = [0.1, 0.08, 0.06, 0.1]"), "must have 3 numbers, not 4"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "box = [1e300, 0.08, 0.06]"), "1e300 must lie between"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "box = [0, 0.08, 0.06]"), "0 must lie between"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "mesh = \"gone.stl\"\nunit = \"mm\""), "gone.stl"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "mesh = \"folder\"\nunit = \"mm\""), "folder"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "mesh = \"scene.toml\"\nunit = \"mm\""), "scene.toml"),
    ((FILE, "box = [0.1, 0.08, 0.06]", "mesh = \"a.stl\""), "needs its `unit`"),
    ((FILE, "name = \"wall\"", "name = \"floor\""), "part name `floor` is used twice"),
    ((FILE, "vertices = [[-0.1, -0.3, 0], ", "vertices = [[nan, -0.3, 0], "), "nan must lie between"),
    ((FILE, ", [0, 0, 0.4], [-0.1, 0, 0.4]]", "]"), "the part is flat"),
    ((FILE, "[\"box\", \"wall\"]]", "[\"box\", \"wal\"]]"), "did you mean `wall`?"),
    ((FILE, "[[\"box\", \"floor\"], [\"box\", \"wall\"]]", "[]"), "pairs"),
    ((FILE, "[\"box\", \"wall\"]]", "[\"box\", \"floor\"]]"), "twice"),
    ((FILE, "[\"box\", \"wall\"]]", "[\"box\", \"floor\", \"wall\"]]"), "pairs"),
    ((FILE, "name = \"b\"", "name = \"a\""), "`a`"),
    ((FILE, "position = [0.1, 0.0, 0.08]\n", ""), "missing key `position`"),
    ((FILE, "position = [0.1, 0.0, 0.08]", "position = [0.1, 0.0, 0.08, 0.0]"), "must have 3 numbers, not 4"),
    ((FILE, "position = [0.1, 0.0, 0.08]", "position = [1e300, 0.0, 0.08]"), "1e300 must lie between"),
    ((FILE, "[goal]\nposition = [0.051, 0.0, 0.031]\norientation = [1, 0, 0, 0]", "[goal]\nposition = [0.051, 0.0, 0.031]\norientation = [5, 0, 0, 0]"), "norm"),
    ((FILE, "[goal]\nposition = [0.051, 0.0, 0.031]\norientation = [1, 0, 0, 0]", "[goal]\nposition = [0.051, 0.0, 0.031]\norientation = [1, 0, 0]"), "not 3"),
    ((FILE, "[goal]", "[gaol]"), "did you mean `goal`?"),
    ((FILE, "position = [0.051, 0.0, 0.031]", "position = [0.051, 0.0, nan]"), "nan must lie between"),
    ((FILE, "translational_stiffness = 50.0\n", ""), "missing key `translational_stiffness`"),
    ((FILE, "translational_stiffness = 50.0", "translational_stiffness = 0"), "must lie between"),
    ((FILE, "translational_stiffness = 50.0", "stiffness = 50.0"), "unknown key `stiffness`"),
    ((FILE, "offset_magnitude = 0.01", "offset_magnitude = -0.01"), "must lie between"),
    ((FILE, "offset_magnitude = 0.01", "offset_magnitude = 1e300"), "must lie between"),
    ((FILE, "[[1, 0, 0], [0, 0, 1]]", "[]"), "offset_directions"),
    ((FILE, "[[1, 0, 0], [0, 0, 1]]", "[[1, 1, 0]]"), "norm"),
    ((FILE, "[[1, 0, 0], [0, 0, 1]]", "[1, 0, 0]"), "offset_directions"),
    ((FILE, "steps = 5", "steps = 0"), "horizon.steps = 0: must lie between"),
    ((FILE, "steps = 5", "steps = -5"), "horizon.steps = -5: must lie between"),
    ((FILE, "steps = 5", "steps = 5.5"), "horizon.steps"),
    ((FILE, "steps = 5", "steps = 4294967295"), "must lie between"),
    ((FILE, "steps = 5", "steps = 99999999999999999999"), "must lie between"),
    ((FILE, "steps = 5\n", ""), "missing key `steps`"),
    ((FILE, "time_step = 0.3", "time_step = 0"), "horizon.time_step = 0: must lie between"),
    ((FILE, "time_step = 0.3", "time_step = 1e300"), "must lie between"),
    ((FILE, "{ translational_velocity = 1 }", "{ velocity = 1 }"), "unknown key `velocity`"),
    ((FILE, "{ translational_velocity = 1 }", "{ translational_velocity = -1 }"), "must lie between"),
    ((FILE, "force = 100.0", "force = 0"), "limits.force = 0: must lie between"),
    ((FILE, "force = 100.0", "translational_velocity = 0.001"), "allow more than"),
    ((FILE, "force = 100.0", "translational_acceleration = 1e-9"), "scene.toml"),
    ((FILE, "[homotopy]", "[homotopie]"), "did you mean `homotopy`?"),
    ((FILE, "iterations = 1", "iterations = 0"), "must lie"),
    ((FILE, "iterations = 1", "iterations = 4294967295"), "must lie"),
    ((FILE, "tau = 0.0025", "tau = nan"), "must lie"),
    ((FILE, "tau = 0.0025", "tau_rate = 1"), "tau_rate"),
    ((FILE, "tau = 0.0025", "hessian = \"none\""), "unknown value `none`"),
    ((FILE, "tau = 0.0025", "linear_solver = \"mump\""), "did you mean `mumps`?"),
    ((FILE, "max_iter = 500", "max_itr = 500"), "scene.toml:46:1:"),
    ((FILE, "max_iter = 500", "max_iter = \"many\""), "scene.toml:46:"),
    ((FILE, "max_iter = 500", "max_iter = -1"), "scene.toml:46:"),
    ((FILE, "max_iter = 500", "max_iter = 1.5"), "scene.toml:46:"),
    ((FILE, "tol = 1e-2", "tol = nan"), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "tol = inf"), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "tol = 0"), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "tol = \"\""), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "tol = [1]"), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "output_file = \"x\""), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "derivative_test = \"second-order\""), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "linear_solver = \"ma99\""), "scene.toml:45:"),
    ((FILE, "tol = 1e-2", "option_file_name = \"x\""), "scene.toml:45:"),
    ((FILE, "title = \"small\"", "title = \"small\"\nhomotopy = \"gone.toml\""), "homotopy"),
    ((FILE, "[homotopy]\niterations = 1\ntau = 0.0025\n[ipopt]\ntol = 1e-2\nmax_iter = 500\n", "[ipopt]\ntol = 1\n"), "homotopy"),
];

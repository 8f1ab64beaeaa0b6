//! Writes a scene and a homotopy into one file that reproduces a run.

use nalgebra::{Matrix3, SMatrix};
use task::{CostWeights, Coverage, HomotopySettings, Limits, Pose};
use toml::{Table, Value};

use crate::homotopy;
use crate::part::Part;
use crate::pose::StartPose;
use crate::robot::Robot;
use crate::scene::{RobustnessSpec, Scene};

/// Text of a scene file that contains all defaults, the given start and offset magnitude (m), meshes as halfspaces, and
/// the tables of the homotopy.
pub fn resolved(scene: &Scene, start: &StartPose, offset_magnitude: f64, homotopy: &HomotopySettings) -> String {
    let mut document = world(scene, start);
    merge(&mut document, settings(scene, offset_magnitude, homotopy));
    merge(&mut document, requirements(scene));
    text(&document)
}

/// The world, as text of tables of a scene file: shapes, start and goal.
pub fn resolved_world(scene: &Scene, start: &StartPose) -> String {
    text(&world(scene, start))
}

/// The settings of planning, as text of tables: inertia, impedance, friction, grasp errors, horizon, cost, limits,
/// homotopy, joints and controller of an arm.
pub fn resolved_settings(scene: &Scene, offset_magnitude: f64, homotopy: &HomotopySettings) -> String {
    text(&settings(scene, offset_magnitude, homotopy))
}

fn text(document: &Table) -> String {
    toml::to_string(document).expect("a table of plain values is valid TOML")
}

/// Adds the entries of a table to another, those of tables in both to each other.
fn merge(document: &mut Table, other: Table) {
    for (key, value) in other {
        match (document.get_mut(&key), value) {
            (Some(Value::Table(own)), Value::Table(value)) => merge(own, value),
            (_, value) => drop(document.insert(key, value)),
        }
    }
}

fn world(scene: &Scene, start: &StartPose) -> Table {
    let mut start_table = pose(&start.pose);
    start_table.insert("name".into(), start.name.clone().into());
    table([
        ("body", table([("part", parts(&scene.body))]).into()),
        ("environment", table([("part", parts(&scene.environment))]).into()),
        ("start", Value::Array(vec![start_table.into()])),
        ("goal", pose(&scene.goal).into()),
    ])
}

fn settings(scene: &Scene, offset_magnitude: f64, homotopy: &HomotopySettings) -> Table {
    let (homotopy, ipopt) = homotopy::tables(homotopy);
    let mut settings = table([
        (
            "impedance",
            table([
                ("translational_stiffness", scene.impedance.translational_stiffness.into()),
                ("rotational_stiffness", scene.impedance.rotational_stiffness.into()),
                ("translational_damping", shortest(&scene.impedance.translational_damping)),
                ("rotational_damping", axes_or_rows(&scene.impedance.rotational_damping)),
            ])
            .into(),
        ),
        ("robustness", grasp_errors(scene, offset_magnitude).into()),
        (
            "horizon",
            table([
                ("steps", Value::Integer(scene.horizon.steps as i64)),
                ("time_step", scene.horizon.time_step.into()),
            ])
            .into(),
        ),
        (
            "cost",
            table([
                ("reference", weights(&scene.cost.reference).into()),
                ("compliant", weights(&scene.cost.compliant).into()),
            ])
            .into(),
        ),
        ("homotopy", homotopy.into()),
        ("ipopt", ipopt.into()),
    ]);
    if scene.frictions != [0.0] {
        settings.insert("contact".into(), table([("friction", numbers(&scene.frictions))]).into());
    }
    let mass = scene.inertia.mass();
    if let Some(mass) = mass {
        let body = table([("mass", mass.into()), ("inertia", rows(&scene.inertia.rotational()))]);
        settings.insert("body".into(), body.into());
    }
    let mut robot = scene.robot.as_ref().map_or(Table::new(), joints);
    if mass.is_none() || scene.robot.is_some() {
        robot.insert("apparent_inertia".into(), rows(scene.inertia.matrix()));
    }
    if !robot.is_empty() {
        settings.insert("robot".into(), robot.into());
    }
    if scene.limits != Limits::NONE {
        settings.insert("limits".into(), limits(&scene.limits).into());
    }
    settings
}

/// The rest: what is left out, what counts as success, what a robust plan must tolerate, and where the arm stands.
fn requirements(scene: &Scene) -> Table {
    let pairs = scene
        .pairs
        .iter()
        .map(|&(part, other)| vec![scene.body[part].name.clone(), scene.environment[other].name.clone()].into());
    let mut requirements = table([
        ("title", scene.title.clone().into()),
        ("contact", table([("pairs", Value::Array(pairs.collect()))]).into()),
        ("goal", tolerances(scene).into()),
        ("robustness", robustness_spec(&scene.robustness).into()),
    ]);
    if !scene.gripper.is_empty() {
        requirements.insert("gripper".into(), table([("part", parts(&scene.gripper))]).into());
    }
    requirements.extend(scene.robot.as_ref().map(|robot| ("robot".to_owned(), arm(robot).into())));
    requirements
}

/// The planned offsets and rotation errors.
fn grasp_errors(scene: &Scene, offset_magnitude: f64) -> Table {
    let mut errors = table([("offset_magnitude", offset_magnitude.into())]);
    match &scene.coverage {
        Coverage::Hull => {
            let directions = Value::Array(scene.offset_directions.iter().map(numbers).collect());
            errors.insert("offset_directions".into(), directions);
        }
        // The directions follow from the axis.
        Coverage::Disc { axis } => {
            errors.extend(table([("coverage", "disc".into()), ("insertion_axis", numbers(axis))]));
        }
        Coverage::Ball => errors.extend(table([("coverage", "ball".into())])),
    }
    if scene.has_rotated_scenarios() {
        let axes = Value::Array(scene.rotation_axes.iter().map(numbers).collect());
        errors.extend(table([("rotation_error", scene.robustness.rotation_error.into()), ("rotation_axes", axes)]));
    }
    errors
}

/// The robustness specification.
fn robustness_spec(spec: &RobustnessSpec) -> Table {
    let mut table = table([
        ("friction", numbers(&spec.frictions)),
        ("rotation_error", spec.rotation_error.into()),
        ("inertia_error", spec.inertia_error.into()),
        ("stiffness_error", spec.stiffness_error.into()),
        ("delay", spec.delay.into()),
    ]);
    table.extend(spec.edge_radius.map(|error| ("edge_radius".to_owned(), error.into())));
    table
}

fn table<const N: usize>(entries: [(&str, Value); N]) -> Table {
    entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

fn numbers<'number>(numbers: impl IntoIterator<Item = &'number f64>) -> Value {
    Value::Array(numbers.into_iter().map(|&number| Value::Float(number)).collect())
}

fn rows<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Value {
    Value::Array(matrix.row_iter().map(|row| numbers(row.iter())).collect())
}

/// The diagonal, or the rows of a matrix that has more.
fn axes_or_rows(matrix: &Matrix3<f64>) -> Value {
    let diagonal = matrix.diagonal();
    if *matrix == Matrix3::from_diagonal(&diagonal) { numbers(&diagonal) } else { rows(matrix) }
}

/// One number for the same along every axis.
fn shortest(matrix: &Matrix3<f64>) -> Value {
    let first = matrix[(0, 0)];
    if *matrix == Matrix3::from_diagonal_element(first) { first.into() } else { axes_or_rows(matrix) }
}

fn pose(pose: &Pose) -> Table {
    table([("position", numbers(&pose[..3])), ("orientation", numbers(&pose[3..]))])
}

/// The arm, with the path of its file as it was found and the joint positions at the goal.
fn arm(robot: &Robot) -> Table {
    let joints = robot.arm.joints().len();
    table([
        ("urdf", robot.urdf.to_string_lossy().into_owned().into()),
        ("tip", robot.tip.clone().into()),
        ("grasp", pose(&robot.grasp).into()),
        ("base", pose(&robot.base).into()),
        ("configuration", numbers(robot.configuration.iter().take(joints))),
        ("rotor_inertia", numbers(&robot.rotor_inertia())),
    ])
}

/// Inertia and friction of the arm's joints besides the model of its file.
fn joints(robot: &Robot) -> Table {
    table([("joint_friction", numbers(&robot.joint_friction)), ("control_period", robot.control_period.into())])
}

fn tolerances(scene: &Scene) -> Table {
    let mut table = table([("angle_tolerance", scene.angle_tolerance.into())]);
    table.extend(scene.position_tolerance.map(|tolerance| ("position_tolerance".to_owned(), tolerance.into())));
    table
}

fn parts(parts: &[Part]) -> Value {
    let part = |part: &Part| {
        Value::Table(table([
            ("name", part.name.clone().into()),
            ("normals", Value::Array(part.shape.normals().iter().map(numbers).collect())),
            ("offsets", numbers(part.shape.offsets())),
        ]))
    };
    Value::Array(parts.iter().map(part).collect())
}

fn limits(limits: &Limits) -> Table {
    let given = limits.named().into_iter().filter(|(_, _, limit)| limit.is_finite());
    given.map(|(name, _, limit)| (name.to_owned(), limit.into())).collect()
}

fn weights(weights: &CostWeights) -> Table {
    table([
        ("translational_velocity", weights.translational_velocity.into()),
        ("rotational_velocity", weights.rotational_velocity.into()),
        ("terminal_position", weights.terminal_position.into()),
        ("terminal_orientation", weights.terminal_orientation.into()),
    ])
}

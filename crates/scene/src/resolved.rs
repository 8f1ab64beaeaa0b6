//! Writes a scene and a homotopy into one file that reproduces a run.

use admittance::{ForceMode, PositionRobot};
use nalgebra::{Matrix3, SMatrix};
use task::{CostWeights, Coverage, HomotopySettings, Impedance, Limits, Pose};
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
        ("impedance", impedance(scene).into()),
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
    if let Some(position_robot) = &scene.position_robot {
        robot.extend(position(position_robot));
    } else if mass.is_none() || scene.robot.is_some() {
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

/// The controller. A force mode states its damping by its gains.
fn impedance(scene: &Scene) -> Table {
    let Impedance { translational_stiffness, rotational_stiffness, translational_damping, rotational_damping } =
        &scene.impedance;
    let mut entries = table([
        ("translational_stiffness", (*translational_stiffness).into()),
        ("rotational_stiffness", (*rotational_stiffness).into()),
    ]);
    if scene.position_robot.as_ref().is_none_or(|robot| robot.force_mode.is_none()) {
        entries.extend(table([
            ("translational_damping", shortest(translational_damping)),
            ("rotational_damping", axes_or_rows(rotational_damping)),
        ]));
    }
    entries
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
    if spec.bias != [0.0; 2] {
        table.extend([("force_bias".to_owned(), spec.bias[0].into()), ("torque_bias".to_owned(), spec.bias[1].into())]);
    }
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

/// What a robot without a torque interface is like.
fn position(robot: &PositionRobot) -> Table {
    let pair =
        |names: [&str; 2], [first, second]: [f64; 2]| table([(names[0], first.into()), (names[1], second.into())]);
    let PositionRobot { gains, limits, sensor, .. } = robot;
    let mut command = pair(["translational_velocity", "rotational_velocity"], limits.speed);
    command.extend(pair(["translational_acceleration", "rotational_acceleration"], limits.acceleration));
    let mut measured = table([("cutoff", sensor.cutoff.into())]);
    measured.extend(pair(["force_noise", "torque_noise"], sensor.noise));
    measured.extend(pair(["force_resolution", "torque_resolution"], sensor.resolution));
    let mut entries = table([
        ("control_period", robot.period.into()),
        ("delay", robot.delay.into()),
        ("bandwidth", robot.bandwidth.into()),
        ("contact_stiffness", robot.contact_stiffness.into()),
        ("command", command.into()),
        ("sensor", measured.into()),
    ]);
    match robot.force_mode {
        None => {
            entries.insert("interface".into(), "position".into());
            entries.extend(pair(["virtual_mass", "virtual_inertia"], gains.mass));
        }
        Some(ForceMode { gain, deadband }) => {
            let mut mode = pair(["translational_gain", "rotational_gain"], gain);
            mode.extend(pair(["force_deadband", "torque_deadband"], deadband));
            entries.extend([("interface".to_owned(), "force".into()), ("force_mode".to_owned(), mode.into())]);
        }
    }
    entries
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

//! Writes a scene and a homotopy into one file that reproduces a run.

use nalgebra::{Matrix3, SMatrix};
use task::{CostWeights, Coverage, HomotopySettings, Limits};
use toml::{Table, Value};

use crate::homotopy;
use crate::part::Part;
use crate::pose::StartPose;
use crate::robot::Robot;
use crate::scene::Scene;

/// Text of a scene file that contains all defaults, the given start and offset magnitude (m), meshes as halfspaces, and
/// the tables of the homotopy.
pub fn resolved(scene: &Scene, start: &StartPose, offset_magnitude: f64, homotopy: &HomotopySettings) -> String {
    let (homotopy, ipopt) = homotopy::tables(homotopy);
    let mut body = table([("part", parts(&scene.body))]);
    let mass = scene.inertia.mass();
    if let Some(mass) = mass {
        body.extend(table([("mass", mass.into()), ("inertia", rows(&scene.inertia.rotational()))]));
    }
    let pairs = scene
        .pairs
        .iter()
        .map(|&(part, other)| vec![scene.body[part].name.clone(), scene.environment[other].name.clone()].into());
    let mut contact = table([("pairs", Value::Array(pairs.collect()))]);
    if scene.frictions != [0.0] {
        contact.insert("friction".into(), numbers(&scene.frictions));
    }
    let mut start_table = pose(&start.pose);
    start_table.insert("name".into(), start.name.clone().into());
    let mut document = table([
        ("title", scene.title.clone().into()),
        ("body", body.into()),
        ("environment", table([("part", parts(&scene.environment))]).into()),
        ("contact", contact.into()),
        ("start", Value::Array(vec![start_table.into()])),
        ("goal", goal(scene).into()),
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
        ("robustness", robustness(scene, offset_magnitude).into()),
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
    let mut robot = scene.robot.as_ref().map_or(Table::new(), arm);
    if mass.is_none() || scene.robot.is_some() {
        robot.insert("apparent_inertia".into(), rows(scene.inertia.matrix()));
    }
    if !scene.gripper.is_empty() {
        document.insert("gripper".into(), table([("part", parts(&scene.gripper))]).into());
    }
    if !robot.is_empty() {
        document.insert("robot".into(), robot.into());
    }
    if scene.limits != Limits::NONE {
        document.insert("limits".into(), limits(&scene.limits).into());
    }
    toml::to_string(&document).expect("a table of plain values is valid TOML")
}

/// The offsets that are planned for, and what a robust plan must bear.
fn robustness(scene: &Scene, offset_magnitude: f64) -> Table {
    let mut robustness = table([
        ("offset_magnitude", offset_magnitude.into()),
        ("friction", numbers(&scene.borne.frictions)),
        ("turn", scene.borne.turn.into()),
        ("inertia_error", scene.borne.inertia_error.into()),
        ("stiffness_error", scene.borne.stiffness_error.into()),
        ("delay", scene.borne.delay.into()),
    ]);
    match &scene.coverage {
        Coverage::Hull => {
            let directions = Value::Array(scene.offset_directions.iter().map(numbers).collect());
            robustness.insert("offset_directions".into(), directions);
        }
        // The directions follow from the axis.
        Coverage::Disc { axis } => {
            robustness.extend(table([("coverage", "disc".into()), ("insertion_axis", numbers(axis))]));
        }
        Coverage::Ball => robustness.extend(table([("coverage", "ball".into())])),
    }
    if scene.has_turned_scenarios() {
        robustness.insert("turn_axes".into(), Value::Array(scene.turn_axes.iter().map(numbers).collect()));
    }
    robustness.extend(scene.borne.edge_radius.map(|error| ("edge_radius".to_owned(), error.into())));
    robustness
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

fn pose(pose: &[f64; 7]) -> Table {
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
        ("joint_friction", numbers(&robot.joint_friction)),
        ("control_period", robot.control_period.into()),
    ])
}

fn goal(scene: &Scene) -> Table {
    let mut table = pose(&scene.goal);
    table.extend(scene.position_tolerance.map(|tolerance| ("position_tolerance".to_owned(), tolerance.into())));
    table.insert("angle_tolerance".into(), scene.angle_tolerance.into());
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

//! The README of an export: the text of its target with the numbers of a plan.

use crate::document::{ArmRecord, Document};
use crate::target::Target;

/// Parts of the text that several targets have, by their names.
const PARTS: [(&str, &str); 5] = [
    ("frames", include_str!("../players/shared/frames.md")),
    ("guards", include_str!("../players/shared/guards.md")),
    ("player", include_str!("../players/shared/player.md")),
    ("safety", include_str!("../players/shared/safety.md")),
    ("flags", include_str!("../players/shared/flags.md")),
];

/// The text for a plan.
pub fn readme(document: &Document, target: Target) -> String {
    let with_parts = PARTS.iter().fold(target.readme().to_owned(), |text, (name, part)| {
        text.replace(&format!("{{{{{name}}}}}\n"), &format!("{part}\n"))
    });
    numbers(document)
        .into_iter()
        .fold(with_parts, |text, (name, value)| text.replace(&format!("{{{{{name}}}}}"), &value))
}

fn numbers(document: &Document) -> Vec<(&'static str, String)> {
    let Document { impedance, expected, guards, arm, .. } = document;
    let frame = match document.arm {
        Some(_) => "the robot's base",
        None => "the world of the scene, as the scene names no arm",
    };
    vec![
        ("scene", document.scene.clone()),
        ("start", document.start.clone()),
        ("offset_mm", short(1e3 * document.delta_m)),
        ("rate", short(document.rate_hz)),
        ("frame", frame.to_owned()),
        ("base", pose(&document.base)),
        ("grasp", pose(&document.grasp)),
        (
            "tip",
            arm.as_ref().map_or("the part itself".to_owned(), |arm| format!("link `{}` of `{}`", arm.tip, arm.urdf)),
        ),
        ("configuration", arm.as_ref().map_or("unknown".to_owned(), configuration)),
        ("stiffness", short(impedance.translational_stiffness)),
        ("turning_stiffness", short(impedance.rotational_stiffness)),
        ("tool_stiffness", matrix(&document.tool_stiffness)),
        ("tool_damping", matrix(&document.tool_damping)),
        ("expected_force", short(expected.force_n)),
        ("expected_torque", short(expected.torque_nm)),
        ("expected_contact", short(expected.contact_force_n)),
        ("expected_deviation_mm", short(1e3 * expected.deviation_m)),
        ("expected_deviation_rad", short(expected.deviation_rad)),
        ("guard_force", short(guards.force_n)),
        ("guard_torque", short(guards.torque_nm)),
        ("guard_deviation_mm", short(1e3 * guards.deviation_m)),
        ("guard_deviation_rad", short(guards.deviation_rad)),
    ]
}

fn configuration(arm: &ArmRecord) -> String {
    let joints = arm.joints.iter().zip(&arm.start_configuration);
    joints.map(|(joint, position)| format!("`{}` {position:.4}", joint.name)).collect::<Vec<_>>().join(", ")
}

fn pose([x, y, z, qw, qx, qy, qz]: &[f64; 7]) -> String {
    format!("({x:.4}, {y:.4}, {z:.4}) m, quaternion (w x y z) ({qw:.4}, {qx:.4}, {qy:.4}, {qz:.4})")
}

fn matrix(rows: &[[f64; 6]; 6]) -> String {
    let line = |row: &[f64; 6]| row.iter().map(|value| format!("{value:10.2}")).collect::<String>();
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}

/// A number with three significant digits, without an exponent.
fn short(value: f64) -> String {
    let decimals = match value.abs() {
        size if size >= 100.0 || size == 0.0 => 0,
        size if size >= 10.0 => 1,
        size if size >= 1.0 => 2,
        _ => 3,
    };
    format!("{value:.decimals$}")
}

//! `plan.script`: a controller in URScript with the reference in it.

use simulation::{Knot, Reference};

use crate::document::{ArmRecord, Document};
use crate::frames::Frames;

/// Torques (Nm) of joints for which the URDF file has no limit.
const UNLIMITED: f64 = 1e3;

/// The script of a plan.
pub fn script(document: &Document, arm: &ArmRecord, reference: &Reference, frames: &Frames) -> String {
    let states: Vec<_> = knots(reference).map(|knot| frames.tool_state(&knot)).collect();
    let pose = |state: &crate::ToolState| [state.pose.translation.vector, state.pose.rotation.scaled_axis()];
    let poses: Vec<Vec<f64>> = states.iter().map(|state| flat(&pose(state))).collect();
    let twists: Vec<Vec<f64>> =
        states[1..].iter().map(|state| flat(&[state.velocity, state.angular_velocity])).collect();
    let way = states[0].pose.translation.vector - states[states.len() - 1].pose.translation.vector;
    let way_out = way.try_normalize(f64::EPSILON).unwrap_or_default();
    let torques: Vec<f64> = arm.joints.iter().map(|joint| joint.torque.unwrap_or(UNLIMITED)).collect();
    let guards = &document.guards;
    let values = [
        ("scene", document.scene.clone()),
        ("start", document.start.clone()),
        ("guard_force", number(guards.force_n)),
        ("guard_torque", number(guards.torque_nm)),
        ("guard_deviation", number(guards.deviation_m)),
        ("guard_turn", number(guards.deviation_rad)),
        ("time_step", number(reference.time_step())),
        ("last", reference.intervals().to_string()),
        ("knots", rows(&poses)),
        ("twists", rows(&twists)),
        ("way_out", list(way_out.as_slice())),
        ("start_configuration", list(&arm.start_configuration)),
        ("joint_torques", list(&torques)),
        ("wrench", wrench(&document.tool_stiffness, &document.tool_damping)),
    ];
    let template = include_str!("../players/urscript/plan.script").to_owned();
    values.iter().fold(template, |text, (name, value)| text.replace(&format!("{{{{{name}}}}}"), value))
}

/// All knots of a reference, each with the twist on the way to it.
fn knots(reference: &Reference) -> impl Iterator<Item = Knot> {
    let first = std::iter::once(reference.at(0, 0.0));
    first.chain((0..reference.intervals()).map(|interval| reference.at(interval, 1.0)))
}

fn flat(vectors: &[nalgebra::Vector3<f64>; 2]) -> Vec<f64> {
    vectors.iter().flat_map(|vector| vector.iter().copied()).collect()
}

/// The components of the wrench from the errors `e` and `d` of pose and twist.
fn wrench(stiffness: &[[f64; 6]; 6], damping: &[[f64; 6]; 6]) -> String {
    let term = |gains: &[f64; 6], name: &str, factor: &str| {
        let products = gains.iter().enumerate().filter(|(_, gain)| **gain != 0.0);
        let sum: Vec<String> = products.map(|(index, gain)| format!("{} * {name}[{index}]", number(*gain))).collect();
        format!("{factor} * ({})", if sum.is_empty() { "0.0".to_owned() } else { sum.join(" + ") })
    };
    let row = |index: usize| {
        let (spring, damper) =
            (term(&stiffness[index], "e", "stiffness_factor"), term(&damping[index], "d", "damping_factor"));
        format!("    w{index} = {spring} + {damper}")
    };
    (0..6).map(row).collect::<Vec<_>>().join("\n")
}

fn rows(rows: &[Vec<f64>]) -> String {
    rows.iter().map(|row| format!("    {}", list(row))).collect::<Vec<_>>().join(",\n")
}

fn list(numbers: &[f64]) -> String {
    format!("[{}]", numbers.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "))
}

/// A number without an exponent, to a millionth of a millimetre.
fn number(value: f64) -> String {
    format!("{:.9}", value + 0.0)
}

//! `plan.script`: a controller in URScript with the reference in it.

use crate::arm_room::ArmStart;
use crate::document::{ArmRecord, Document, JointRecord};
use crate::expectation::Guards;
use crate::frames::{Frames, ToolState};
use crate::smooth::SmoothReference;
use crate::text::filled;

/// Torques (Nm) of joints for which the URDF file has no limit.
const UNLIMITED: f64 = 1e3;

/// Limits (rad, rad/s) of joints for which the URDF file has none.
const ANYWHERE: f64 = 1e3;

/// Where nothing is known of the shapes of its links, no point of the arm may be this far (m) from where it is at the start.
const FARTHEST_ARM: f64 = 0.3;

/// What a script sends to the robot: the words of its heading, its settings, and its thread with the function that sets a command.
struct Control {
    needs: &'static str,
    settings: &'static str,
    functions: &'static str,
    /// On the damping of the plan.
    damping_factor: &'static str,
}

/// Joint torques.
const TORQUE: Control = Control {
    needs: "It sends joint torques, with `direct_torque` and `get_jacobian`: PolyScope 5.26 or newer.",
    settings: include_str!("../players/urscript/torque_settings.script"),
    functions: include_str!("../players/urscript/torque.script"),
    damping_factor: "damping_factor",
};

/// The wrench of force mode.
const FORCE: Control = Control {
    needs: "It sends wrenches to force mode: a robot of the e-Series.",
    settings: include_str!("../players/urscript/force_settings.script"),
    functions: include_str!("../players/urscript/force.script"),
    damping_factor: "1.0",
};

impl Control {
    /// The one that a plan was made for.
    fn of(document: &Document) -> Self {
        if document.admittance.is_some() { FORCE } else { TORQUE }
    }
}

/// What the script of a plan sends, and what it needs.
pub fn needs(document: &Document) -> &'static str {
    Control::of(document).needs
}

/// The script of a plan: in force mode if the plan was made for that, else in joint torques.
pub fn script(document: &Document, arm: &ArmRecord, reference: &SmoothReference, frames: &Frames) -> String {
    let states: Vec<_> = reference.knots().iter().map(|knot| frames.tool_state(knot)).collect();
    let pose = |state: &ToolState| [state.pose.translation.vector, state.pose.rotation.scaled_axis()];
    let poses: Vec<Vec<f64>> = states.iter().map(|state| flat(&pose(state))).collect();
    let twists: Vec<Vec<f64>> = states.iter().map(|state| flat(&[state.velocity, state.angular_velocity])).collect();
    let way = states[0].pose.translation.vector - states[states.len() - 1].pose.translation.vector;
    let way_out = way.try_normalize(f64::EPSILON).unwrap_or_default();
    let of_joints = |limit: fn(&JointRecord) -> f64| list(&arm.joints.iter().map(limit).collect::<Vec<_>>());
    let limits = |guards: &Guards| list(&[guards.force_n, guards.torque_nm, guards.deviation_m, guards.deviation_rad]);
    let (guards, free) = (&document.guards, &document.free);
    let Control { needs, settings, functions, damping_factor } = Control::of(document);
    let heights = |end: usize| list_of(&free.heights_m, end);
    let values = [
        ("scene", document.scene.clone()),
        ("start", document.start.clone()),
        ("warnings", document.warnings.iter().map(|warning| message(warning)).collect::<Vec<_>>().join("\n")),
        ("approach_limits", limits(&guards.approach)),
        ("dry_run_limits", limits(&guards.dry_run)),
        ("insertion_limits", limits(&guards.insertion)),
        ("time_step", number(reference.time_step())),
        ("last", (states.len() - 1).to_string()),
        ("knots", rows(&poses)),
        ("twists", rows(&twists)),
        ("way_out", list(way_out.as_slice())),
        ("start_configuration", list(&arm.start_configuration)),
        ("joint_torques", of_joints(|joint| joint.torque.unwrap_or(UNLIMITED))),
        ("joint_lower", of_joints(|joint| joint.lower.unwrap_or(-ANYWHERE))),
        ("joint_upper", of_joints(|joint| joint.upper.unwrap_or(ANYWHERE))),
        ("joint_speeds", of_joints(|joint| joint.speed.unwrap_or(ANYWHERE))),
        ("free_from", heights(0)),
        ("free_to", heights(1)),
        ("free_count", free.heights_m.len().to_string()),
        ("clearance_heights", list_of(&free.start_clearance_m, 0)),
        ("clearances", list_of(&free.start_clearance_m, 1)),
        ("clearance_count", free.start_clearance_m.len().to_string()),
        ("part_radius", number(free.radius_m)),
        ("arm_heights", list(&free.arm_starts.iter().map(|start| start.height_m).collect::<Vec<_>>())),
        ("arm_joints", rows(&free.arm_starts.iter().map(|start| start.configuration.clone()).collect::<Vec<_>>())),
        ("arm_reaches", rows(&free.arm_starts.iter().map(|start| start.reach_m.clone()).collect::<Vec<_>>())),
        ("arm_clearances", list(&free.arm_starts.iter().map(clearance).collect::<Vec<_>>())),
        ("test_is_free", flags(free.arm_starts.iter().map(|start| start.test_is_free))),
        ("arm_count", free.arm_starts.len().to_string()),
        ("wrench", wrench(&document.tool_stiffness, &document.tool_damping, damping_factor)),
    ];
    let template = include_str!("../players/urscript/plan.script")
        .replace("{{needs}}", needs)
        .replace("{{control_settings}}\n", settings)
        .replace("{{control}}", functions);
    filled(&template, &values)
}

/// How far links and gripper may move (m).
fn clearance(start: &ArmStart) -> f64 {
    start.clearance_m.unwrap_or(FARTHEST_ARM)
}

fn flags(flags: impl Iterator<Item = bool>) -> String {
    let words: Vec<&str> = flags.map(|flag| if flag { "True" } else { "False" }).collect();
    format!("[{}]", words.join(", "))
}

/// One number of every pair; a list is never empty.
fn list_of(pairs: &[[f64; 2]], index: usize) -> String {
    let numbers: Vec<f64> = pairs.iter().map(|pair| pair[index]).collect();
    list(if numbers.is_empty() { &[0.0] } else { &numbers })
}

/// A line that shows a message to the user.
fn message(text: &str) -> String {
    let quoted: String = text.chars().filter(|letter| letter.is_ascii() && !matches!(letter, '"' | '\\')).collect();
    format!("  textmsg(\"warning: {quoted}\")")
}

fn flat(vectors: &[nalgebra::Vector3<f64>; 2]) -> Vec<f64> {
    vectors.iter().flat_map(|vector| vector.iter().copied()).collect()
}

/// The components of the wrench from the errors `e` and `d` of pose and twist.
fn wrench(stiffness: &[[f64; 6]; 6], damping: &[[f64; 6]; 6], damping_factor: &str) -> String {
    let term = |gains: &[f64; 6], name: &str, factor: &str| {
        let products = gains.iter().enumerate().filter(|(_, gain)| **gain != 0.0);
        let sum: Vec<String> = products.map(|(index, gain)| format!("{} * {name}[{index}]", number(*gain))).collect();
        format!("{factor} * ({})", if sum.is_empty() { "0.0".to_owned() } else { sum.join(" + ") })
    };
    let row = |index: usize| {
        let (spring, damper) =
            (term(&stiffness[index], "e", "stiffness_factor"), term(&damping[index], "d", damping_factor));
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

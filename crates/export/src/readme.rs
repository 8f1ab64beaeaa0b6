//! The README of an export: the text of its target with the numbers of a plan.

use plan::records::AdmittanceRecord;
use task::Pose;

use crate::document::{ArmRecord, Document};
use crate::expectation::Guards;
use crate::target::Target;
use crate::text::filled;
use crate::trial::RateRecord;
use crate::urscript::needs;

/// Parts of the text that several targets have, by their names.
const PARTS: [(&str, &str); 6] = [
    ("quality", include_str!("../players/shared/quality.md")),
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
    filled(&with_parts, &numbers(document))
}

fn numbers(document: &Document) -> Vec<(&'static str, String)> {
    let Document { impedance, expected, guards, arm, free, .. } = document;
    let guard = |value: fn(&Guards) -> f64| {
        [&guards.approach, &guards.dry_run, &guards.insertion].map(|guards| short(value(guards))).join(" | ")
    };
    let frame = match document.arm {
        Some(_) => "the robot's base",
        None => "the world of the scene, as the scene names no arm",
    };
    vec![
        ("scene", document.scene.clone()),
        ("start", document.start.clone()),
        ("coverage", document.coverage.to_string()),
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
        ("held_mm", short(1e3 * expected.held_m)),
        ("held_rad", short(expected.held_rad)),
        ("guard_force", guard(|guards| guards.force_n)),
        ("guard_torque", guard(|guards| guards.torque_nm)),
        ("guard_deviation_mm", guard(|guards| 1e3 * guards.deviation_m)),
        ("guard_deviation_rad", guard(|guards| guards.deviation_rad)),
        ("torque_step", document.torque_step_nm_per_ms.map_or("unknown".to_owned(), short)),
        ("quality_words", quality(document)),
        ("rates", document.trial.rates.iter().map(rate).collect::<Vec<_>>().join("\n")),
        ("trial_force", force(document)),
        ("dry_run", free.height().map_or("M".to_owned(), |height| format!("{height:.3}"))),
        ("free_words", free_in_words(document)),
        ("admittance", admittance(document)),
        ("needs", needs(document).to_owned()),
        ("arm_words", arm_in_words(document).to_owned()),
    ]
}

/// The admittance law in words.
fn admittance(document: &Document) -> String {
    let Some(AdmittanceRecord { mass, damping, stiffness, period_s, lag_s, contact_stiffness_n_m, .. }) =
        &document.admittance
    else {
        return "none, as the plan is for a robot with a torque interface".to_owned();
    };
    format!(
        "`M a + D (v - v_r) + K (x - x_r) = F` at the part, every {} ms, with M = {} kg and {} kg m^2, D = {} Ns/m and {} Nms/rad, K = {} \
         N/m and {} Nm/rad; stable against contacts of up to {} N/m with a lag of {} ms",
        short(1e3 * period_s),
        short(mass[0]),
        short(mass[1]),
        short(damping[0]),
        short(damping[1]),
        short(stiffness[0]),
        short(stiffness[1]),
        short(*contact_stiffness_n_m),
        short(1e3 * lag_s)
    )
}

/// Whether the plan may be played.
fn quality(document: &Document) -> String {
    match document.warnings.as_slice() {
        [] => "The plan is done, and so it does in rollouts with hard contact:".to_owned(),
        warnings => {
            let lines: Vec<String> = warnings.iter().map(|warning| format!("- **Warning: {warning}.**")).collect();
            format!("Status: {}.\n\n{}\n\nIn rollouts with hard contact:", document.status, lines.join("\n"))
        }
    }
}

fn rate(rate: &RateRecord) -> String {
    let [low, high] = rate.interval.map(|bound| 100.0 * bound);
    let RateRecord { friction, magnitude_m, turn_rad, rollouts, successes, .. } = rate;
    let millimetres = short(1e3 * magnitude_m);
    format!("| {friction} | {millimetres} | {turn_rad} | {successes} of {rollouts} | {low:.0} to {high:.0} % |")
}

fn force(document: &Document) -> String {
    let limit = document.trial.contact_force_limit_n;
    let limit =
        limit.map_or("without a limit".to_owned(), |limit| format!("of {} N that the scene allows", short(limit)));
    format!("{} N, {limit}", short(document.trial.contact_force_n))
}

/// Where dry runs may be.
fn free_in_words(document: &Document) -> String {
    let intervals = document.free.heights_m.iter().map(|[low, high]| format!("{low:.3} to {high:.3} m"));
    match intervals.collect::<Vec<_>>() {
        none if none.is_empty() => {
            "There is no height at which the shifted reference is in free air and the arm can move: a dry run needs room, \
             so take the environment away."
                .to_owned()
        }
        intervals => format!(
            "A dry run is in free air at heights of {}, and the player refuses others; {} mm are then free around the part, \
             wherever it sits in the gripper within the offsets of the plan.",
            intervals.join(" and "),
            short(5.0)
        ),
    }
}

/// What is known of links and gripper.
fn arm_in_words(document: &Document) -> &'static str {
    match document.free.arm_starts.first() {
        None => "The arm's links and the gripper are not looked at: the scene names no arm.",
        Some(start) if start.clearance_m.is_none() => {
            "The arm's links and the gripper are not looked at: neither the URDF file nor the scene has their shapes. The player \
             only refuses to begin where a point of the arm may be more than 300 mm from where it is at the start."
        }
        Some(_) => {
            "Of the arm's links and the gripper, the shapes that the URDF file and the scene have stay as clear, also on the path \
             to the start and in the test of the frames."
        }
    }
}

fn configuration(arm: &ArmRecord) -> String {
    let joints = arm.joints.iter().zip(&arm.start_configuration);
    joints.map(|(joint, position)| format!("`{}` {position:.4}", joint.name)).collect::<Vec<_>>().join(", ")
}

fn pose(Pose([x, y, z, qw, qx, qy, qz]): &Pose) -> String {
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

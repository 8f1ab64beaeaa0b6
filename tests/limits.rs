//! Limits of a scene are kept by every scenario at every step.

use serde_json::Value;

use crate::support::{Dir, Run, list, number};

/// The solver's tolerance of a violated constraint, in the units of the limits.
const TOLERANCE: f64 = 1e-4;
/// Of the corner scene (s).
const TIME_STEP: f64 = 0.08;

/// Solves the corner scene with limits.
fn solve(dir: &Dir, limits: &str) -> Run {
    dir.write("limited.toml", format!("{}\n[limits]\n{limits}\n", dir.read("corner.toml")));
    dir.run("solve limited.toml --out out")
}

/// Solves and expects a plan that works; returns its result.
fn plan(dir: &Dir, limits: &str) -> Value {
    solve(dir, limits).code(0);
    let result = dir.result("out");
    assert_eq!(result["linear_solver_fallbacks"], 0);
    assert!(!result["warnings"].to_string().contains("limits"));
    result
}

#[test]
fn every_limit_is_kept_where_it_is_active() {
    let dir = Dir::new();
    // Without limits the plan reaches 0.069 m/s, 0.138 rad/s, 1.57 m/s^2, 1.72 rad/s^2, 1.95 N, 1.89 N and 0.102 Nm.
    for (limits, keys) in [
        ("translational_velocity = 0.036", vec![("translational_velocity_m_s", 0.036)]),
        ("rotational_velocity = 0.11", vec![("rotational_velocity_rad_s", 0.11)]),
        (
            "translational_acceleration = 0.2\nrotational_acceleration = 0.3",
            vec![("translational_acceleration_m_s2", 0.2), ("rotational_acceleration_rad_s2", 0.3)],
        ),
        ("contact_force = 1.2", vec![("contact_force_n", 1.2)]),
        ("force = 1.0\ntorque = 0.02", vec![("force_n", 1.0), ("torque_nm", 0.02)]),
    ] {
        let result = plan(&dir, limits);
        for (key, value) in crate::support::reached::reached(&dir, "out", TIME_STEP) {
            assert!((number(&result["reached"], key) - value).abs() < 1e-9, "{limits}: {key}");
            let scenarios = list(&result, "scenarios");
            assert!(scenarios.iter().all(|scenario| number(&scenario["reached"], key) <= value + 1e-9));
            let Some(&(_, limit)) = keys.iter().find(|(limited, _)| *limited == key) else {
                // A limit of contact forces limits velocities, too: that of impacts.
                let follows = limits.starts_with("contact_force") && key.contains("velocity");
                assert!(follows || result["limits"][key].is_null(), "{limits}: {key}");
                continue;
            };
            assert_eq!(result["limits"][key], limit);
            // Plans leave a margin of contact forces.
            let usable = if key == "contact_force_n" { 0.7 * limit } else { limit };
            assert!(value <= usable + TOLERANCE, "{limits}: {key} is {value}");
            assert!(value > 0.97 * usable, "{limits}: {key} is not active at {value}");
        }
    }
}

#[test]
fn limits_in_resolved_toml_repeat_the_plan() {
    let dir = Dir::new();
    let first = plan(&dir, "force = 1.5\nrotational_velocity = 0.12");
    dir.run("solve out/resolved.toml --out again")
        .code(0)
        .says("limits, in the planned scenarios: rotational_velocity 0.1");
    let second = dir.result("again");
    assert_eq!((&first["limits"], &first["objective"]), (&second["limits"], &second["objective"]));
    assert!(dir.bytes("out/reference.csv") == dir.bytes("again/reference.csv"));
}

#[test]
fn a_goal_out_of_reach_is_wrong_input() {
    let dir = Dir::new();
    let mut run = solve(&dir, "translational_velocity = 0.02").code(2);
    for words in ["limited.toml:", "translational_velocity = 0.02", "allow more than", "more steps in [horizon]"] {
        run = run.says(words);
    }
}

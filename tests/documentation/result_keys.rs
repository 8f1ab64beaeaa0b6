//! Every key of `result.json` is documented, and no other.

use std::collections::BTreeSet;
use std::fs;

use serde_json::Value;

use super::markdown::spans;
use super::{page, project, run};

/// Paths of all keys in a JSON value: `a.b`, and `a[].b` in lists.
fn key_paths(value: &Value, prefix: &str, paths: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                let path = if prefix.is_empty() { key.clone() } else { format!("{prefix}.{key}") };
                paths.insert(path.clone());
                // Its keys are names of files.
                if path != "files" {
                    key_paths(value, &path, paths);
                }
            }
        }
        Value::Array(elements) => elements.iter().for_each(|element| key_paths(element, &format!("{prefix}[]"), paths)),
        _ => {}
    }
}

/// The corner scene with an offset that puts the body inside of the floor and a limit that keeps it from leaving it.
fn contradiction(corner: &str) -> String {
    let start = "position = [0.1, 0.0, 0.08]\norientation = [0.997188818, 0.0, 0.074929707, 0.0]";
    let text = corner.replace(start, "position = [0.0, 0.0, 0.031]\norientation = [1, 0, 0, 0]");
    let text = text.replace("position = [-0.05, 0.0, 0.2]", "position = [-0.25, 0.0, 0.2]");
    let text = text.replace("offset_magnitude = 0.02", "offset_magnitude = 0.06");
    assert_ne!(text, corner);
    format!("{text}\n[limits]\ntranslational_velocity = 0.1\n")
}

#[test]
fn every_key_of_a_result_is_documented_and_no_other() {
    let folder = tempfile::tempdir().unwrap();
    let scene = project("scenes/corner.toml");
    let contradicting = folder.path().join("contradicting.toml");
    fs::write(&contradicting, contradiction(&fs::read_to_string(&scene).unwrap())).unwrap();
    let position = folder.path().join("position.toml");
    let text = fs::read_to_string(&scene).unwrap();
    fs::write(&position, format!("{text}\n[robot]\ninterface = \"position\"\n")).unwrap();
    let mut real = BTreeSet::new();
    // A plan that was tested, one that was evaluated and loses some rollouts, one that does not converge, and one of
    // a robot that is commanded by position have all keys.
    let lossy = ["--robust", "--stall-limit", "0", "--friction", "1", "--position-tolerance", "0.0005"];
    for (scene, flags) in [(&scene, &[][..]), (&scene, &lossy[..]), (&contradicting, &[]), (&position, &[])] {
        run(folder.path(), &[&["solve", scene.to_str().unwrap(), "--out", "out"], flags].concat());
        let result = fs::read_to_string(folder.path().join("out/result.json")).unwrap();
        key_paths(&serde_json::from_str(&result).unwrap(), "", &mut real);
    }
    // Nothing penetrates in rollouts, and so this is null.
    real.extend(["time_s", "step", "pair"].map(|key| format!("scenarios[].max_penetration_at.{key}")));

    let mut documented = BTreeSet::new();
    for (prefixes, rows) in page("docs/reference/results.md").marked_tables("keys of ") {
        for prefix in prefixes.split(", ") {
            for row in &rows {
                let key = &spans(&row[0])[0];
                documented.insert(if prefix == "result" { key.clone() } else { format!("{prefix}.{key}") });
            }
        }
    }
    let undocumented: Vec<&String> = real.difference(&documented).collect();
    assert!(undocumented.is_empty(), "not in docs/reference/results.md: {undocumented:?}");
    let invented: Vec<&String> = documented.difference(&real).collect();
    assert!(invented.is_empty(), "not in result.json: {invented:?}");
}

//! The program as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

fn program(arguments: &[&str]) -> Output {
    let folder = project("");
    Command::new(env!("CARGO_BIN_EXE_assembly-plan")).current_dir(folder).args(arguments).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn result(folder: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).unwrap()).unwrap()
}

/// Header and rows of a result table.
fn table(path: &Path) -> (String, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().to_owned();
    (header, lines.map(|line| line.split(',').map(str::to_owned).collect()).collect())
}

fn norm(numbers: &[String]) -> f64 {
    numbers.iter().map(|number| number.parse::<f64>().unwrap().powi(2)).sum::<f64>().sqrt()
}

const STATE: &str = "px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";

#[test]
fn a_plan_is_written_with_all_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("corner");
    let run = program(&["solve", "scenes/corner.toml", "--out", out.to_str().unwrap()]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    assert!(text(&run.stdout).contains("corner: done"));
    let progress = text(&run.stderr).lines().filter(|line| line.starts_with("stage ")).count();
    assert_eq!(progress, 5, "one line per homotopy iteration off a terminal");

    let stages: Vec<PathBuf> = (1..=5).map(|stage| out.join("stages").join(stage.to_string())).collect();
    for folder in stages.iter().chain([&out]) {
        let (header, rows) = table(&folder.join("reference.csv"));
        assert_eq!(header, format!("time_s,{STATE}"));
        assert_eq!(rows.len(), 21);
        assert_eq!(rows[3][0], "0.24");
        assert!(rows.iter().all(|row| (norm(&row[4..8]) - 1.0).abs() < 1e-12));
        let (header, rows) = table(&folder.join("scenarios.csv"));
        assert_eq!((header, rows.len()), (format!("time_s,scenario,{STATE}"), 2 * 21));
        let (header, rows) = table(&folder.join("wrench.csv"));
        assert_eq!(header, "time_s,scenario,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm");
        assert_eq!(rows.len(), 2 * 20);
        let (header, rows) = table(&folder.join("contacts.csv"));
        assert_eq!(header, "time_s,scenario,pair,distance_m,force_n");
        assert_eq!((rows.len(), rows[0][2].as_str()), (2 * 20 * 2, "box/floor"));
    }
    let result = result(&out);
    assert_eq!(result["status"], "done");
    assert_eq!(result["linear_solver"], "stage");
    assert!((result["objective"].as_f64().unwrap() / 0.1886 - 1.0).abs() < 0.02);
    assert_eq!(result["stages"].as_array().unwrap().len(), 5);
    for scenario in result["scenarios"].as_array().unwrap() {
        assert!(scenario["position_error_m"].as_f64().unwrap() < 1e-3);
        assert!(scenario["max_penetration_m"].as_f64().unwrap() < 1e-3);
    }

    let again = folder.path().join("again");
    let resolved = out.join("resolved.toml");
    let run = program(&["solve", resolved.to_str().unwrap(), "--out", again.to_str().unwrap()]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    let (first, second) = (table(&out.join("reference.csv")), table(&again.join("reference.csv")));
    for (one, other) in first.1.iter().flatten().zip(second.1.iter().flatten()) {
        assert!((one.parse::<f64>().unwrap() - other.parse::<f64>().unwrap()).abs() < 1e-2);
    }
}

#[test]
fn a_plan_that_leans_on_smoothing_says_what_cures_it() {
    let folder = tempfile::tempdir().unwrap();
    let solve = |iterations: u64| {
        let homotopy = folder.path().join("homotopy.toml");
        std::fs::write(&homotopy, format!("[homotopy]\niterations = {iterations}\n[ipopt]\ntol = 1e-2\n")).unwrap();
        let arguments = ["--homotopy", homotopy.to_str().unwrap(), "--out", folder.path().to_str().unwrap()];
        let run = program(&[&["solve", "scenes/corner.toml"][..], &arguments].concat());
        assert_eq!(code(&run), 0, "{}", text(&run.stderr));
        (result(folder.path()), text(&run.stderr))
    };
    let largest = |result: &Value, key: &str| {
        let scenarios = result["scenarios"].as_array().unwrap();
        scenarios.iter().map(|scenario| scenario[key].as_f64().unwrap()).fold(0.0, f64::max)
    };
    // Box and corner are 1 mm apart at the goal.
    let (soft, stderr) = solve(5);
    assert!(largest(&soft, "max_penetration_m") > 1e-4);
    let warning = soft["warnings"][0].as_str().unwrap();
    assert!(stderr.contains(warning) && warning.contains("leans on smoothing"), "{stderr}");
    let cure = warning.split("set iterations = ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();

    let (hard, stderr) = solve(cure.parse().unwrap());
    assert!(largest(&hard, "max_penetration_m") <= 1e-4);
    assert_eq!(hard["warnings"].as_array().unwrap().len(), 0);
    assert!(!stderr.contains("warning"), "{stderr}");
    assert!(largest(&hard, "max_complementarity_nm") < 0.5 * largest(&soft, "max_complementarity_nm"));
    let place = &soft["scenarios"][0]["max_complementarity_at"];
    assert!(["box/floor", "box/wall"].contains(&place["pair"].as_str().unwrap()));
    let step = place["step"].as_u64().unwrap();
    assert!((1..=20).contains(&step) && (place["time_s"].as_f64().unwrap() - 0.08 * step as f64).abs() < 1e-12);
}

#[test]
fn overlap_that_smoothing_does_not_explain_asks_for_shorter_steps() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, homotopy) = (folder.path().join("corner.toml"), folder.path().join("homotopy.toml"));
    std::fs::write(&homotopy, "[homotopy]\niterations = 9\n[ipopt]\ntol = 1e-8\n").unwrap();
    let text = std::fs::read_to_string(project("scenes/corner.toml")).unwrap();
    let text = text.replace("../configs/homotopy_peg.toml", "homotopy.toml");
    let warnings = |text: &str| {
        std::fs::write(&scene, text).unwrap();
        let run = program(&["solve", scene.to_str().unwrap(), "--out", folder.path().to_str().unwrap()]);
        assert_eq!(code(&run), 0);
        result(folder.path())["warnings"].to_string()
    };
    let coarse = warnings(&text);
    assert!(coarse.contains("set steps = 40 and time_step = 0.04 in [horizon]"), "{coarse}");
    assert_eq!(warnings(&text.replace("steps = 20", "steps = 40").replace("= 0.08\n", "= 0.04\n")), "[]");
}

#[test]
fn tight_tolerances_reach_the_reference_objectives() {
    for (complementarity, objective) in [("relaxation", 0.188_348_74), ("smoothing", 0.188_905_08)] {
        let folder = tempfile::tempdir().unwrap();
        let homotopy = folder.path().join("homotopy.toml");
        let settings = format!("[homotopy]\ncomplementarity = \"{complementarity}\"\n[ipopt]\ntol = 1e-9\n");
        std::fs::write(&homotopy, settings).unwrap();
        let out = folder.path().join("out");
        let arguments = ["--homotopy", homotopy.to_str().unwrap(), "--out", out.to_str().unwrap()];
        let run = program(&[&["solve", "scenes/corner.toml"][..], &arguments].concat());
        assert_eq!(code(&run), 0, "{}", text(&run.stderr));
        let actual = result(&out)["objective"].as_f64().unwrap();
        // Ipopt ends with a barrier parameter of about 1e-9 for each of some hundred conditions.
        assert!((actual - objective).abs() < 2e-6, "{complementarity}: {actual}");
    }
}

#[test]
fn peg1_enters_the_hole_in_every_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let run = program(&["solve", "scenes/peg1.toml", "--out", folder.path().to_str().unwrap()]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    let result = result(folder.path());
    assert!(result["objective"].as_f64().unwrap() <= 1.02 * 0.989);
    for scenario in result["scenarios"].as_array().unwrap() {
        assert!(scenario["position_error_m"].as_f64().unwrap() <= 2e-3);
    }
}

#[test]
fn a_plan_that_does_not_converge_is_written_and_exits_with_1() {
    let folder = tempfile::tempdir().unwrap();
    let homotopy = folder.path().join("homotopy.toml");
    std::fs::write(&homotopy, "[homotopy]\niterations = 1\n[ipopt]\nmax_iter = 3\n").unwrap();
    let out = folder.path().join("out");
    let arguments = ["--homotopy", homotopy.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let run = program(&[&["solve", "scenes/corner.toml"][..], &arguments].concat());
    assert_eq!(code(&run), 1);
    let result = result(&out);
    assert_eq!(result["status"], "stage 1: iteration limit reached");
    assert_eq!(result["converged"], false);
    assert!(out.join("reference.csv").exists());
}

#[cfg(unix)]
#[test]
fn an_interrupted_plan_keeps_its_last_iterate() {
    let folder = tempfile::tempdir().unwrap();
    let child = Command::new(env!("CARGO_BIN_EXE_assembly-plan"))
        .current_dir(project(""))
        .args(["solve", "scenes/peg2.toml", "--out", folder.path().to_str().unwrap()])
        .stderr(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    while !folder.path().join("resolved.toml").exists() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    std::thread::sleep(std::time::Duration::from_millis(500));
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let run = child.wait_with_output().unwrap();
    assert_eq!(code(&run), 130, "{}", text(&run.stderr));
    assert_eq!(result(folder.path())["status"], "stage 1: interrupted");
    assert!(folder.path().join("reference.csv").exists());
}

#[test]
fn wrong_input_exits_with_2_and_says_what_is_right() {
    let folder = tempfile::tempdir().unwrap();
    let option = folder.path().join("option.toml");
    std::fs::write(&option, "[ipopt]\nno_such_option = 1\n").unwrap();
    let typo = folder.path().join("typo.toml");
    std::fs::write(&typo, "titel = \"x\"\n").unwrap();
    let out = folder.path().join("out");
    let out = out.to_str().unwrap();
    for (arguments, words) in [
        (vec!["solve", "no/such.toml"], "cannot be read"),
        (vec!["solve", typo.to_str().unwrap()], "did you mean `title`?"),
        (vec!["solve", "scenes/corner.toml", "--start", "9"], "the scene has 1, 2, 3"),
        (vec!["solve", "scenes/corner.toml", "--delta", "-1"], "must not be negative"),
        (vec!["solve", "scenes/corner.toml", "--linear-solver", "ma99", "--out", out], "ma99"),
        (vec!["solve", "scenes/corner.toml", "--homotopy", option.to_str().unwrap(), "--out", out], "no_such_option"),
        (vec!["check", "scenes/corner.toml", "--pose", "1 2 3"], "7 numbers"),
        (vec!["check", "scenes/corner.toml", "--pose", "0 0 0 0 0 0 0"], "quaternion that is not zero"),
        (vec!["check", "scenes/corner.toml", "--tau", "0"], "must be positive"),
        (vec!["plan"], "unrecognized subcommand"),
    ] {
        let run = program(&arguments);
        assert_eq!(code(&run), 2, "{arguments:?}: {}", text(&run.stderr));
        assert!(text(&run.stderr).contains(words), "{arguments:?}: {}", text(&run.stderr));
    }
}

#[test]
fn check_reports_distances_as_json() {
    let pose = "0.1 0 0.08 1 0 0 0";
    let run = program(&["check", "scenes/corner.toml", "--pose", pose, "--tau", "1e-6", "--json"]);
    assert_eq!(code(&run), 0);
    let report: Value = serde_json::from_slice(&run.stdout).unwrap();
    let pairs = report.as_array().unwrap();
    assert_eq!(pairs.len(), 2);
    let (floor, wall) = (&pairs[0], &pairs[1]);
    assert_eq!((&floor["body"], &floor["environment"]), (&"box".into(), &"floor".into()));
    // The box is 0.06 m high and 0.1 m long; floor and wall are the planes z = 0 and x = 0.
    for (pair, distance, axis) in [(floor, 0.05, 2), (wall, 0.05, 0)] {
        assert!((pair["exact_distance_m"].as_f64().unwrap() - distance).abs() < 1e-9);
        assert!((pair["smoothed_distance_m"].as_f64().unwrap() - distance).abs() < 2e-5);
        let normal = pair["normal"].as_array().unwrap();
        assert_eq!(normal.len(), 7);
        assert!((normal[axis].as_f64().unwrap() - 1.0).abs() < 1e-3, "{normal:?}");
    }
}

#[test]
fn check_explains_a_scene() {
    let run = program(&["check", "scenes/peg1.toml"]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    let report = text(&run.stdout);
    for words in ["6 pairs", "shaft", "wall5", "goal", "100 steps", "3 scenarios", "7000 variables"] {
        assert!(report.contains(words), "{words} is missing in\n{report}");
    }
}

#[test]
fn nobody_has_to_listen() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("corner");
    let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
    command.current_dir(project("")).args(["solve", "scenes/corner.toml", "--out", out.to_str().unwrap()]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop((child.stdout.take(), child.stderr.take()));
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert_eq!(result(&out)["status"], "done");
}

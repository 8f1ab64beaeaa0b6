//! `calibrate` as a user runs it. What is found, the tests of the crate `calibration` say.

use crate::support::{Dir, list, project};

/// A short log of a body that is heavier than that of the corner scene: its reference jumps aside.
fn log() -> (Dir, String) {
    let dir = Dir::new();
    let gains = r#"{"translational_stiffness": 50.0, "rotational_stiffness": 5.0,
        "translational_damping": [[14.142, 0, 0], [0, 14.142, 0], [0, 0, 14.142]],
        "rotational_damping": [[1.414, 0, 0], [0, 1.414, 0], [0, 0, 1.414]]}"#;
    let goal = "[0.051, 0.0, 0.031, 1.0, 0.0, 0.0, 0.0]";
    let identity = "[0, 0, 0, 1, 0, 0, 0]";
    let header = format!(
        r#"# {{"format": 1, "scene": "corner", "base": {identity}, "grasp": {identity}, "goal": {goal}, "delta_m": 0.02,
        "dry_run_m": 0.1, "impedance": {gains}}}"#
    );
    let state = "px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";
    let reference = state.split(',').map(|name| format!("reference_{name}")).collect::<Vec<_>>().join(",");
    let mut text = format!("{}\ntime_s,{state},elapsed_s,{reference},phase\n", header.replace('\n', " "));
    for row in 0..150 {
        let time = 0.01 * f64::from(row);
        // The answer of 1.5 kg and 0.15 kg m^2 to a step: of rate 5.77 /s and damping ratio 0.816, both.
        let (rate, ratio) = ((50.0_f64 / 1.5).sqrt(), (0.5_f64 / 0.75).sqrt());
        let (damped, decay) = (rate * (1.0 - ratio * ratio).sqrt(), (-ratio * rate * time).exp());
        let slope = ratio / (1.0 - ratio * ratio).sqrt();
        let answer = 1.0 - decay * ((damped * time).cos() + slope * (damped * time).sin());
        let (way, angle) = (0.01 * answer, 0.05);
        let half = 0.5 * angle * answer;
        let pose = format!("{},0.2,0.3,{},0,0,{}", 0.3 + way, half.cos(), half.sin());
        let followed = if row == 0 { (0.3, 0.0) } else { (0.31, 0.5 * angle) };
        let followed = format!("{},0.2,0.3,{},0,0,{}", followed.0, f64::cos(followed.1), f64::sin(followed.1));
        let phase = if row < 149 { "playing" } else { "resting" };
        text += &format!("{time},{pose},0,0,0,0,0,0,{time},{followed},0,0,0,0,0,0,{phase}\n");
    }
    dir.write("log.csv", &text);
    (dir, text)
}

#[test]
fn a_scene_is_fitted_and_a_copy_is_written() {
    let (dir, _) = log();
    let scene = dir.read("corner.toml");
    dir.run("calibrate corner.toml log.csv").code(0).says("damping factor").says("[robot]").says("apparent_inertia");
    dir.run("calibrate corner.toml log.csv --out fitted.toml --quiet").code(0).keeps_silent_about("fitting");
    assert_eq!(dir.read("corner.toml"), scene);
    dir.run("calibrate corner.toml log.csv --out fitted.toml").code(2).says("--force");
    dir.run("calibrate corner.toml log.csv --out fitted.toml --force").code(0);
    dir.run("check fitted.toml").code(0);
    dir.run("calibrate corner.toml log.csv --out below/fitted.toml").code(2).says("relative to its folder");
    assert!(!dir.exists("below"));

    let run = dir.run("calibrate corner.toml log.csv --json").code(0);
    let record: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(list(&record, "parameters").len(), 3);
    assert_eq!(list(&record, "logs")[0]["has_contact"], false);
    assert!(record["entries"]["robustness"]["inertia_error"].as_f64().unwrap() > 0.0);
    let covariance = &record["covariance"];
    let names: Vec<&str> = list(covariance, "parameters").iter().map(|name| name.as_str().unwrap()).collect();
    assert_eq!((names.len(), list(covariance, "units").len()), (3, 3));
    for (place, name) in names.iter().enumerate() {
        let parameter = list(&record, "parameters").iter().find(|parameter| parameter["name"] == *name).unwrap();
        let (error, variance) =
            (parameter["standard_error"].as_f64().unwrap(), covariance["matrix"][place][place].as_f64());
        assert!((error * error - variance.unwrap()).abs() <= 1e-9 * error * error);
    }
}

#[test]
fn a_dry_run_that_was_stopped_is_used_up_to_there() {
    let (dir, text) = log();
    dir.write("stopped.csv", text.lines().take(130).map(|line| line.to_owned() + "\n").collect::<String>());
    let run = dir.run("calibrate corner.toml stopped.csv").code(0);
    run.says("used until it was stopped (the log ends before the plan does)");
}

#[test]
fn what_is_no_log_of_the_scene_is_refused() {
    let (dir, text) = log();
    let rows = |count: usize| text.lines().take(count).map(|line| line.to_owned() + "\n").collect::<String>();
    for (log, words) in [
        (text.lines().skip(1).map(|line| line.to_owned() + "\n").collect(), "wrong.csv:1: the line `# {...}`"),
        (text.replacen("\"format\": 1", "\"format\": 9", 1), "wrong.csv:1: format 9"),
        (text.replacen("\"dry_run_m\"", "\"dry\"", 1), "wrong.csv:1: column"),
        (text.replacen("\"corner\"", "\"peg1\"", 1), "the log is of another scene: its title is `peg1`"),
        (text.replacen("0.051", "0.052", 1), "its goal is another pose"),
        (text.replacen("elapsed_s", "elapsed", 1), "there is no column `elapsed_s`"),
        (text.replacen("reference_qw", "qqq", 1), "there is no column `reference_qw`"),
        (rows(2), "has fewer than two rows"),
        (rows(100).replacen("\"dry_run_m\": 0.1", "\"dry_run_m\": 0", 1), "has no motion in free air"),
        (text.replacen("\n0.02,", "\nsoon,", 1), "wrong.csv:5: column 1: `soon` is not a finite number"),
        (text.replacen(",0.03,", ",0.05,", 1), "wrong.csv:7: column elapsed_s"),
        (text.replacen("\"dry_run_m\": 0.1", "\"dry_run_m\": 0", 1), "the part did not end at its goal"),
    ] {
        assert_ne!(log, text, "{words}");
        dir.write("wrong.csv", log);
        dir.run("calibrate corner.toml wrong.csv --out copy.toml").code(2).says(words);
        assert!(!dir.exists("copy.toml"));
    }
    dir.run("calibrate corner.toml").code(2).says("LOG");
    dir.run("calibrate corner.toml gone.csv").code(2).says("gone.csv");
}

/// The corner with an arm that is commanded by position, and a log of it.
fn commanded() -> Dir {
    let dir = Dir::new();
    let replaced = ["translational_stiffness", "rotational_stiffness"];
    // The body of the stand-in that was logged.
    let scene = dir.read("corner.toml").replace("[0.1, 0.1, 0.1]", "[0.01, 0.01, 0.01]");
    let kept = scene.lines().filter(|line| !replaced.iter().any(|key| line.starts_with(key)));
    let arm = std::fs::read_to_string(project("examples/arms/six.toml")).unwrap();
    let arm =
        arm.replace("six.urdf", project("examples/arms/six.urdf").to_str().unwrap()).replace("[-0.55,", "[-0.45,");
    let keys = "interface = \"position\"\ncontact_stiffness = 2e4\nstiffness_range = { rotational = [1.0, 50.0] }\n";
    dir.write("arm.toml", kept.map(|line| line.to_owned() + "\n").collect::<String>() + &arm + keys);
    let log = std::fs::read_to_string(project("crates/calibration/tests/logs/position.csv")).unwrap();
    dir.write("log.csv", log);
    dir
}

#[test]
fn a_robot_that_is_commanded_by_position_is_fitted() {
    let dir = commanded();
    let run = dir.run("calibrate arm.toml log.csv --out fitted.toml").code(0);
    run.says("lag of the motion").says("force bias x in log 1").says("motions are too slow to separate it");
    dir.run("check fitted.toml").code(0);
    let run = dir.run("calibrate fitted.toml log.csv --json --quiet").code(0);
    let record: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert!(record["entries"]["robot"]["delay"].is_number(), "{record}");
    assert!(record["entries"]["robustness"]["force_bias"].is_number(), "{record}");
    // From the copy, nothing is left to be found.
    let lag = &list(&record, "parameters")[0];
    let (before, after) = (lag["before"].as_f64().unwrap(), lag["value"].as_f64().unwrap());
    assert!((before - after).abs() < 2e-4 && before > 0.02, "{before} {after}");
}

#[test]
fn a_log_of_another_interface_is_refused() {
    let dir = commanded();
    let run = dir.run("calibrate corner.toml log.csv").code(2);
    run.says("its robot has the interface `position`, and robot.interface is `torque`");
}

//! `simulate` as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn program(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    Command::new(env!("CARGO_BIN_EXE_assembly-plan")).current_dir(root).args(arguments).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

const SCENE: &str = "scenes/corner.toml";

/// Plans of the smallest scene for two magnitudes, in one folder.
fn plans() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for delta in ["0.01", "0.02"] {
        let out = folder.path().join(delta);
        let run = program(&["solve", SCENE, "--delta", delta, "--out", out.to_str().unwrap()]);
        assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    }
    folder
}

fn simulate(folder: &Path, arguments: &[&str]) -> Output {
    program(&[&["simulate", SCENE, folder.to_str().unwrap()], arguments].concat())
}

/// Header and rows of a table.
fn table(path: &Path) -> (String, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().to_owned();
    (header, lines.map(|line| line.split(',').map(str::to_owned).collect()).collect())
}

#[test]
fn plans_are_played_counted_and_compared() {
    let folder = plans();
    let plan = folder.path().join("0.02");

    // The last steps of this coarse plan end with a velocity: at rest the body is 3.7 mm away.
    let run = simulate(&plan, &["--position-tolerance", "0.005"]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    assert!(text(&run.stdout).contains("2/2 (34-100 %)"), "{}", text(&run.stdout));
    let (header, rows) = table(&plan.join("rollouts.csv"));
    assert_eq!(
        header,
        "plan,start,delta_m,motion,friction,magnitude_m,x_m,y_m,z_m,success,position_error_m,orientation_error_rad,\
         max_penetration_m,max_force_n,turn_x_rad,turn_y_rad,turn_z_rad"
    );
    assert_eq!(rows.len(), 4, "two scenarios, and the straight push for each");
    for row in rows.iter().filter(|row| row[3] == "plan") {
        assert_eq!(row[9], "1");
        assert!(row[12].parse::<f64>().unwrap() < 1e-5, "contacts are hard: {row:?}");
    }
    let (header, rows) = table(&plan.join("success.csv"));
    assert!(header.starts_with("motion,friction,delta_m,magnitude_m,rollouts,successes,rate,rate_low,rate_high,"));
    assert_eq!(rows.len(), 2);

    // All plans of a folder: modelled by injected magnitude, for every homotopy iteration and friction.
    let out = folder.path().join("out");
    let out_text = out.to_str().unwrap();
    let list = ["--stages", "--random", "3", "--magnitude", "0,0.01", "--friction", "0,0.3", "--out", out_text];
    let run = simulate(folder.path(), &list);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    let motions = 5 + 1 + 1;
    assert_eq!(table(&out.join("success.csv")).1.len(), motions * 2 * 2 * 2);
    // Without magnitude there is one offset, however many are asked for.
    let (_, rows) = table(&out.join("rollouts.csv"));
    assert_eq!(rows.len(), motions * 2 * 2 * (1 + 3));
    assert!(text(&run.stdout).contains("success in %"));

    // The same again, on any number of threads.
    let run = simulate(folder.path(), &[&list[..], &["--jobs", "1"]].concat());
    assert_eq!(code(&run), 0);
    assert_eq!(table(&out.join("rollouts.csv")).1, rows);
}

#[test]
fn offsets_come_from_a_grid_a_ball_or_a_list() {
    let folder = plans();
    let plan = folder.path().join("0.02");
    let file: PathBuf = folder.path().join("offsets.csv");
    std::fs::write(&file, "x_m,y_m,z_m\n0,0,0\n0.01,0,0\n0,0.005,0\n").unwrap();
    for (arguments, count) in [
        (vec!["--grid", "4"], 5),
        (vec!["--random", "7", "--ball", "--seed", "2"], 7),
        (vec!["--offsets", file.to_str().unwrap()], 3),
    ] {
        let run = simulate(&plan, &arguments);
        assert_eq!(code(&run), 0, "{}", text(&run.stderr));
        assert_eq!(table(&plan.join("rollouts.csv")).1.len(), 2 * count, "{arguments:?}");
    }
}

#[test]
fn the_part_may_be_turned_in_the_gripper() {
    let folder = plans();
    let plan = folder.path().join("0.02");
    // Without offset, only turned: every rollout is another one.
    let run = simulate(&plan, &["--random", "5", "--magnitude", "0", "--turn", "0.02"]);
    assert_eq!(code(&run), 0, "{}", text(&run.stderr));
    let (_, rows) = table(&plan.join("rollouts.csv"));
    assert_eq!(rows.len(), 2 * 5);
    for row in &rows {
        let turn: f64 = row[14..].iter().map(|angle| angle.parse::<f64>().unwrap().powi(2)).sum::<f64>().sqrt();
        assert!(turn > 0.0 && turn <= 0.02, "{row:?}");
    }
    let errors: Vec<&str> = rows.iter().filter(|row| row[3] == "plan").map(|row| row[11].as_str()).collect();
    assert!(errors.windows(2).all(|pair| pair[0] != pair[1]), "{errors:?}");
}

#[test]
fn wrong_input_exits_with_2_and_says_what_is_right() {
    let folder = plans();
    let plan = folder.path().join("0.02");
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (plan_text, empty, broken, offsets) = (path("0.02"), path("empty"), path("broken"), path("offsets.csv"));
    std::fs::create_dir(&empty).unwrap();
    std::fs::write(&offsets, "x_m,y_m\n0,0\n").unwrap();
    std::fs::create_dir(&broken).unwrap();
    std::fs::copy(plan.join("result.json"), Path::new(&broken).join("result.json")).unwrap();
    let reference = std::fs::read_to_string(plan.join("reference.csv")).unwrap();
    std::fs::write(Path::new(&broken).join("reference.csv"), reference.replacen("\n0.08,", "\nsoon,", 1)).unwrap();
    for (arguments, words) in [
        (vec![SCENE, "no/such"], "cannot be read"),
        (vec![SCENE, &empty], "`assembly-plan solve SCENE --out DIR` writes a plan"),
        (vec![SCENE, &broken], "reference.csv:3: column `time_s`: `soon` is not a finite number"),
        (vec![SCENE, &plan_text, "--offsets", &offsets], "there is no column `z_m`"),
        (vec![SCENE, &plan_text, "--friction", "-1"], "must not be negative"),
        (vec![SCENE, &plan_text, "--time-step", "0"], "must be above zero"),
        (vec![SCENE, &plan_text, "--turn", "-0.1"], "must not be negative"),
        (vec![SCENE, &plan_text, "--random", "0"], "--random"),
        (vec![SCENE, &plan_text, "--grid", "20000"], "more than 10000"),
        (vec![SCENE, &plan_text, "--random", "3", "--grid", "3"], "cannot be used with"),
        (vec!["scenes/peg1.toml", &plan_text], "was it made from another scene?"),
    ] {
        let run = program(&[&["simulate"], &arguments[..]].concat());
        assert_eq!(code(&run), 2, "{arguments:?}: {}", text(&run.stderr));
        assert!(text(&run.stderr).contains(words), "{arguments:?}: {}", text(&run.stderr));
    }
}

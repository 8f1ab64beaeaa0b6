//! `simulate` as a user runs it.

use crate::support::Dir;
use crate::support::table::norm;

/// Plans of the smallest scene for two magnitudes, in one folder.
fn plans() -> Dir {
    let dir = Dir::new();
    for delta in ["0.01", "0.02"] {
        dir.run(&format!("solve corner.toml --delta {delta} --out plans/{delta}")).code(0);
    }
    dir
}

#[test]
fn plans_are_played_counted_and_compared() {
    let dir = plans();

    // The last steps of this coarse plan end with a velocity: at rest the body is 3.7 mm away.
    dir.run("simulate corner.toml plans/0.02 --position-tolerance 0.005").code(0).says("2/2 (34-100 %)");
    let rollouts = dir.table("plans/0.02/rollouts.csv");
    assert_eq!(
        rollouts.header,
        "plan,start,delta_m,motion,friction,magnitude_m,x_m,y_m,z_m,success,position_error_m,orientation_error_rad,\
         max_penetration_m,max_force_n,turn_x_rad,turn_y_rad,turn_z_rad"
    );
    assert_eq!(rollouts.rows.len(), 4, "two scenarios, and the straight push for each");
    for row in rollouts.rows.iter().filter(|row| row[3] == "plan") {
        assert_eq!(row[9], "1");
        assert!(row[12].parse::<f64>().unwrap() < 1e-5, "contacts are hard: {row:?}");
    }
    let success = dir.table("plans/0.02/success.csv");
    assert!(success.header.starts_with("motion,friction,delta_m,magnitude_m,rollouts,successes,rate,rate_low,"));
    assert_eq!(success.rows.len(), 2);

    // All plans of a folder: modelled by injected magnitude, for every homotopy step and friction.
    let line = "simulate corner.toml plans --stages --random 3 --magnitude 0,0.01 --friction 0,0.3 --out out";
    dir.run(line).code(0).says("success in %");
    let motions = 5 + 1 + 1;
    assert_eq!(dir.table("out/success.csv").rows.len(), motions * 2 * 2 * 2);
    // Without magnitude there is one offset, however many are asked for.
    let rollouts = dir.table("out/rollouts.csv");
    assert_eq!(rollouts.rows.len(), motions * 2 * 2 * (1 + 3));

    // The same again, on any number of threads.
    dir.run(&format!("{line} --jobs 1")).code(0);
    assert_eq!(dir.table("out/rollouts.csv"), rollouts);
}

#[test]
fn offsets_come_from_a_grid_a_ball_or_a_list() {
    let dir = plans();
    dir.write("offsets.csv", "x_m,y_m,z_m\n0,0,0\n0.01,0,0\n0,0.005,0\n");
    for (flags, count) in [("--grid 4", 5), ("--random 7 --ball --seed 2", 7), ("--offsets offsets.csv", 3)] {
        dir.run(&format!("simulate corner.toml plans/0.02 {flags}")).code(0);
        assert_eq!(dir.table("plans/0.02/rollouts.csv").rows.len(), 2 * count, "{flags}");
    }
}

#[test]
fn the_part_may_be_turned_in_the_gripper() {
    let dir = plans();
    // Without offset, only turned: every rollout is another one.
    dir.run("simulate corner.toml plans/0.02 --random 5 --magnitude 0 --rotation-error 0.02").code(0);
    let rows = dir.table("plans/0.02/rollouts.csv").rows;
    assert_eq!(rows.len(), 2 * 5);
    for row in &rows {
        let rotation = norm(&row[14..]);
        assert!(rotation > 0.0 && rotation <= 0.02, "{row:?}");
    }
    let errors: Vec<&str> = rows.iter().filter(|row| row[3] == "plan").map(|row| row[11].as_str()).collect();
    assert!(errors.windows(2).all(|pair| pair[0] != pair[1]), "{errors:?}");
}

#[test]
fn a_plan_is_played_only_with_its_own_shapes_start_and_goal() {
    let dir = plans();
    dir.add_scene("peg1");
    let variants = [
        ("box = [0.1, 0.08, 0.06]", "box = [0.1, 0.08, 0.05]", "part `box` of its body is not part `box` of this one"),
        ("name = \"box\"", "name = \"lid\"", "part `box` of its body is not part `lid` of this one"),
        ("position = [0.051, 0.0, 0.031]", "position = [0.052, 0.0, 0.031]", "its goal is another pose"),
        ("position = [0.1, 0.0, 0.08]", "position = [0.1, 0.001, 0.08]", "its start `1` is another pose"),
        ("[goal]", "[[environment.part]]\nname = 'lid'\nbox = [1, 1, 1]\nposition = [0, 0, 9]\n[goal]", "has 2 parts"),
        ("name = \"1\"", "name = \"one\"", "there is no start `1`"),
    ];
    for (from, to, words) in variants {
        dir.add_variant("other.toml", &[(from, to)]);
        dir.run("simulate other.toml plans/0.02").code(2).says(words);
    }
    dir.run("simulate peg1.toml plans/0.02").code(2).says("plans/0.02: the plan was made for another scene");

    // Other settings are a warning: the plan may well be played with them.
    for (from, to) in [("mass = 1.0", "mass = 2.0"), ("steps = 20", "steps = 30"), ("stiffness = 50", "stiffness = 60")]
    {
        dir.add_variant("other.toml", &[(from, to)]);
        let words = "warning: plans/0.02: the plan was made with other settings than other.toml has";
        dir.run("simulate other.toml plans/0.02").code(0).says(words);
    }
    dir.run("simulate corner.toml plans/0.02").code(0).keeps_silent_about("warning");
    dir.run("simulate plans/0.02/resolved.toml plans/0.02").code(0).keeps_silent_about("another scene");
}

/// A plan in `plan` whose files have the hashes that its result lists, whatever is in them.
#[track_caller]
fn forge(dir: &Dir, file: &str, change: impl Fn(&str) -> String) {
    dir.copy("plans/0.02", "plan");
    let text = dir.read(format!("plan/{file}"));
    let changed = change(&text);
    assert_ne!(text, changed);
    dir.write(format!("plan/{file}"), &changed);
    let mut result = dir.result("plan");
    result["files"][file] = planner::files::hash(changed.as_bytes()).into();
    dir.write("plan/result.json", planner::files::sealed(result.to_string()));
}

/// Replaces a cell of a table by a text; the header is line 1.
fn with_cell(text: &str, line: usize, column: usize, cell: &str) -> String {
    let replace = |(number, row): (usize, &str)| {
        let mut cells: Vec<&str> = row.split(',').collect();
        if number == line {
            cells[column] = cell;
        }
        cells.join(",") + "\n"
    };
    (1..).zip(text.lines()).map(replace).collect()
}

#[test]
fn a_reference_that_is_none_is_refused_whatever_its_hash_is() {
    let dir = plans();
    let not_unit = "qw, qx, qy, qz are not a unit quaternion";
    for (line, column, cell, words) in [
        (3, 0, "soon", "plan/reference.csv:3: column 1: `soon` is not a finite number"),
        (3, 0, "nan", "`nan` is not a finite number"),
        (3, 0, "0.09", "plan/reference.csv:3: times must increase in equal steps"),
        (3, 0, "0", "times must increase in equal steps"),
        (22, 0, "1e300", "times must increase in equal steps"),
        (6, 1, "0.09", "plan/reference.csv:6: the position does not follow from the row before and the velocity"),
        (6, 10, "0.5", "plan/reference.csv:6: the position does not follow"),
        (4, 1, "1e300", "plan/reference.csv:4: a value is out of any reasonable range"),
        (4, 8, "-1e7", "a value is out of any reasonable range"),
        (5, 4, "5", not_unit),
        (5, 4, "0", not_unit),
        (5, 4, "1e-300", not_unit),
        (5, 7, "inf", "`inf` is not a finite number"),
        (5, 7, "", "plan/reference.csv:5: column 8: `` is not a finite number"),
    ] {
        forge(&dir, "reference.csv", |text| with_cell(text, line, column, cell));
        dir.run("simulate corner.toml plan").code(2).says(words).keeps_silent_about("success");
        dir.remove("plan");
    }
    for (kept, words) in [(0, "at least two rows"), (1, "at least two rows"), (2, "at least two rows")] {
        forge(&dir, "reference.csv", |text| text.lines().take(kept).map(|line| line.to_owned() + "\n").collect());
        dir.run("simulate corner.toml plan").code(2).says(words);
        dir.remove("plan");
    }
    forge(&dir, "reference.csv", |text| text.replacen("qw", "qv", 1));
    dir.run("simulate corner.toml plan").code(2).says("there is no column `qw`");
}

#[test]
fn files_of_two_plans_are_no_plan_whatever_their_hashes_are() {
    let dir = plans();
    let refused = |words: &str| {
        for line in ["simulate plan", "export plan --to csv --anyway", "report plan"] {
            dir.run(line).code(2).says(words);
        }
        dir.remove("plan");
    };
    forge(&dir, "resolved.toml", |text| {
        let (before, goal) = text.split_once("[goal]").unwrap();
        format!("{before}[goal]{}", goal.replacen("position = [0.", "position = [0.1", 1))
    });
    refused("the files are not of one plan");
    forge(&dir, "scenarios.csv", |text| {
        let (last, _) = (1..).zip(text.lines()).last().unwrap();
        with_cell(text, last, 2, "0.2")
    });
    refused("the files are not of one plan");
    forge(&dir, "wrench.csv", |text| with_cell(text, 3, 1, "99"));
    dir.run("report plan").code(2).says("plan/wrench.csv:3: another scenario or time should be here");
    dir.remove("plan");
    forge(&dir, "wrench.csv", |text| with_cell(text, 3, 2, "1e200"));
    dir.run("report plan").code(2).says("plan/wrench.csv:3: a value is out of any reasonable range");
    dir.remove("plan");
    for (line, column, cell, words) in [
        (5, 4, "-50", "plan/contacts.csv:5: a value is out of any reasonable range"),
        (5, 0, "-1", "plan/contacts.csv:5: another scenario or time should be here"),
    ] {
        forge(&dir, "contacts.csv", |text| with_cell(text, line, column, cell));
        dir.run("report plan").code(2).says(words);
        dir.remove("plan");
    }
    forge(&dir, "contacts.csv", |text| text.lines().next().unwrap().to_owned() + "\n");
    dir.run("report plan").code(2).says("plan/contacts.csv: has no row of the first scenario");
    dir.remove("plan");
    // Contacts of scenarios that are not there.
    forge(&dir, "scenarios.csv", |text| text.lines().next().unwrap().to_owned() + "\n");
    dir.run("report plan").code(2).says("plan/");
    dir.remove("plan");
    forge(&dir, "resolved.toml", |text| {
        text.replacen("translational_stiffness = 50.0", "translational_stiffness = 900.0", 1)
    });
    refused("plan/resolved.toml: has other settings than the plan was made with: it was changed; solve again");
}

#[test]
fn a_plan_with_a_lost_file_is_refused() {
    let dir = plans();
    for file in ["stages/3/reference.csv", "contacts.csv", "resolved.toml", "reference.csv"] {
        dir.copy("plans/0.02", "plan");
        dir.remove(format!("plan/{file}"));
        let words = format!("plan/{file}: belongs to the plan and cannot be read");
        dir.run("simulate corner.toml plan").code(2).says(&words);
        // Nor does the plan count among others.
        dir.copy("plan", "plans/lost");
        dir.run("simulate corner.toml plans --out tables").code(2).says(&words.replace("plan/", "plans/lost/"));
        dir.remove("plans/lost");
        dir.remove("plan");
    }
}

#[test]
fn plans_of_different_scenes_are_not_mixed() {
    let dir = Dir::new();
    let corner = dir.read("corner.toml");
    dir.write("other.toml", corner.replacen("title = \"corner\"", "title = \"other\"", 1));
    for scene in ["corner", "other"] {
        dir.run(&format!("solve {scene}.toml --out plans/{scene}")).code(0);
    }
    dir.run("simulate plans").code(2).says("plans/corner and plans/other are plans of different scenes");
    dir.run("simulate plans/other").code(0);
}

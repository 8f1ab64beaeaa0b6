//! Files that are no files, numbers that are none, output that nobody gets: nothing blocks, is lost without a word, or is
//! obeyed by a terminal.

use std::fs;
use std::process::Command;

use crate::support::small::SMALL;
use crate::support::{Dir, TestCommand};

/// The small scene, its plan in `plan`, and an export of that.
fn folder() -> Dir {
    let dir = Dir::new();
    dir.write("scene.toml", SMALL);
    dir.add_homotopy("homotopy.toml", "iterations = 2\ntau = 0.0025\nsigma = 0.00125", "tol = 1e-2\nmax_iter = 50");
    dir.run("solve scene.toml --homotopy homotopy.toml --out plan").code(0);
    dir
}

/// Puts a pipe that nobody writes to in the place of a file.
fn put_pipe(dir: &Dir, name: &str) {
    let path = dir.path(name);
    let _ = fs::remove_file(&path);
    assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
}

#[test]
fn a_pipe_in_the_place_of_a_file_is_refused_and_not_waited_for() {
    let dir = folder();
    let refused = |name: &str, lines: &[&str]| {
        put_pipe(&dir, name);
        for line in lines {
            let run = TestCommand::new(dir.folder(), line).spawn().finish_in_time();
            run.code(2).says("it is a pipe, a device or a socket");
        }
    };
    refused("pipe.toml", &["check pipe.toml", "solve pipe.toml", "batch pipe.toml --out runs"]);
    refused("pipe.csv", &["simulate plan --offsets pipe.csv", "simulate plan --executed pipe.csv"]);
    refused("log.csv", &["calibrate scene.toml log.csv"]);
    refused("pipe.stl", &["new made.toml --body pipe.stl --environment pipe.stl --unit mm"]);
    refused("pipe.sdf", &["new made.toml --body pipe.sdf --environment pipe.sdf"]);
    refused("pipe.log", &["solve scene.toml --log pipe.log"]);
    fs::create_dir(dir.path(".o.unfinished")).unwrap();
    put_pipe(&dir, ".o.unfinished/lock");
    let run = TestCommand::new(dir.folder(), "solve scene.toml --out o").spawn().finish_in_time();
    run.code(2).says("it is a pipe, a device or a socket");
    dir.run("simulate plan --trace t.csv --log t.csv").code(2).says("is the file of --log as well");
    refused("h.toml", &["solve scene.toml --homotopy h.toml"]);
    for name in ["reference.csv", "resolved.toml", "result.json"] {
        dir.copy("plan", "kept");
        refused(&format!("plan/{name}"), &["simulate plan", "report plan", "export plan --to csv"]);
        dir.remove("plan");
        dir.copy("kept", "plan");
        dir.remove("kept");
    }
}

#[test]
fn a_device_is_read_by_no_command_and_written_by_none() {
    let dir = folder();
    for line in ["check /dev/zero", "simulate plan --offsets /dev/zero", "solve scene.toml --log /dev/full"] {
        dir.run(line).code(2).says("it is a pipe, a device or a socket");
    }
    dir.run("report plan --out /dev/full").code(2);
    let device = "it is a pipe, a device or a socket";
    for line in ["new made.toml --force", "generate round --out made.toml --force", "batch submit runs"] {
        dir.run("batch expand scene.toml --out runs").code(0);
        for name in ["made.toml", "runs/submit.sh"] {
            put_pipe(&dir, name);
        }
        let run = TestCommand::new(dir.folder(), line).spawn().finish_in_time();
        assert!(
            run.code != Some(0) && (run.stderr.contains(device) || line.contains("submit")),
            "{line}: {}",
            run.stderr
        );
    }
}

#[test]
fn a_log_is_added_to_logs_only() {
    let dir = folder();
    dir.run("solve scene.toml --out other --log new.log").code(0);
    dir.run("solve scene.toml --out other --log new.log").code(0);
    for file in ["scene.toml", "plan/reference.csv", "plan/result.json", "plan/resolved.toml"] {
        let before = dir.bytes(file);
        let line = format!("solve scene.toml --out other --log {file}");
        dir.run(&line).code(2).says("exists and is no log; choose another name");
        assert!(dir.bytes(file) == before, "{file}");
    }
}

#[test]
fn two_runs_do_not_mix_their_times_in_one_log() {
    let dir = folder();
    fs::write(dir.path("run.log"), "").unwrap();
    let held = fs::File::open(dir.path("run.log")).unwrap();
    held.lock().unwrap();
    dir.run("solve scene.toml --out other --log run.log").code(2).says("another run writes to it");
    dir.run("solve scene.toml --out other --log missing/run.log").code(2).says("its folder does not exist");
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_nowhere_is_no_folder_and_stays() {
    use std::os::unix::fs::symlink;
    let dir = folder();
    symlink("nowhere", dir.path("dangling")).unwrap();
    symlink("circle", dir.path("circle")).unwrap();
    for link in ["dangling", "circle"] {
        for line in [
            "solve scene.toml --out",
            "report plan --figures",
            "export plan --to csv --anyway --out",
            "simulate plan --out",
            "man",
            "batch expand scene.toml --out",
        ] {
            let run =
                dir.run(&format!("{line} {link}")).code(2).says("is a link to what does not exist; name a folder");
            run.keeps_silent_about("homotopy step");
            dir.run(&format!("{line} {link}/below")).code(2).says("is a link to what does not exist; name another");
        }
        assert!(fs::symlink_metadata(dir.path(link)).unwrap().is_symlink());
    }
    symlink("nowhere", dir.path("new.toml")).unwrap();
    dir.run("new new.toml").code(2).says("already exists");
    assert!(fs::symlink_metadata(dir.path("new.toml")).unwrap().is_symlink());
    dir.run("man scene.toml").code(2).says("scene.toml: is a file; name a folder");
}

#[test]
fn names_that_begin_with_a_dash_are_names() {
    let dir = folder();
    fs::copy(dir.path("scene.toml"), dir.path("-s.toml")).unwrap();
    let run = TestCommand::new(dir.folder(), "batch --homotopies homotopy.toml --out=-q -- -s.toml").run();
    run.code(0).says("1/1 cells planned");
}

#[test]
fn numbers_of_flags_have_ranges() {
    let dir = folder();
    for (line, words) in [
        ("new n.toml --offset 1e308", "must lie above 0 and at or below 10 m"),
        ("new n.toml --contact-force 1e308", "must lie"),
        ("new n.toml --position-tolerance 1e-300", "must lie"),
        ("simulate plan --random 18446744073709551615", "must be a whole number between 1 and 1000000"),
        ("simulate plan --random 0", "must be a whole number between 1"),
        ("simulate plan --random 1 --seed 18446744073709551616", "must be a whole number between 0 and"),
        ("solve scene.toml --robust --stall-limit 18446744073709551616", "must be a whole number between 0 and"),
        ("batch submit plan --slurm --count 0", "must be a whole number between 1 and"),
        ("generate random --out p.toml --prisms 1e9", "must be a whole number between 0 and"),
    ] {
        dir.run(line).code(2).says(words);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn output_that_is_lost_is_no_success() {
    let dir = folder();
    for line in [
        "--help",
        "solve --help",
        "--version",
        "check scene.toml",
        "check scene.toml --json",
        "schema",
        "completions bash",
        "simulate plan",
    ] {
        let run = TestCommand::in_shell(dir.folder(), "exec >/dev/full", line).run();
        let run = run.code(3);
        assert!(
            line.contains("--help") || line == "--version" || run.stderr.contains("standard output: cannot be written")
        );
    }
    // Whoever stops reading has seen enough.
    TestCommand::in_shell(dir.folder(), "exec 2>&1", "schema").run().code(0);
}

#[test]
fn what_a_terminal_would_obey_is_shown_by_its_number() {
    let dir = folder();
    dir.write("offsets.csv", "x_m,y_m,z_m\n0,\u{1b}[2J,0\n");
    let run = dir.run("simulate plan --offsets offsets.csv").code(2).says("\\u{1b}[2J");
    assert!(!run.stderr.contains('\u{1b}'));
    let result = dir.read("plan/result.json").replace("planned, not tested", "planned\\u001b[2J\\u202e");
    dir.write("plan/result.json", planner::files::sealed(result));
    for line in ["export plan --to csv", "report plan", "simulate plan"] {
        let run = dir.run(line);
        let said = format!("{}{}", run.stdout, run.stderr);
        assert!(!said.contains(['\u{1b}', '\u{202e}']), "{line}: {said:?}");
    }
    dir.write("turned.toml", SMALL.replace("\"small\"", "\"a\\u202eb\""));
    dir.run("check turned.toml").code(2).says("title must not contain line breaks or control characters");
}

#[test]
fn threads_are_as_many_as_help() {
    let dir = folder();
    dir.run("solve scene.toml --homotopy homotopy.toml --out one --jobs 1").code(0);
    dir.run("solve scene.toml --homotopy homotopy.toml --out many --jobs 1024").code(0);
    assert!(dir.bytes("one/reference.csv") == dir.bytes("many/reference.csv"));
}

#[test]
fn half_of_a_simulation_is_no_simulation() {
    let dir = folder();
    dir.run("simulate plan --out si").code(0);
    dir.copy("si", "kept");
    dir.run("simulate plan --random 3 --out si").code(0);
    dir.run("report si").code(0);
    // Killed between two files.
    let rollouts = dir.bytes("kept/rollouts.csv");
    dir.write("si/rollouts.csv", rollouts);
    dir.run("report si").code(2).says("rollouts.csv: is not of the simulation that simulation.json is of");
    dir.run("simulate plan --random 3 --out si").code(0);
    dir.run("report si").code(0);
}

#[test]
fn a_folder_into_which_a_plan_was_being_moved_says_so() {
    let dir = folder();
    dir.rename("plan/result.json", "result.json");
    dir.copy("plan", ".plan.unfinished/whole");
    for line in ["report plan", "simulate plan", "export plan --to csv"] {
        dir.run(line).code(2).says("a run was interrupted while it moved its plan in; `assembly-plan solve` into this");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_a_killed_run_left_of_a_file_is_used_again() {
    let dir = folder();
    dir.write("plan/.report.html.partial", "half of a page");
    dir.run("report plan").code(0);
    assert!(!dir.exists("plan/.report.html.partial") && dir.read("plan/report.html").ends_with("</html>\n"));
}

/// Stacks, and memory, for which the program aborts.
#[cfg(target_os = "linux")]
#[test]
fn what_the_system_has_too_little_of_is_no_fault_of_the_input() {
    let dir = folder();
    // Threads have stacks of their own.
    TestCommand::in_shell(dir.folder(), "ulimit -s 64", "solve scene.toml --out limited").run().code(0);
    let mut process = dir.program("simulate plan --random 100000").spawn();
    while !process.has_ended() && !process.handles("ABRT") {}
    process.signal("ABRT");
    process.finish_in_time().code(3);
}

/// From when on it handles signals at all, which the system knows.
#[cfg(target_os = "linux")]
#[test]
fn every_command_ends_with_its_own_code_when_it_is_terminated() {
    let dir = folder();
    for line in ["simulate plan --random 100000", "report plan", "export plan --to csv", "check scene.toml"] {
        let mut process = dir.program(line).spawn();
        while !process.has_ended() && !process.handles("TERM") {}
        process.signal("TERM");
        let run = process.finish_in_time();
        assert!(matches!(run.code, Some(0 | 130)), "{line}: {:?}\n{}", run.code, run.stderr);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_scene_whose_name_is_no_text_is_named() {
    use std::os::unix::ffi::OsStrExt;
    let dir = folder();
    let name = std::ffi::OsStr::from_bytes(b"a\xff.toml");
    fs::write(dir.path(name), SMALL).unwrap();
    let run = TestCommand::new(dir.folder(), "batch --out runs").arg(name).run();
    run.code(2).says("has a path that is not UTF-8");
}

//! What the command line says of itself, completes, and makes of mistakes.

use std::process::Command;

use crate::support::Dir;
use crate::support::small::SMALL;

/// All commands and steps, as words after the program's name.
const COMMANDS: [&str; 17] = [
    "solve",
    "batch",
    "batch expand",
    "batch run",
    "batch status",
    "batch collect",
    "batch submit",
    "simulate",
    "report",
    "export",
    "calibrate",
    "check",
    "new",
    "generate round",
    "schema",
    "completions",
    "man",
];

/// What bash offers after a line, whose last word is the one to complete.
fn bash_offers(dir: &Dir, line: &str) -> Vec<String> {
    // The function that the script registers, called as bash calls it.
    let drive = r#"
source completions.bash
function=$(complete -p assembly-plan | sed 's/.*-F \([^ ]*\).*/\1/')
IFS=' ' read -ra COMP_WORDS <<<"$1"
[ "${1% }" != "$1" ] && COMP_WORDS+=('')
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
"$function" assembly-plan "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}" 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}"
"#;
    let output = Command::new("bash").current_dir(dir.folder()).args(["-c", drive, "bash", line]).output().unwrap();
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn bash_completes_commands_flags_values_and_files() {
    let dir = Dir::new();
    let script = dir.run("completions bash").code(0).stdout;
    dir.write("completions.bash", script);
    dir.write("scene.toml", "");
    let offers = |line: &str| bash_offers(&dir, &format!("assembly-plan {line}"));
    assert!(offers("so").contains(&"solve".to_owned()));
    assert_eq!(offers("solve --lin"), ["--linear-solver"]);
    assert_eq!(offers("solve --linear-solver m"), ["mumps", "ma27", "ma57", "ma97"]);
    assert_eq!(offers("solve scene.toml --homotopy sc"), ["scene.toml"]);
    assert_eq!(offers("new x.toml --unit "), ["m", "cm", "mm", "inch"]);
    assert_eq!(offers("new x.toml --axis "), ["x", "y", "z", "-x", "-y", "-z"]);
    assert_eq!(offers("export out --to u"), ["ur-rtde", "urscript", "usd"]);
    assert_eq!(offers("batch run --in"), ["--index"]);
    assert_eq!(offers("generate round --cl"), ["--clearance"]);
    assert_eq!(offers("completions z"), ["zsh"]);
}

#[test]
fn shells_know_flags_and_values() {
    let dir = Dir::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = dir.run(&format!("completions {shell}")).code(0).stdout;
        assert!(script.contains("linear-solver") && script.contains("simulate"), "{shell}");
        dir.write(shell, &script);
        if ["zsh", "fish"].contains(&shell) {
            let values = ["inch", "mumps", "ur-rtde", "-y"];
            assert!(values.iter().all(|value| script.contains(value)), "{shell}");
        }
    }
    let checked = Command::new("bash").arg("-n").arg(dir.path("bash")).output().unwrap();
    assert!(checked.status.success(), "{}", String::from_utf8_lossy(&checked.stderr));
}

#[test]
fn help_has_groups_examples_and_exit_codes() {
    let dir = Dir::new();
    for command in COMMANDS {
        let help = dir.run(&format!("{command} --help")).code(0).stdout;
        let example = format!("  assembly-plan {}", command.split(' ').next().unwrap());
        assert!(help.contains("Exit codes:") && help.contains(&example), "{help}");
        // Only what every command has is outside of the groups.
        let options = help.split("\nOptions:\n").nth(1).unwrap().split("\n\n").next().unwrap();
        let flags: Vec<&str> = options.split_whitespace().filter(|word| word.starts_with("--")).collect();
        assert_eq!(flags, ["--help", "--version"], "{command}");
    }
    dir.run("solve --help").code(0).says("Robustness:").says("--friction <MU,MU,...>").says("-o, --out <DIR>");
}

#[test]
fn every_example_of_the_help_is_accepted() {
    let dir = Dir::new();
    let mut count = 0;
    for command in ["", "solve", "batch", "simulate", "report", "export", "calibrate", "check", "new", "generate"] {
        let help = dir.run(&format!("{command} --help")).code(0).stdout;
        for example in help.lines().filter_map(|line| line.strip_prefix("  assembly-plan ")) {
            // Help is shown only if everything before it is accepted.
            dir.run(&format!("{example} --help")).code(0);
            count += 1;
        }
    }
    assert!(count > 20, "{count} examples");
}

#[test]
fn every_command_has_a_manual_page() {
    let dir = Dir::new();
    dir.run("man pages/here").code(0);
    let page = |name: &str| dir.read(format!("pages/here/assembly-plan{name}.1")).replace("\\-", "-");
    for command in COMMANDS {
        let text = page(&format!("-{}", command.replace(' ', "-")));
        let sections =
            ["SYNOPSIS", "DESCRIPTION", "EXIT STATUS", "EXAMPLES", "SEE ALSO"].map(|name| text.contains(name));
        assert_eq!(sections, [true; 5], "{command}: {text}");
        assert!(!text.contains("EXTRA"), "{command}");
    }
    let solve = page("-solve");
    assert!(solve.contains("[--start NAME]") && solve.contains("DIR/reference.csv"), "{solve}");
    assert!(solve.contains("assembly-plan-simulate(1)") && !solve.contains("assembly-plan-solve(1)"), "{solve}");
    assert!(page("").contains("EXIT STATUS"));
    dir.write("file", "");
    dir.run("man file").code(2).says("file: is a file; name a folder");
}

#[test]
fn a_wrong_flag_suggests_the_right_one() {
    let dir = Dir::new();
    for (line, words) in [
        ("solve scene.toml --tolerance 0.001", "'--position-tolerance'"),
        ("solve scene.toml --offset 0.001", "'--delta'"),
        ("simulate scene.toml plan --offset 0.001", "'--magnitude'"),
        ("simulate scene.toml plan --threads 2", "'--jobs'"),
        ("solve scene.toml --fricton 0", "'--friction'"),
        ("solve scene.toml --robust --friction 0.1 0.3", "numbers of a list are separated by commas"),
        ("solve scene.toml --linear-solver ma28", "ma27"),
    ] {
        dir.run(line).code(2).says(words).keeps_silent_about("as a value");
    }
}

#[test]
fn a_file_of_another_kind_is_named() {
    let dir = Dir::new();
    dir.write("scene.toml", SMALL);
    dir.write("lid.stl", [0_u8, 200, 3, 0, 255]);
    dir.write("binary.toml", [b'a', 0, 200, 3]);
    for name in ["lid.step", "lid.STP", "robot.urdf"] {
        dir.write(name, "text");
    }
    dir.run("solve scene.toml --out plan").code(0);
    for (line, words) in [
        ("check lid.stl", "it is a mesh; `assembly-plan new SCENE --body lid.stl --environment FILE` makes a scene"),
        ("solve lid.step", "scripts/lab step-to-obj"),
        ("check lid.STP", "scripts/lab step-to-obj"),
        ("check robot.urdf", "it is a model; `assembly-plan new"),
        ("check binary.toml", "binary.toml: the scene cannot be read: it is not a text file"),
        ("check plan", "plan: the scene cannot be read: it is a folder; name a file"),
        ("solve scene.toml --homotopy plan --out out", "it is a folder; name a file"),
        ("simulate plan scene.toml", "the scene comes first: `assembly-plan simulate scene.toml plan`"),
        ("simulate scene.toml", "scene.toml: is a file; name the folder of a plan"),
        ("export scene.toml --to csv", "scene.toml: is a file; name the folder of a plan"),
        ("report scene.toml", "scene.toml: is not a folder"),
        ("new new.toml --body lid.step --environment lid.stl --unit mm", "scripts/lab step-to-obj"),
    ] {
        let run = dir.run(line).code(2).says(words);
        assert!(!run.stderr.contains(['\0', '\u{fffd}']), "{line}: {}", run.stderr);
    }
}

#[test]
fn a_plan_is_simulated_in_its_own_scene() {
    let dir = Dir::new();
    dir.run("solve corner.toml --delta 0.01 --out plan").code(0);
    let table = |line: &str, out: &str| {
        let line = format!("simulate {line} --random 5 --friction 0,0.2 --out {out}");
        dir.run(&line).code(0).keeps_silent_about("warning: plan: the plan was made with other settings");
        dir.bytes(format!("{out}/rollouts.csv"))
    };
    assert!(table("plan", "own") == table("corner.toml plan", "named"));
}

#[test]
fn former_names_of_flags_are_read_with_a_warning() {
    let dir = Dir::new();
    for (line, old, new) in [
        ("solve x.toml --robust --turn=0.1", "--turn", "--rotation-error"),
        ("solve x.toml --robust --wanted-rate 0.9", "--wanted-rate", "--target-rate"),
        ("solve x.toml --robust --patience 3", "--patience", "--stall-limit"),
        ("solve x.toml --robust --max-changes 3", "--max-changes", "--max-perturbations"),
        ("simulate x.toml x --turn 0.1", "--turn", "--rotation-error"),
    ] {
        let expected = format!("`{old}` is now `{new}`");
        dir.run(line).code(2).says(&expected);
        dir.run(&line.replace(old, new)).code(2).keeps_silent_about("is now");
    }
    dir.run("batch submit x --slurm -- --turn=1").code(2).keeps_silent_about("is now");
}

//! Text of help and manual pages besides the flags: groups, examples, exit codes and files.

use clap::{Arg, Command, CommandFactory};

use crate::arguments::Arguments;

/// The last sections of the pages of a command.
pub struct Closing {
    /// The command, as words after the program's name.
    pub command: &'static str,
    /// What the command does beyond its one line.
    pub description: &'static str,
    /// Examples: arguments of the program, and their effect.
    pub examples: &'static [(&'static str, &'static str)],
    /// When the exit code is 1, if ever.
    pub no_plan: Option<&'static str>,
    /// Files that it reads or writes, and their content.
    pub files: &'static [(&'static str, &'static str)],
}

/// Flags by the groups in which help shows them. A flag is in the same group in every command.
const GROUPS: &[(&str, &[&str])] = &[
    ("Task", &["start", "delta", "homotopy", "starts", "deltas", "homotopies", "matrix"]),
    ("Parts", &["body", "environment", "unit", "axis", "link", "environment_link"]),
    (
        "Peg",
        &[
            "length",
            "clearance",
            "chamfer",
            "facets",
            "prisms",
            "diameter",
            "width",
            "depth",
            "key_width",
            "key_height",
        ],
    ),
    ("Offsets", &["offset", "random", "hull", "disc", "ball", "seed", "grid", "offsets", "magnitude", "coverage"]),
    ("Errors", &["plan", "quantity", "map", "rows", "no_map", "need", "by", "fit", "cases"]),
    ("Success", &["position_tolerance", "angle_tolerance", "contact_force", "strict"]),
    ("Robustness", &["robust", "target_rate", "time_limit", "from", "stall_limit", "friction", "rotation_error"]),
    ("Simulation", &["stages", "settling_time", "time_step", "executed"]),
    ("Robot", &["to", "rate", "anyway", "per_joint"]),
    ("Distances", &["pose", "tau"]),
    ("Job arrays", &["index", "count", "slurm", "now"]),
    ("Output", &["out", "force", "resume", "report", "trace", "figures", "animation", "scenario", "beside", "json"]),
    ("Running", &["linear_solver", "jobs", "quiet", "verbose", "log"]),
];

const PLAN_FILES: &[(&str, &str)] = &[
    ("DIR/reference.csv", "the motion to track: time, position, quaternion, velocities"),
    ("DIR/wrench.csv, DIR/scenarios.csv, DIR/contacts.csv", "wrench, motion and contacts with each planned offset"),
    ("DIR/result.json", "status, errors, forces, iterations, times, warnings"),
    ("DIR/resolved.toml", "scene and settings after defaults and flags; solving it repeats the run"),
    ("DIR/stages/", "the same tables after each homotopy step"),
    (".DIR.unfinished/, beside DIR", "unfinished work, which --resume continues"),
];

/// Those of all commands. The first is the program's own.
pub const CLOSINGS: &[Closing] = &[
    Closing {
        command: "",
        description: "",
        examples: &[
            ("new lid.toml --body lid.stl --environment pot.stl --unit mm", "write a scene of two meshes"),
            ("check lid.toml", "explain it and find mistakes, without solving it"),
            ("solve lid.toml --robust --out out/lid", "plan, test and refine"),
            ("simulate out/lid --random 200 --friction 0,0.3", "test the plan again, at new offsets"),
            ("report out/lid", "write an HTML page that shows the plan"),
            ("export out/lid --to csv", "write what the robot reads"),
        ],
        no_plan: Some("no plan was found, or it misses the goal or the target success rate"),
        files: &[],
    },
    Closing {
        command: "solve",
        description: "Solves an optimal control problem with smoothed contact. With --robust, the plan is then played in \
                      rollouts with hard contacts and friction, and changed until they succeed; without, it holds in the \
                      smoothed model only.",
        examples: &[
            ("solve scenes/peg1.toml --robust --out out/peg1", "plan, test and refine"),
            ("solve scenes/peg1.toml --robust --friction 0,0.1 --time-limit 60", "for low friction, in a minute"),
            ("solve scenes/peg1.toml --start 2 --delta 0.01", "another start, and a smaller offset"),
            ("solve scenes/peg1.toml --robust --out out/peg1 --resume", "continue an interrupted run"),
        ],
        no_plan: Some("no plan was found, or it misses the goal or the target success rate; its files are written"),
        files: PLAN_FILES,
    },
    Closing {
        command: "batch",
        description: "Without a step, expands, runs and collects. The same command again continues where the last one \
                      stopped; a finished cell is never solved again.",
        examples: &[
            (
                "batch scenes/clamp1.toml --deltas 0,0.001,0.002 --starts all --jobs 2 --out runs/clamp1",
                "solve 15 cells",
            ),
            ("batch status runs/clamp1", "show which of them are done"),
        ],
        no_plan: Some("a cell has no plan, or one that misses the goal"),
        files: &[("DIR/cells.csv, DIR/cells.json", "one row per cell"), ("DIR/cells/", "one folder per plan")],
    },
    Closing {
        command: "simulate",
        description: "Plays the references of plans in rollouts with hard contacts, and a straight push beside them. The \
                      scene is the plan's own unless another is named. At most one of --random, --grid and --offsets \
                      chooses the offsets.",
        examples: &[
            ("simulate out/peg1 --random 200 --friction 0,0.1,0.3", "200 random offsets at each friction"),
            ("simulate out/peg1 --random 50 --magnitude 0.005,0.01", "at two magnitudes"),
            ("simulate scenes/peg1.toml out/peg1", "the planned offsets, with the scene as it is now"),
        ],
        no_plan: Some("with --executed, the robot did not reach the goal"),
        files: &[
            ("DIR/rollouts.csv", "one row per rollout"),
            ("DIR/success.csv", "success rates by motion, friction and magnitude"),
            ("DIR/simulation.json", "scene, plans, seed, rotation error and tolerances"),
        ],
    },
    Closing {
        command: "tolerance",
        description: "Plays a plan with random errors that grow until too many rollouts fail. A map shows how the largest error \
                      depends on another quantity. Without --plan, the scene is planned robustly first, and again for each \
                      row of the map; the same command uses these plans again.",
        examples: &[
            ("tolerance scenes/peg1.toml --plan out/peg1", "each error of a plan, and offset by clearance"),
            ("tolerance scenes/peg1.toml --plan out/peg1 --map offset,friction --rows 0,0.1,0.3", "another map"),
            (
                "tolerance scenes/peg1.toml --plan out/peg1 --need offset=20mm --no-map",
                "the least clearance for an offset",
            ),
            ("tolerance peg.toml --fit H7/g6 --diameter 0.01", "plans for both ends of a fit"),
            ("tolerance scenes/peg1.toml --plan out/peg1 --resume", "continue an interrupted run"),
            (
                "tolerance scenes/peg1.toml --plan out/peg1 --index 3",
                "the fourth of its boundaries, as a task of a job array",
            ),
        ],
        no_plan: Some("too many rollouts fail at every tested value of a quantity"),
        files: &[
            ("DIR/tolerance.json", "largest errors, confidence intervals and the map, in SI units"),
            ("DIR/tolerance.svg", "the map"),
            ("DIR/plans/", "without --plan, the plans"),
            ("DIR/boundaries/", "boundaries of runs with --index, which --resume takes from there"),
            (".DIR.unfinished/, beside DIR", "finished boundaries of an interrupted run, which --resume continues"),
        ],
    },
    Closing {
        command: "report",
        description: "The page needs no network and no other file.",
        examples: &[
            ("report out/peg1", "write out/peg1/report.html"),
            ("report out/peg1 --figures figures", "also SVG figures"),
            ("report out/peg1 --animation peg1.gif", "also a moving picture"),
            ("report out/peg1 --beside out/other --out both.html", "two plans of the same parts"),
        ],
        no_plan: None,
        files: &[("DIR/report.html", "the page")],
    },
    Closing {
        command: "export",
        description: "Transfers the motion to the tool and frames of the robot, and writes a README that says how to check and run \
                      it.",
        examples: &[
            ("export out/peg1 --to csv", "tables for any robot"),
            ("export out/peg1 --to ur-rtde --rate 500", "with a player for arms of Universal Robots"),
        ],
        no_plan: None,
        files: &[("DIR/export/TARGET/", "tables, gains, limits, player and README")],
    },
    Closing {
        command: "calibrate",
        description: "Fits rotor inertia, joint friction, damping and delay to logs of exported players.",
        examples: &[("calibrate arm.toml dry-run.csv executed.csv --out calibrated.toml", "write the fitted scene")],
        no_plan: Some("the logs determine no entry of the scene, or the fit did not converge"),
        files: &[],
    },
    Closing {
        command: "check",
        description: "Begins with a verdict and warnings, then shows sizes, engagement, clearance and pairs.",
        examples: &[
            ("check scenes/peg1.toml", "explain a scene"),
            ("check scenes/peg1.toml --strict", "exit with 1 at any warning"),
            ("check scenes/peg1.toml --pose '0 0 0.05 1 0 0 0' --json", "distances of all pairs at a pose"),
        ],
        no_plan: Some("the goal cannot be reached, or with --strict, there is a warning"),
        files: &[],
    },
    Closing {
        command: "new",
        description: "Prints what it found and chose. The scene explains its keys and solves as it is. Without meshes it has a square \
                      shaft and its hole.",
        examples: &[
            ("new my.toml", "a scene to change by hand"),
            ("new lid.toml --body lid.stl --environment pot.stl --unit mm --offset 0.002", "a scene of two meshes"),
        ],
        no_plan: None,
        files: &[],
    },
    Closing {
        command: "generate",
        description: "",
        examples: &[("generate round --diameter 0.01 --clearance 0.0001 --out round.toml", "a round peg and its hole")],
        no_plan: None,
        files: &[],
    },
    Closing {
        command: "schema",
        description: "",
        examples: &[("schema > scene.schema.json", "for editors that check TOML files")],
        no_plan: None,
        files: &[],
    },
    Closing {
        command: "completions",
        description: "",
        examples: &[("completions bash > ~/.local/share/bash-completion/completions/assembly-plan", "for bash")],
        no_plan: None,
        files: &[],
    },
    Closing {
        command: "man",
        description: "",
        examples: &[("man ~/.local/share/man/man1", "for `man assembly-plan-solve`")],
        no_plan: None,
        files: &[],
    },
];

/// The command line, with everything that its help shows.
pub fn command_line() -> Command {
    let mut program = Arguments::command();
    for closing in CLOSINGS {
        // A step of a command ends like the command.
        let end = |command: Command| command.after_help(closing.text());
        program = match closing.command {
            "" => end(program),
            name => program.mut_subcommand(name, |command| end(command).mut_subcommands(end)),
        };
    }
    with_negative_numbers(grouped(program))
}

impl Closing {
    /// What a command ends with, given as the words after the program's name.
    pub fn of(command: &str) -> Option<&'static Self> {
        CLOSINGS.iter().find(|closing| closing.command == command)
    }

    /// Exit codes and their meanings.
    pub fn exit_codes(&self) -> Vec<(u8, &'static str)> {
        let always = [(2, "wrong input or usage"), (3, "anything else"), (130, "interrupted")];
        [(0, "done")].into_iter().chain(self.no_plan.map(|meaning| (1, meaning))).chain(always).collect()
    }

    fn text(&self) -> String {
        let mut text = "Examples:\n".to_owned();
        for (arguments, purpose) in self.examples {
            text += &format!("  # {purpose}\n  assembly-plan {arguments}\n");
        }
        text += "\nExit codes:\n";
        for (code, meaning) in self.exit_codes() {
            text += &format!("  {code:3}  {meaning}\n");
        }
        text.trim_end().to_owned()
    }
}

/// A command whose flags, and those of its subcommands, take negative numbers: their ranges have better messages than unknown
/// flags.
fn with_negative_numbers(command: Command) -> Command {
    let numbers = |argument: Arg| match argument.get_action().takes_values() && !argument.is_positional() {
        true => argument.allow_negative_numbers(true),
        false => argument,
    };
    command.mut_args(numbers).mut_subcommands(with_negative_numbers)
}

/// A command whose flags, and those of its subcommands, are in their groups.
fn grouped(command: Command) -> Command {
    let group = |argument: Arg| match GROUPS.iter().find(|(_, flags)| flags.contains(&argument.get_id().as_str())) {
        Some((group, _)) if !argument.is_positional() => argument.help_heading(*group),
        _ => argument,
    };
    command.mut_args(group).mut_subcommands(grouped)
}

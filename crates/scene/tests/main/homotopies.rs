//! Good and bad homotopy files, and the tables of them within scenes.

use std::path::{Path, PathBuf};

use scene::{Scene, SceneError, Source, load_homotopy, parse_homotopy, resolved};
use task::{Complementarity, HessianKind, HomotopySettings, IpoptValue, LinearSolver};

use crate::support::{assert_place, folder};

/// Ipopt's options: name, kind, range or choices.
const TABLE: &str = include_str!("../../src/ipopt_options.txt");

fn parse(text: &str) -> Result<HomotopySettings, SceneError> {
    parse_homotopy(Source { file: Path::new("h.toml"), text })
}

/// All files of a folder and of the folders in it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// A scene of the project with more lines after its title, and more at its end.
fn scene_with(lines: &str, more: &str) -> Result<Scene, SceneError> {
    let file = folder("scenes/corner.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let text = format!("{}\n{more}", text.replacen('\n', &format!("\n{lines}\n"), 1));
    Scene::parse(Source { file: &file, text: &text })
}

/// Lines of a table [homotopy], the column of the error in the first one, and words of its message.
#[rustfmt::skip]
const SETTINGS: &[(&str, usize, &str)] = &[
    ("iterations = 0", 14, "homotopy.iterations = 0: must lie between 1 and 100"),
    ("iterations = 101", 14, "homotopy.iterations = 101: must lie between 1 and 100"),
    ("iterations = -1", 14, "homotopy.iterations = -1: must lie between 1 and 100"),
    ("iterations = 5.0", 14, "homotopy.iterations = 5.0: must be an integer"),
    ("iterations = 'many'", 14, "homotopy.iterations = 'many': must be an integer, not text in quotes"),
    ("tau = 9e-10", 7, "homotopy.tau = 9e-10: must lie between 1e-9 and 1 N m"),
    ("tau = inf", 7, "homotopy.tau = inf: must lie between 1e-9 and 1 N m"),
    ("tau = \"1\"", 7, "homotopy.tau = \"1\": must be a number, not text in quotes"),
    ("tau = [1]", 7, "homotopy.tau must be a number, not a list"),
    ("tau.peg = 1", 1, "homotopy.tau must be a number, not a table"),
    ("tau = 1,5", 8, "the line must end here; decimals are written with a point"),
    ("sigma = -nan", 9, "homotopy.sigma = -nan: must lie between 1e-12 and 1 N m"),
    ("sigma = 1.1", 9, "homotopy.sigma = 1.1: must lie between 1e-12 and 1 N m"),
    ("mu_init = 1e-12", 11, "homotopy.mu_init = 1e-12: must lie above 1e-12 and at or below 1e6"),
    ("mu_init = 2_000_000", 11, "homotopy.mu_init = 2_000_000: must lie above 1e-12 and at or below 1e6"),
    ("tau_rate = 1.2", 12, "homotopy.tau_rate = 1.2: must lie above 0 and below 1"),
    ("sigma_rate = 0", 14, "homotopy.sigma_rate = 0: must lie above 0 and below 1"),
    ("mu_rate = 1.01", 11, "homotopy.mu_rate = 1.01: must lie above 0 and at or below 1"),
    ("mu_rate = true", 11, "homotopy.mu_rate = true: must be a number, not true or false"),
    ("hessian = \"exakt\"", 11, "homotopy.hessian: unknown value `exakt`, did you mean `exact`?"),
    ("hessian = 2", 11, "homotopy.hessian = 2: must be one of \"exact\", \"gauss-newton\", \"l-bfgs\", not a number"),
    ("linear_solver = \"mumsp\"", 17, "homotopy.linear_solver: unknown value `mumsp`, did you mean `mumps`?"),
    ("taw = 1.0", 1, "unknown key `taw`, did you mean `tau`?"),
    ("tau = 1\ntau = 2", 1, "`tau` is given twice"),
    ("max_iter = 5", 1, "unknown key `max_iter` here: it belongs to [ipopt]"),
    ("steps = 5", 1, "unknown key `steps`; valid are: iterations, further_iterations, coarse_iterations, tau, sigma, mu_init, tau_rate, sigma_rate, mu_rate, complementarity, hessian, linear_solver"),
];

#[test]
fn homotopy_values_are_checked_where_they_stand() {
    for (lines, column, words) in SETTINGS {
        assert_place(&parse(&format!("[homotopy]\n{lines}")).unwrap_err(), words, (1 + lines.lines().count(), *column));
    }
    for (text, words, column) in [
        ("[homotopi]", "unknown key `homotopi`, did you mean `homotopy`?", 2),
        ("[[homotopy]]", "homotopy is a single table: write [homotopy], not [[homotopy]]", 1),
        ("homotopy = 'peg'", "homotopy = 'peg': must be a table, not text in quotes", 12),
        ("tau = 1", "unknown key `tau` here: it belongs to [homotopy]", 1),
        ("tol = 1", "unknown key `tol` here: it belongs to [ipopt]", 1),
        ("[body]", "unknown key `body`; valid are: homotopy, ipopt", 2),
    ] {
        assert_place(&parse(text).unwrap_err(), words, (1, column));
    }
    assert!(parse("[homotopy]\niterations = 100\ntau = 1\nsigma = 1e-12\nmu_init = 1e6\nmu_rate = 1").is_ok());
}

#[test]
fn words_stand_for_their_settings() {
    for (word, setting) in [
        ("exact", HessianKind::Exact),
        ("gauss-newton", HessianKind::GaussNewton),
        ("l-bfgs", HessianKind::LimitedMemory),
    ] {
        assert_eq!(parse(&format!("[homotopy]\nhessian = '{word}'")).unwrap().hessian, setting);
    }
    for (word, setting) in [("relaxation", Complementarity::Relaxation), ("smoothing", Complementarity::Smoothing)] {
        assert_eq!(parse(&format!("[homotopy]\ncomplementarity = '{word}'")).unwrap().complementarity, setting);
    }
    for solver in LinearSolver::ALL {
        assert_eq!(parse(&format!("[homotopy]\nlinear_solver = '{}'", solver.name())).unwrap().linear_solver, solver);
    }
}

/// Lines of a table [ipopt], the column of the error, and words of its message.
#[rustfmt::skip]
const OPTIONS: &[(&str, usize, &str)] = &[
    ("max_itr = 5", 1, "unknown key `max_itr`, did you mean `max_iter`?"),
    ("Tol = 1e-3", 1, "unknown key `Tol`, did you mean `tol`?"),
    ("resto.tol = 1e-3", 1, "unknown key `resto`"),
    ("0815 = 1", 1, "unknown key `0815`"),
    ("tau = 1", 1, "unknown key `tau` here: it belongs to [homotopy]"),
    ("tol = [1]", 7, "ipopt.tol must be a number, not a list"),
    ("tol = \"1e-3\"", 7, "ipopt.tol = \"1e-3\": must be a number, not text in quotes"),
    ("tol = 0", 7, "ipopt.tol = 0: must lie above 0 and below inf"),
    ("tol = -1e-3", 7, "ipopt.tol = -1e-3: must lie above 0 and below inf"),
    ("tol = nan", 7, "ipopt.tol = nan: must lie above 0 and below inf"),
    ("tol = inf", 7, "ipopt.tol = inf: must lie above 0 and below inf"),
    ("bound_relax_factor = -1", 22, "ipopt.bound_relax_factor = -1: must lie at or above 0 and below inf"),
    ("bound_frac = 0.51", 14, "ipopt.bound_frac = 0.51: must lie above 0 and at or below 0.5"),
    ("mu_superlinear_decrease_power = 2", 33, "ipopt.mu_superlinear_decrease_power = 2: must lie above 1 and below 2"),
    ("mumps_dep_tol = -inf", 17, "ipopt.mumps_dep_tol = -inf: must lie above -inf and below inf"),
    ("max_iter = 5.0", 12, "ipopt.max_iter = 5.0: must be an integer"),
    ("max_iter = 2000-01-01", 12, "ipopt.max_iter = 2000-01-01: must be an integer, not a date or time"),
    ("max_iter = -1", 12, "ipopt.max_iter = -1: must lie between 0 and 2.147483647e9"),
    ("max_iter = 3_000_000_000", 12, "ipopt.max_iter = 3_000_000_000: must lie between 0 and 2.147483647e9"),
    ("mumps_scaling = 78", 17, "ipopt.mumps_scaling = 78: must lie between -2 and 77"),
    ("mu_strategy = \"adaptiv\"", 15, "ipopt.mu_strategy: unknown value `adaptiv`, did you mean `adaptive`?"),
    ("mu_strategy = \"a\\u0000\"", 15, "ipopt.mu_strategy: unknown value `a `; valid are: monotone, adaptive"),
    ("nlp_scaling_method = \"equilibration-based\"", 22, "ipopt.nlp_scaling_method cannot be `equilibration-based`: Ipopt ends the program where HSL is not installed; use gradient-based or none"),
    ("nlp_scaling_method = \"user-scaling\"", 22, "gives no scaling factors; use gradient-based or none"),
    ("recalc_y = true", 12, "ipopt.recalc_y = true: must be one of \"no\", \"yes\", not true or false"),
];

#[test]
fn wrong_options_are_refused_where_they_stand() {
    for (line, column, words) in OPTIONS {
        assert_place(&parse(&format!("[homotopy]\n[ipopt]\n{line}")).unwrap_err(), words, (3, *column));
    }
    let long = parse(&format!("[ipopt]\nmu_strategy = \"{}\"", "a".repeat(1_000_000))).unwrap_err();
    assert_place(&long, "ipopt.mu_strategy: unknown value `aaa", (2, 15));
    assert!(long.to_string().len() < 1000, "{long}");
    // The first of the file, not of the alphabet.
    assert_place(&parse("[ipopt]\n'tol' = 0\nmax_iter = -1").unwrap_err(), "ipopt.tol", (2, 9));
    assert_place(&parse("ipopt = { max_iter = 1, tal = 1 }").unwrap_err(), "did you mean `tol`?", (1, 25));
}

#[test]
fn right_options_reach_ipopt_in_the_order_of_their_names() {
    let entries = "tol = 1\nmax_iter = 0\nmu_strategy = \"adaptive\"\nacceptable_tol = 1e-3\nma97_u = 0.5";
    let settings = parse(&format!("[ipopt]\n{entries}")).unwrap();
    let options: Vec<_> = settings.ipopt.iter().map(|option| (option.name.as_str(), option.value.clone())).collect();
    let expected = [
        ("acceptable_tol", IpoptValue::Number(1e-3)),
        ("ma97_u", IpoptValue::Number(0.5)),
        ("max_iter", IpoptValue::Integer(0)),
        ("mu_strategy", IpoptValue::Text("adaptive".to_owned())),
        // A number, although it is written as an integer.
        ("tol", IpoptValue::Number(1.0)),
    ];
    assert_eq!(options, expected);
}

#[test]
fn there_are_fifty_options_at_most() {
    let names = TABLE.lines().skip(1).filter_map(|line| line.split(' ').next());
    let names: Vec<_> = names.filter(|name| parse(&format!("[ipopt]\n{name} = 1")).is_ok()).collect();
    let file = |count: usize| format!("[ipopt]\n{} = 1\n", names[..count].join(" = 1\n"));
    let allowed = parse(&file(50)).map(|homotopy| homotopy.ipopt.len());
    assert_eq!(allowed.unwrap_or_else(|error| panic!("{error}")), 50);
    assert_place(&parse(&file(51)).unwrap_err(), "more than 50 entries", (52, 1));
}

/// What an option may be set to.
fn value(line: &str) -> String {
    let (kind, values) = line.split_once(' ').unwrap().1.split_once(' ').unwrap();
    if kind == "string" {
        return format!("\"{}\"", values.split(' ').next().unwrap());
    }
    let (lower, upper) = values.trim_matches(['(', '[', ']', ')']).split_once(", ").unwrap();
    let (lower, upper) = (lower.parse::<f64>().unwrap(), upper.parse::<f64>().unwrap());
    match (lower.is_finite(), upper.is_finite()) {
        (true, true) if kind == "number" => format!("{}", 0.5 * (lower + upper)),
        (true, _) => format!("{}", lower + 1.0),
        _ => "1".to_owned(),
    }
}

#[test]
fn every_option_of_the_table_can_be_set_or_names_its_replacement() {
    let options = TABLE.lines().skip(1);
    let refused = options.filter(|line| {
        let name = line.split(' ').next().unwrap();
        let Err(error) = parse(&format!("[ipopt]\n{name} = {}", value(line))) else { return false };
        assert_place(&error, &format!("ipopt.{name} cannot be set: "), (2, 1));
        let (reason, replacement) = error.message().split_once("; ").unwrap_or_else(|| panic!("{error}"));
        assert!(!reason.is_empty() && replacement.contains("use "), "{error}");
        true
    });
    let refused: Vec<_> = refused.filter_map(|line| line.split(' ').next()).collect();
    let other_solvers = ["ma28_", "ma77_", "ma86_", "pardiso_", "spral_", "wsmp_"];
    let others = refused.into_iter().filter(|name| !other_solvers.iter().any(|solver| name.starts_with(solver)));
    let expected = "dependency_detection_with_rhs dependency_detector derivative_test derivative_test_first_index \
        derivative_test_perturbation derivative_test_print_all derivative_test_tol file_append file_print_level \
        findiff_perturbation fixed_variable_treatment grad_f_constant gradient_approximation hessian_approximation \
        hessian_constant hsllib inf_pr_output jac_c_constant jac_d_constant jacobian_approximation \
        limited_memory_aug_solver linear_scaling_on_demand linear_solver linear_system_scaling ma27_print_level \
        ma57_print_level ma97_print_level mehrotra_algorithm mu_init mumps_print_level nlp_lower_bound_inf nlp_upper_bound_inf \
        num_linear_variables obj_scaling_factor option_file_name output_file pardisolib point_perturbation_radius \
        print_advanced_options print_frequency_iter print_frequency_time print_info_string print_level \
        print_options_documentation print_options_latex_mode print_options_mode print_timing_statistics \
        print_user_options replace_bounds sb skip_finalize_solution_call suppress_all_output timing_statistics \
        warm_start_entire_iterate warm_start_init_point warm_start_same_structure warm_start_target_mu";
    assert_eq!(others.collect::<Vec<_>>(), expected.split_whitespace().collect::<Vec<_>>());
}

#[test]
fn refused_options_say_what_to_use() {
    for (name, replacement) in [
        ("mu_init", "homotopy.mu_init"),
        ("linear_solver", "--linear-solver"),
        ("hessian_approximation", "homotopy.hessian"),
        ("print_level", "result.json"),
        ("mumps_print_level", "result.json"),
        ("print_timing_statistics", "times in result.json"),
        ("file_print_level", "the program reads Ipopt's log itself"),
        ("option_file_name", "[ipopt]"),
        ("derivative_test", "cargo test -p ocp"),
        ("warm_start_init_point", "warm_start_bound_push"),
        ("linear_system_scaling", "nlp_scaling_method"),
        ("nlp_upper_bound_inf", "[limits]"),
        ("pardiso_order", "homotopy.linear_solver"),
    ] {
        let error = parse(&format!("[ipopt]\n{name} = 1")).unwrap_err();
        assert!(error.message().contains(replacement), "{error}");
    }
}

#[test]
fn the_table_has_all_options_that_the_program_sets() {
    for name in [
        "file_print_level",
        "hessian_approximation",
        "linear_solver",
        "linear_system_scaling",
        "min_refinement_steps",
        "mu_init",
        "option_file_name",
        "output_file",
        "print_level",
        "print_timing_statistics",
        "sb",
        "warm_start_bound_frac",
        "warm_start_bound_push",
        "warm_start_init_point",
        "warm_start_mult_bound_push",
        "warm_start_slack_bound_frac",
        "warm_start_slack_bound_push",
    ] {
        assert!(TABLE.lines().any(|line| line.starts_with(&format!("{name} "))), "{name}");
    }
}

#[test]
fn every_homotopy_file_of_the_project_loads() {
    let mut paths = files(&folder("configs"));
    paths.extend(files(&folder("scripts/python/lab/reproduction/studies/homotopies")));
    for path in paths {
        let homotopy = load_homotopy(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(homotopy.ipopt.len(), 2, "{}", path.display());
    }
}

#[test]
fn files_that_repeat_the_paper_neither_go_on_nor_begin_coarse() {
    let mut paths = files(&folder("scripts/python/lab/reproduction/studies/homotopies"));
    paths.extend(
        ["homotopy_peg", "homotopy_clamp", "homotopy_clamp_wide"].map(|name| folder(&format!("configs/{name}.toml"))),
    );
    for path in paths {
        let homotopy = load_homotopy(&path).unwrap();
        let beyond = [homotopy.further_iterations, homotopy.coarse_iterations];
        assert_eq!((beyond, homotopy.mu_init, homotopy.mu_rate), ([0, 0], 1.0, 0.1), "{}", path.display());
    }
}

#[test]
fn resolved_scenes_keep_their_options() {
    let entries = "[homotopy]\nmu_init = 0.01\n[ipopt]\nmu_strategy = \"adaptive\"\ntol = 1\nmax_iter = 7";
    let scene = scene_with("", entries).unwrap_or_else(|error| panic!("{error}"));
    let homotopy = scene.homotopy.clone().unwrap();
    let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &homotopy);
    assert!(text.contains("[ipopt]\nmax_iter = 7\nmu_strategy = \"adaptive\"\ntol = 1.0\n"), "{text}");
    let again = Scene::parse(Source { file: Path::new("resolved.toml"), text: &text }).unwrap();
    assert_eq!(again.homotopy, Some(homotopy));
}

#[test]
fn tables_within_a_scene_are_checked_where_they_stand() {
    for (more, words, line_of_words) in [
        ("[homotopy]\n[ipopt]\nmax_itr = 5", "did you mean `max_iter`?", "max_itr = 5"),
        ("[homotopy]\ntau = 2.0\n[ipopt]\ntol = 1", "homotopy.tau = 2.0: must lie between 1e-9 and 1 N m", "tau = 2.0"),
        ("[homotopy]\n[ipopt]\nprint_level = 5", "Ipopt's log is not shown", "print_level = 5"),
        ("[ipopt]\ntol = 1", "needs a [homotopy] table beside it", "[ipopt]"),
    ] {
        let error = scene_with("", more).unwrap_err();
        assert!(error.message().contains(words) && error.line().is_some(), "{error}");
        assert!(error.to_string().contains(&format!("| {line_of_words}\n")), "{error}");
    }
}

#[test]
fn a_homotopy_of_a_scene_is_a_file_name_or_a_table() {
    for (line, words, place) in [
        ("homotopy = 5", "homotopy = 5: must be a file name or a table, not a number", 12),
        ("homotopy = [1]", "homotopy must be a table, not a list", 12),
        ("homotopy = [{ tau = 1 }]", "homotopy is a single table: write [homotopy], not [[homotopy]]", 12),
        ("homotopy = { taw = 1 }", "unknown key `taw`, did you mean `tau`?", 14),
    ] {
        let error = scene_with(line, "").unwrap_err();
        assert!(error.message().contains(words), "{error}");
        assert_eq!(error.column(), Some(place), "{error}");
    }
    let both = scene_with("homotopy = \"h.toml\"", "[ipopt]\ntol = 1").unwrap_err();
    assert!(both.message().contains("[ipopt] cannot stand beside the name of a homotopy file"), "{both}");
    assert_eq!(scene_with("homotopy = { tau = 0.5 }", "").unwrap().homotopy.unwrap().tau, 0.5);
}

#[test]
fn a_homotopy_file_that_cannot_be_read_is_shown_in_the_scene_that_names_it() {
    let other = tempfile::tempdir().unwrap();
    let large = other.path().join("large.toml");
    std::fs::write(&large, "# padding\n".repeat(1_700_000)).unwrap();
    let (gone, large, other) = ("gone.toml", large.to_str().unwrap(), other.path().to_str().unwrap());
    for (name, reason) in
        [(gone, "there is no such file"), (other, "it is a folder; name a file"), (large, "larger than 16 MiB")]
    {
        let error = scene_with(&format!("homotopy = {name:?}"), "").unwrap_err();
        assert!(error.message().starts_with("the homotopy ") && error.message().ends_with(reason), "{error}");
        assert!(error.message().contains(&format!("{name} cannot be read: ")), "{error}");
        assert!(error.to_string().contains(&format!("| homotopy = {name:?}\n")), "{error}");
        assert_eq!(error.column(), Some(12));
    }
    let error = load_homotopy(Path::new("no/such/homotopy.toml")).unwrap_err();
    assert_eq!(error.to_string(), "no/such/homotopy.toml: the homotopy cannot be read: there is no such file");
}

#[test]
fn what_is_wrong_in_a_homotopy_file_is_shown_in_that_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("h.toml");
    for (text, place) in [(&b"[ipopt]\ntol = 0\n"[..], "2:7"), (b"[homotopy]\n# f\xfcr", "2:4")] {
        std::fs::write(&file, text).unwrap();
        let error = scene_with(&format!("homotopy = {:?}", file.to_str().unwrap()), "").unwrap_err();
        assert!(error.to_string().starts_with(&format!("{}:{place}: ", file.display())), "{error}");
        assert_eq!(
            load_homotopy(&file).unwrap_err().headline().split(": ").next(),
            error.headline().split(": ").next()
        );
    }
}

#[test]
fn a_byte_order_mark_before_a_homotopy_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("h.toml");
    std::fs::write(&file, "\u{feff}[homotopy]\r\ntau = 1\r\n").unwrap();
    assert_eq!(load_homotopy(&file).unwrap().tau, 1.0);
    assert_place(&parse("\u{feff}taw = 1").unwrap_err(), "unknown key `taw`", (1, 1));
    assert_eq!(parse(""), parse("\u{feff}"));
}

//! Mutated scenes: whatever the text is, reading it ends soon, in a scene with sound numbers or in an error with a
//! place.

use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use scene::{Scene, Source, default_homotopy, keys, resolved};
use task::AssemblyTask;

/// Longest time that reading a scene may take: a moment, but on any machine.
const LONGEST: Duration = Duration::from_secs(600);

/// Scenes of the project, with their places.
static SCENES: LazyLock<Vec<(PathBuf, String)>> = LazyLock::new(|| {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files.into_iter().map(|file| (file.clone(), std::fs::read_to_string(file).unwrap())).collect()
});

/// Values that are put in the place of others.
const VALUES: &[&str] = &[
    "nan",
    "inf",
    "-inf",
    "1e300",
    "-1e300",
    "-0",
    "-0.0",
    "0",
    "0.0",
    "1e-300",
    "5e-324",
    "1",
    "-1",
    "2",
    "1e-5",
    "1e-9",
    "1e3",
    "1001",
    "1e9",
    "10001",
    "99999999999999999999999",
    "-9223372036854775808",
    "0xffffffffffffffff",
    "1e999",
    "0.5",
    "true",
    "\"x\"",
    "''",
    "\"\\u0000\"",
    "\"\\u2028\"",
    "[]",
    "[[]]",
    "{}",
    "{ a = 1 }",
    "[0, 0, 0]",
    "[1, 0, 0, 0]",
    "[[0, 0, 0]]",
    "[[[0, 0, 0]]]",
    "[1e-200, 0, 0]",
    "1979-05-27",
    "\"\"\"\n\"\"\"",
    "é",
    "\u{feff}",
    "\0",
    "\r",
    "\n",
    "#",
    "=",
    "[",
    "]",
    "]]",
    "[[",
    "{",
    "}",
    ",",
    ".",
    "\"",
    "'",
    "\\",
    "_",
    "1_0",
    "+1",
    "0b1",
];

/// Lines that are put between others.
const LINES: &[&str] = &[
    "[body]",
    "[environment]",
    "[[body.part]]",
    "[[environment.part]]",
    "[contact]",
    "pairs = []",
    "pairs = [[\"a\", \"b\"]]",
    "[[start]]",
    "[start]",
    "[goal]",
    "[[goal]]",
    "[impedance]",
    "[limits]",
    "translational_velocity = 1e-9",
    "translational_acceleration = 1e-9",
    "rotational_velocity = 1e9",
    "rotational_acceleration = 0.1",
    "contact_force = 1",
    "[homotopy]",
    "iterations = 3",
    "homotopy = \"none\"",
    "homotopy = 1",
    "[ipopt]",
    "tol = 1",
    "title = \"x\"",
    "mass = 1e-6",
    "inertia = [[1, 2, 3], [2, 1, 2], [3, 2, 1]]",
    "inertia = [1e-12, 1, 1e6]",
    "translational_damping = 0",
    "translational_damping = [1, 2, 3]",
    "rotational_damping = [0, 0, 1e7]",
    "rotational_damping = [[1, 1, 0], [1, 1, 0], [0, 0, 0]]",
    "box = [1, 1e-5, 1]",
    "mesh = \"x.stl\"",
    "unit = \"mm\"",
    "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1e-7]]",
    "normals = [[1, 0, 0], [-1, 1e-6, 0], [-1, -1e-6, 1e-6]]",
    "offsets = [1, 1, 1, 1e9]",
    "steps = 10000",
    "time_step = 1e-5",
    "a.b.c = 1",
    "cost.reference.terminal_position = 1e12",
];

#[derive(Debug, Clone)]
enum Mutation {
    Delete(usize),
    Duplicate(usize),
    Replace(usize, String),
    Scale(usize, f64),
    Swap(usize, usize),
    Repeat(usize, usize),
    Nest(usize, usize),
    Insert(usize, String),
    Copy(usize, usize),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let token = any::<usize>();
    let value = prop_oneof![
        4 => prop::sample::select(VALUES).prop_map(str::to_owned),
        1 => any::<f64>().prop_map(|number| number.to_string()),
        1 => any::<i64>().prop_map(|number| number.to_string()),
        1 => "\\PC{0,8}",
    ];
    let line = prop::sample::select(LINES).prop_map(str::to_owned);
    prop_oneof![
        1 => token.prop_map(Mutation::Delete),
        1 => token.prop_map(Mutation::Duplicate),
        6 => (token, value).prop_map(|(at, value)| Mutation::Replace(at, value)),
        9 => (token, -3.0..3.0f64).prop_map(|(at, exponent)| Mutation::Scale(at, 10f64.powf(exponent))),
        1 => (token, token).prop_map(|(one, other)| Mutation::Swap(one, other)),
        1 => (token, 0..40usize).prop_map(|(at, times)| Mutation::Repeat(at, times)),
        1 => (token, 0..300usize).prop_map(|(at, depth)| Mutation::Nest(at, depth)),
        3 => (token, line).prop_map(|(at, line)| Mutation::Insert(at, line)),
        2 => (token, token).prop_map(|(from, to)| Mutation::Copy(from, to)),
    ]
}

/// Numbers, words, quoted texts, and every other character for itself.
fn tokens(text: &str) -> Vec<String> {
    let is_word = |character: char| character.is_alphanumeric() || "_-+.".contains(character);
    let mut tokens: Vec<String> = Vec::new();
    let mut is_open = false;
    for character in text.chars() {
        match tokens.last_mut() {
            Some(token) if is_open || is_word(character) && token.chars().all(is_word) => token.push(character),
            _ => tokens.push(character.to_string()),
        }
        is_open = is_open != (character == '"');
    }
    tokens
}

/// Replacements hit values three times out of four.
fn apply(tokens: &mut Vec<String>, mutation: Mutation) {
    if tokens.is_empty() {
        return;
    }
    let count = tokens.len();
    let is_value = |token: &String| token.starts_with(|first: char| first.is_ascii_digit() || "-\"".contains(first));
    let values: Vec<usize> = (0..count).filter(|&index| is_value(&tokens[index])).collect();
    let numbers: Vec<usize> = (0..count).filter(|&index| tokens[index].parse::<f64>().is_ok()).collect();
    let line_starts: Vec<usize> = (0..count).filter(|&index| index == 0 || tokens[index - 1] == "\n").collect();
    let line_of = |at: usize| {
        let start = line_starts[at % line_starts.len()];
        let end = tokens[start..].iter().position(|token| token == "\n").map_or(count, |length| start + length + 1);
        tokens[start..end].to_vec()
    };
    match mutation {
        Mutation::Delete(at) => drop(tokens.remove(at % count)),
        Mutation::Duplicate(at) => tokens.insert(at % count, tokens[at % count].clone()),
        Mutation::Replace(at, value) if at % 4 == 0 || values.is_empty() => tokens[at % count] = value,
        Mutation::Replace(at, value) => tokens[values[at % values.len()]] = value,
        Mutation::Scale(at, factor) => {
            if let Some(token) = numbers.get(at % numbers.len().max(1)).map(|&index| &mut tokens[index]) {
                *token = (factor * token.parse::<f64>().unwrap()).to_string();
            }
        }
        Mutation::Swap(one, other) => tokens.swap(one % count, other % count),
        Mutation::Repeat(at, times) => {
            let token = format!("{}, ", tokens[at % count]);
            tokens[at % count] = token.repeat(times);
        }
        Mutation::Nest(at, depth) => {
            let token = &mut tokens[at % count];
            *token = format!("{}{token}{}", "[".repeat(depth), "]".repeat(depth));
        }
        Mutation::Insert(at, line) => tokens.insert(line_starts[at % line_starts.len()], line + "\n"),
        Mutation::Copy(from, to) => {
            let at = line_starts[to % line_starts.len()];
            let line = line_of(from);
            tokens.splice(at..at, line);
        }
    }
}

fn in_range(table: &str, name: &str, number: f64) -> bool {
    let key = keys().iter().find(|key| key.table == table && key.name == name).unwrap();
    number.is_finite() && key.range().unwrap().contains(number)
}

fn check(task: &AssemblyTask) {
    let unit = |pose: &[f64; 7]| (pose[3..].iter().map(|c| c * c).sum::<f64>().sqrt() - 1.0).abs() < 1e-9;
    for pose in [&task.start, &task.goal] {
        assert!(pose[..3].iter().all(|&x| in_range("start", "position", x)) && unit(pose), "{pose:?}");
    }
    assert!(task.inertia.mass().is_none_or(|mass| in_range("body", "mass", mass)));
    assert!(task.inertia.matrix().iter().all(|entry| entry.abs() <= 1e6));
    assert!(task.inertia.matrix().cholesky().is_some());
    let impedance = &task.impedance;
    assert!(in_range("impedance", "translational_stiffness", impedance.translational_stiffness));
    assert!(in_range("impedance", "rotational_stiffness", impedance.rotational_stiffness));
    for (name, damping) in [
        ("translational_damping", &impedance.translational_damping),
        ("rotational_damping", &impedance.rotational_damping),
    ] {
        assert!(damping.iter().all(|entry| in_range("impedance", name, entry.abs())), "{damping}");
    }
    assert!(in_range("horizon", "steps", task.horizon.steps as f64));
    assert!(in_range("horizon", "time_step", task.horizon.time_step));
    assert!(!task.grasps.is_empty() && task.offsets().iter().flatten().all(|x| x.abs() <= 10.1));
    for weights in [&task.cost.reference, &task.cost.compliant] {
        assert!(in_range("cost.reference", "translational_velocity", weights.translational_velocity));
        assert!(in_range("cost.reference", "rotational_velocity", weights.rotational_velocity));
        assert!(in_range("cost.reference", "terminal_position", weights.terminal_position));
        assert!(in_range("cost.reference", "terminal_orientation", weights.terminal_orientation));
    }
    for (name, _, limit) in task.limits.named() {
        assert!(limit == f64::INFINITY || in_range("limits", name, limit));
    }
    assert!(task.horizon.steps * task.grasps.len() * task.pairs.len() <= scene::MAX_CONTACT_FORCES);
    for pair in &task.pairs {
        assert!(pair.shapes.exact_distance(&task.start).is_finite() && pair.shapes.row_count() >= 8, "{pair}");
    }
}

/// Reads a mutated scene, and says whether it is one.
fn is_scene(file: &Path, text: &str) -> bool {
    let begin = Instant::now();
    let scene = Scene::parse(Source { file, text });
    assert!(begin.elapsed() < LONGEST, "{:?}", begin.elapsed());
    match scene {
        Ok(scene) => {
            check(&scene.task(None, None).unwrap_or_else(|error| panic!("{error}")));
            let again = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
            Scene::parse(Source { file, text: &again }).unwrap_or_else(|error| panic!("{error}"));
            true
        }
        Err(error) => {
            let has_place = error.line().is_some_and(|line| (1..=text.lines().count() + 1).contains(&line));
            let about_all = ["has no [", "nested too deeply", "is empty"];
            assert!(has_place || about_all.iter().any(|words| error.message().contains(words)), "{error}");
            assert!(error.to_string().len() < 20_000 && !error.message().is_empty());
            false
        }
    }
}

#[test]
fn a_mutated_scene_is_sound_or_refused_at_its_place() {
    let mut config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = 10_000;
    }
    let cases = config.cases;
    let scenes = Cell::new(0);
    let strategy = (any::<usize>(), prop::collection::vec(mutation(), 1..6));
    let result = TestRunner::new(config).run(&strategy, |(scene, mutations)| {
        let (file, text) = &SCENES[scene % SCENES.len()];
        let mut tokens = tokens(text);
        mutations.into_iter().for_each(|mutation| apply(&mut tokens, mutation));
        scenes.set(scenes.get() + u32::from(is_scene(file, &tokens.concat())));
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
    println!("{} of {cases} mutated texts are scenes", scenes.get());
    assert!(scenes.get() > cases / 20);
}

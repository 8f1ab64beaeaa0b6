//! `docs/reference/scene.md` says what the program does. `UPDATE_DOCS=1 cargo test -p scene` writes its tables.

use std::collections::BTreeSet;

use scene::{Absent, Key, Range, Values, default_homotopy, keys, parse_homotopy};
use task::{Limits, LinearSolver};
use toml::Value;

use crate::support::{folder, parse};

const BEGIN: &str = "<!-- keys of ";
const END: &str = "<!-- end of keys -->";

fn page() -> String {
    std::fs::read_to_string(folder("docs/reference/scene.md")).unwrap()
}

/// The tables that a page has a place for, each with the text from its mark to the end mark.
fn places(page: &str) -> Vec<(&str, &str)> {
    let places = page.split(BEGIN).skip(1);
    places
        .map(|place| {
            let (table, rest) = place.split_once(" -->\n").unwrap();
            (if table == "the top" { "" } else { table }, rest.split_once(END).unwrap().0)
        })
        .collect()
}

fn row(key: &Key) -> String {
    let Key { name, values, unit, absent, meaning, .. } = key;
    format!("| `{name}` | {values} | {unit} | {absent} | {meaning} |\n")
}

fn table(name: &str) -> String {
    let mut text = "| key | values | unit | default | meaning |\n|---|---|---|---|---|\n".to_owned();
    keys().iter().filter(|key| key.table == name).for_each(|key| text += &row(key));
    text
}

#[test]
fn the_tables_of_the_page_are_those_of_the_program() {
    let page = page();
    let mut right = page.clone();
    for (name, text) in places(&page) {
        let mark = if name.is_empty() { "the top" } else { name };
        let begin = format!("{BEGIN}{mark} -->\n");
        right = right.replace(&format!("{begin}{text}{END}"), &format!("{begin}{}{END}", table(name)));
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(folder("docs/reference/scene.md"), right).unwrap();
    } else {
        assert!(page == right, "docs/reference/scene.md is old: UPDATE_DOCS=1 cargo test -p scene writes it");
    }
}

#[test]
fn every_table_of_the_program_is_on_the_page() {
    let tables: BTreeSet<&str> = keys().iter().map(|key| key.table).collect();
    let page = page();
    assert_eq!(places(&page).iter().map(|(table, _)| *table).collect::<BTreeSet<&str>>(), tables);
}

#[test]
fn the_example_of_the_page_is_a_scene_without_remarks() {
    let page = page();
    let example = page.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
    let scene = parse(example).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.warnings.is_empty() && scene.limits != Limits::NONE);
    for name in ["title", "body", "start", "goal", "impedance", "robustness", "horizon"] {
        assert!(example.contains(name));
    }
    let fragments: Vec<&str> = page.split("```toml\n").skip(2).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(fragments.len(), 5);
    let without_mesh = fragments[0].replace("mesh = \"housing.stl\"\nunit = \"mm\"", "box = [0.1, 0.1, 0.1]");
    for fragment in [&without_mesh, fragments[1], fragments[3]] {
        parse(&format!("{example}{fragment}")).unwrap_or_else(|error| panic!("{error}"));
    }
    let robot: toml::Table = toml::from_str(fragments[2]).unwrap();
    for name in robot["robot"].as_table().unwrap().keys() {
        assert!(keys().iter().any(|key| (key.table, key.name) == ("robot", name)), "{name}");
    }
    let homotopy = scene::Source { file: "h.toml".as_ref(), text: fragments[4] };
    assert_eq!(parse_homotopy(homotopy), Ok(default_homotopy()));
}

#[test]
fn declared_keys_are_unique_and_explained() {
    let mut paths = BTreeSet::new();
    for key in keys() {
        assert!(paths.insert(key.path()), "{} is declared twice", key.path());
        assert!(!key.meaning.is_empty() && !key.meaning.ends_with('.'), "{}", key.path());
        if let (Some(range), Absent::Number(default)) = (key.range(), key.absent) {
            assert!(range.contains(default), "{}", key.path());
        }
    }
}

#[test]
fn declared_defaults_and_choices_of_homotopies_are_those_that_hold() {
    let built_in: toml::Table =
        toml::from_str(&std::fs::read_to_string(folder("configs/default.toml")).unwrap()).unwrap();
    let given = built_in["homotopy"].as_table().unwrap();
    let declared: Vec<&Key> = keys().iter().filter(|key| key.table == "homotopy").collect();
    assert_eq!(declared.len(), given.len());
    for key in declared {
        match (&given[key.name], key.absent) {
            (Value::Integer(value), Absent::Number(default)) => assert_eq!(*value as f64, default),
            (Value::Float(value), Absent::Number(default)) => assert_eq!(*value, default),
            (Value::String(value), Absent::Means(default)) => assert_eq!(format!("`{value}`"), default),
            (value, _) => panic!("{}: {value}", key.path()),
        }
        if let Values::Choice(words) = key.values {
            for word in words {
                let text = format!("[homotopy]\n{} = \"{word}\"", key.name);
                assert!(parse_homotopy(scene::Source { file: "h.toml".as_ref(), text: &text }).is_ok(), "{word}");
            }
        }
    }
    let solver = keys().iter().find(|key| key.name == "linear_solver").unwrap();
    let Values::Choice(words) = solver.values else { panic!("{:?}", solver.values) };
    assert_eq!(words, LinearSolver::ALL.map(LinearSolver::name));
}

#[test]
fn ranges_contain_their_ends_where_they_say_so() {
    let closed = Range::closed(1.0, 2.0);
    assert!(closed.contains(1.0) && closed.contains(2.0) && !closed.contains(2.1) && !closed.contains(f64::NAN));
    let open = Range::open(0.0, 1.0);
    assert!(!open.contains(0.0) && !open.contains(1.0) && open.contains(0.5));
    assert_eq!(open.to_string(), "above 0 and below 1");
    assert_eq!(Range::above(0.0, 1e6).to_string(), "above 0 and at or below 1e6");
    assert_eq!(Range::closed(1e-6, 1000.0).to_string(), "between 1e-6 and 1000");
}

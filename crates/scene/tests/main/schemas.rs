//! The JSON schemas accept what the program accepts and refuse most of what it refuses.

use jsonschema::Validator;
use scene::{
    Absent, Scene, Source, default_homotopy, homotopy_schema, key, keys, parse_homotopy, resolved, scene_schema,
};
use serde_json::Value;

use crate::support::{SCENE, apparent_inertia, folder, parse, replaced};

fn validator(schema: &Value) -> Validator {
    assert!(jsonschema::meta::is_valid(schema));
    jsonschema::draft202012::new(schema).unwrap()
}

fn json(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

#[track_caller]
fn assert_valid(validator: &Validator, file: &Value, name: &str) {
    let errors: Vec<String> =
        validator.iter_errors(file).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{name}: {errors:?}");
}

/// The files of a folder of the project that the schema accepts, which must be all.
fn shipped(validator: &Validator, name: &str) -> usize {
    let files = std::fs::read_dir(folder(name)).unwrap().map(|entry| entry.unwrap().path());
    let files: Vec<_> = files.filter(|file| file.extension().is_some_and(|ending| ending == "toml")).collect();
    for file in &files {
        assert_valid(validator, &json(&std::fs::read_to_string(file).unwrap()), &file.display().to_string());
    }
    files.len()
}

#[test]
fn all_shipped_files_are_valid() {
    assert!(shipped(&validator(&scene_schema()), "scenes") >= 9);
    assert!(shipped(&validator(&homotopy_schema()), "configs") >= 4);
}

const SHAFT: &str = "box = [0.02, 0.02, 0.1]";
const STIFFNESS: &str = "translational_stiffness = 50.0";
const DIRECTIONS: &str = "offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]";
const TITLE: &str = "\n[[body.part]]";

#[test]
fn what_both_accept_is_accepted() {
    let validator = validator(&scene_schema());
    for (from, to) in [
        (SHAFT, "box = [1e-3, 1, 1000]"),
        (SHAFT, "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
        (SHAFT, "normals = [[1, 1, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]\noffsets = [1, 0, 0, 0]"),
        (STIFFNESS, "translational_stiffness = 50\ntranslational_damping = 1"),
        (STIFFNESS, "translational_stiffness = 50\ntranslational_damping = [1, 2, 3]"),
        (STIFFNESS, "translational_stiffness = 50\ntranslational_damping = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
        (TITLE, "\ntitle = \"ä\"\n[homotopy]\nmu_rate = 1\n[ipopt]\nmax_iter = 10\n[[body.part]]"),
        ("[0.6, -0.8, 0]", "[0.7071, -0.7071, 0]"),
        (DIRECTIONS, "coverage = \"ball\""),
        (DIRECTIONS, "coverage = \"disc\"\ninsertion_axis = [0, 0, 1]"),
        (DIRECTIONS, "insertion_axis = [0, 0.6, 0.8]"),
    ] {
        let text = replaced(from, to);
        parse(&text).unwrap_or_else(|error| panic!("{error}"));
        assert_valid(&validator, &json(&text), to);
    }
    let mesh = json(&replaced(SHAFT, "mesh = \"shaft.stl\"\nunit = \"mm\""));
    assert_valid(&validator, &mesh, "a mesh that is not there");
    assert_valid(&validator, &json(&replaced(TITLE, "\nhomotopy = \"h.toml\"\n[[body.part]]")), "a homotopy file");
}

#[test]
fn wrong_scenes_are_refused() {
    let validator = validator(&scene_schema());
    assert_valid(&validator, &json(SCENE), "right");
    #[rustfmt::skip]
    let wrong = [
        // Keys: unknown, missing, not together.
        ("steps = 10", "steps = 10\nstepps = 10"),
        (TITLE, "\nunits = \"mm\"\n[[body.part]]"),
        ("[goal]\nposition = [0, 0, 0]", "[goal]"),
        ("name = \"shaft\"\n", ""),
        (SHAFT, ""),
        (SHAFT, "box = [1, 1, 1]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
        (SHAFT, "normals = [[1, 1, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]"),
        (SHAFT, "box = [1, 1, 1]\noffsets = [1, 0, 0, 0]"),
        (SHAFT, "box = [1, 1, 1]\nunit = \"mm\""),
        (SHAFT, "mesh = \"shaft.stl\""),
        (TITLE, "\n[ipopt]\ntol = 1\n[[body.part]]"),
        (TITLE, "\nhomotopy = \"h.toml\"\n[ipopt]\ntol = 1\n[[body.part]]"),
        (DIRECTIONS, "offset_directions = [[0, 0, 1]]\ncoverage = \"disc\""),
        (DIRECTIONS, "offset_directions = [[0, 0, 1]]\ninsertion_axis = [0, 0, 1]"),
        (DIRECTIONS, "coverage = \"ball\"\ninsertion_axis = [0, 0, 1]"),
        (DIRECTIONS, "rotation_axes = [[0, 0, 1]]"),
        // Values out of range.
        ("steps = 10", "steps = 0"),
        ("time_step = 0.04", "time_step = 11"),
        (STIFFNESS, "translational_stiffness = -1"),
        (STIFFNESS, "translational_stiffness = 1\ntranslational_damping = -1"),
        (STIFFNESS, "translational_stiffness = 1\ntranslational_damping = [1, 1, 1e8]"),
        ("[0.6, -0.8, 0]", "[6, -8, 0]"),
        (SHAFT, "box = [0, 1, 1]"),
        (TITLE, "\n[homotopy]\ntau_rate = 1\n[[body.part]]"),
        (TITLE, "\n[homotopy]\nhessian = \"none\"\n[[body.part]]"),
        (TITLE, "\ntitle = \" \"\n[[body.part]]"),
        // Values of another kind, lists of another length.
        (SHAFT, "box = [1, 1]"),
        (SHAFT, "box = [1, 1, 1, 1]"),
        (SHAFT, "box = \"1 1 1\""),
        (SHAFT, "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"),
        (SHAFT, "mesh = \"\"\nunit = \"mm\""),
        (SHAFT, "mesh = \"shaft.stl\"\nunit = \"miles\""),
        ("steps = 10", "steps = 10.5"),
        ("orientation = [1, 0, 0, 0]", "orientation = [1, 0, 0]"),
        ("[[0.6, -0.8, 0], [0, 0, 0]]", "[]"),
        ("[[0.6, -0.8, 0], [0, 0, 0]]", "[0.6, -0.8, 0]"),
        ("offset_magnitude = 0.02", "offset_magnitude = \"20 mm\""),
        ("[[start]]", "[start]"),
        // Options of Ipopt.
        (TITLE, "\n[homotopy]\n[ipopt]\ntoll = 1\n[[body.part]]"),
        (TITLE, "\n[homotopy]\n[ipopt]\ntol = 0\n[[body.part]]"),
        (TITLE, "\n[homotopy]\n[ipopt]\nmu_strategy = \"fast\"\n[[body.part]]"),
        (TITLE, "\n[homotopy]\n[ipopt]\nmu_init = 1\n[[body.part]]"),
        (TITLE, "\n[homotopy]\n[ipopt]\nnlp_scaling_method = \"user-scaling\"\n[[body.part]]"),
    ];
    for (from, to) in wrong {
        let text = replaced(from, to);
        assert!(parse(&text).is_err(), "the program accepts {to}");
        assert!(!validator.is_valid(&json(&text)), "the schema accepts {to}");
    }
}

#[test]
fn wrong_homotopies_are_refused() {
    let validator = validator(&homotopy_schema());
    for right in ["", "[homotopy]", "[ipopt]\ntol = 1e-3", "[homotopy]\niterations = 3\nmu_init = 1"] {
        assert_valid(&validator, &json(right), right);
    }
    for wrong in [
        "[homotopie]",
        "[homotopy]\niterations = 0",
        "[homotopy]\nmu_init = 1e-12",
        "[homotopy]\nlinear_solver = \"ma99\"",
        "[ipopt]\nmax_iter = \"many\"",
        "[body]\nmass = 1",
    ] {
        assert!(parse_homotopy(Source { file: "h.toml".as_ref(), text: wrong }).is_err(), "{wrong}");
        assert!(!validator.is_valid(&json(wrong)), "{wrong}");
    }
}

/// A scene in which every table is given, and nearly every key.
fn complete() -> Value {
    let text = format!(
        "{SCENE}[limits]\nforce = 100\n[[gripper.part]]\nname = 'jaw'\nbox = [0.1, 0.1, 0.1]\n[robot]\napparent_inertia = {}\n",
        apparent_inertia([7.0, 7.0, 8.0, 1.0, 1.0, 1.0])
    );
    let scene = Scene::parse(Source { file: "test.toml".as_ref(), text: &text }).unwrap();
    let mut complete = json(&resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy()));
    for name in ["grasp", "base", "stiffness_range", "command", "sensor"] {
        complete["robot"][name] = Value::Object(serde_json::Map::new());
    }
    complete["robot"]["force_mode"] = serde_json::json!({ "translational_gain": 1e-4, "rotational_gain": 0.02 });
    complete
}

/// Where the tables are in a scene, by the names under which their keys are declared.
fn place(table: &str) -> String {
    match table {
        "" => String::new(),
        "part" => "/environment/part/0".to_owned(),
        "start" => "/start/0".to_owned(),
        table => format!("/{}", table.replace('.', "/")),
    }
}

#[test]
fn every_table_of_a_scene_is_in_the_schema_with_all_its_keys() {
    let (validator, complete) = (validator(&scene_schema()), complete());
    assert_valid(&validator, &complete, "the resolved scene");
    for declared in keys() {
        let changed = |change: &dyn Fn(&mut serde_json::Map<String, Value>)| {
            let mut scene = complete.clone();
            let table = scene.pointer_mut(&place(declared.table)).unwrap_or_else(|| panic!("[{}]", declared.table));
            change(table.as_object_mut().unwrap());
            scene
        };
        let without = changed(&|table| _ = table.remove(declared.name));
        if declared.absent == Absent::Refused {
            assert!(!validator.is_valid(&without), "{} may be missing", declared.path());
        }
        // A value that no key takes is refused with the name of the key, and not as an unknown key.
        let wrong = changed(&|table| _ = table.insert(declared.name.to_owned(), true.into()));
        let errors: Vec<String> =
            validator.iter_errors(&wrong).map(|error| error.instance_path().to_string()).collect();
        assert!(errors.contains(&format!("{}/{}", place(declared.table), declared.name)), "{}", declared.path());
        let unknown = changed(&|table| _ = table.insert("unknown".to_owned(), 1.into()));
        assert!(!validator.is_valid(&unknown), "[{}]", declared.table);
    }
}

#[test]
fn a_property_says_what_its_key_means() {
    let schema = scene_schema();
    let mass = &schema["properties"]["body"]["properties"]["mass"];
    assert_eq!((&mass["minimum"], &mass["maximum"], &mass["default"]), (&1e-6.into(), &1e6.into(), &1.0.into()));
    let meaning = key("body", "mass").meaning;
    assert_eq!(mass["description"], format!("{meaning}\n\nnumber between 1e-6 and 1e6 (kg); by default: 1"));
    let homotopy = &schema["properties"]["homotopy"]["properties"];
    assert_eq!(homotopy["hessian"]["default"], "exact");
    assert_eq!(homotopy["tau_rate"]["exclusiveMaximum"], 1.0);
    let ipopt = &schema["properties"]["ipopt"]["properties"];
    assert!(ipopt["max_iter"].is_object() && ipopt["linear_solver"].is_null(), "only options that may be set");
}

/// All texts under a keyword, at any depth.
fn texts<'schema>(schema: &'schema Value, keyword: &str, found: &mut Vec<&'schema str>) {
    match schema {
        Value::Object(entries) => {
            found.extend(entries.get(keyword).and_then(Value::as_str));
            entries.values().for_each(|entry| texts(entry, keyword, found));
        }
        Value::Array(list) => list.iter().for_each(|entry| texts(entry, keyword, found)),
        _ => {}
    }
}

#[test]
fn descriptions_are_plain_text() {
    assert!(keys().iter().any(|key| key.meaning.contains("](")), "some meanings refer to pages");
    let (scene, homotopy) = (scene_schema(), homotopy_schema());
    let mut found = Vec::new();
    [&scene, &homotopy].iter().for_each(|schema| texts(schema, "description", &mut found));
    assert!(found.len() > keys().len());
    for text in found {
        assert!(!text.contains("](") && !text.contains('`') && !text.contains(".md"), "{text}");
    }
    let friction = &scene["properties"]["contact"]["properties"]["friction"]["description"];
    let expected = "Coulomb's coefficient of friction in the plan, or several that it tolerates at once\n\nnumber";
    assert!(friction.as_str().unwrap().starts_with(expected), "{friction}");
}

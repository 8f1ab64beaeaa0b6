//! Scenes to begin with.

use std::path::Path;

use scene::{Scene, SceneError, keys, scene_schema};
use scene_templates::{Axis, FilePair, StarterPoses, StarterValues, starter_scene};
use task::{Coverage, Pose};

use crate::parse;

/// A text STL file with a box between two corners.
fn stl(low: [f64; 3], high: [f64; 3]) -> String {
    let corner = |index: usize| -> [f64; 3] {
        std::array::from_fn(|axis| if index >> axis & 1 == 1 { high[axis] } else { low[axis] })
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let facet = |triangle: [usize; 3]| {
        let lines = triangle.map(corner).map(|[x, y, z]| format!("vertex {x} {y} {z}\n")).concat();
        format!("facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
    };
    format!("solid box\n{}endsolid box\n", triangles.map(facet).collect::<String>())
}

/// A folder with a body of 20 x 30 x 50 mm on a plate.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    std::fs::create_dir(folder.path().join("meshes")).unwrap();
    write("meshes/body.stl", stl([90.0, 0.0, 1.0], [110.0, 30.0, 51.0]));
    write("meshes/plate.STL", stl([0.0, -100.0, -10.0], [200.0, 100.0, 0.0]));
    folder
}

fn pair(folder: &Path) -> FilePair {
    FilePair {
        body: folder.join("meshes/body.stl"),
        environment: folder.join("meshes/plate.STL"),
        unit: Some("mm".to_owned()),
        ..FilePair::default()
    }
}

/// A start above the place of the body, or beside it, and a goal lifted a little.
fn out(axis: &str) -> StarterPoses {
    let axis = Axis::from_name(axis).unwrap();
    StarterPoses { starts: vec![axis.times(0.05)], goal: axis.times(2e-4) }
}

fn written(file: &Path, files: &FilePair, poses: &StarterPoses) -> Result<String, SceneError> {
    starter_scene(file, Some((&files.read()?, poses)), &StarterValues::default())
}

fn example() -> String {
    starter_scene("my.toml".as_ref(), None, &StarterValues::default()).unwrap()
}

fn from_meshes(file: &Path, meshes: &FilePair) -> Result<Scene, SceneError> {
    let text = written(file, meshes, &out("z"))?;
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(file, text).unwrap();
    Scene::load(file)
}

/// The text with all keys in use that are there as comments.
fn with_all_keys(text: &str) -> String {
    let used = |line: &str| match line.strip_prefix('#') {
        Some(key) if key.starts_with(|first: char| first.is_ascii_lowercase() || first == '[') => format!("{key}\n"),
        _ => format!("{line}\n"),
    };
    text.lines().map(used).collect()
}

#[test]
fn the_starter_is_a_scene_with_every_key_explained() {
    let text = example();
    let scene = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
    let task = scene.task(None, None).unwrap();
    assert!((task.clearance(&task.goal) - 5e-4).abs() < 1e-9 && task.clearance(&task.start) > 0.01);
    for key in keys().iter().filter(|key| ["impedance", "robustness", "horizon"].contains(&key.table)) {
        let is_given = text.contains(&format!("\n{} = ", key.name));
        assert_eq!(text.contains(&format!("# {}", key.meaning)), is_given, "{}", key.path());
    }
    assert!(text.lines().all(|line| line.len() <= 170), "lines that are not read");
}

#[test]
fn keys_in_comments_can_be_used() {
    let text = with_all_keys(&example());
    let scene = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((scene.title.as_str(), scene.pairs.len()), ("my scene", 1));
    assert_eq!((scene.limits.contact_force, scene.limits.translational_velocity), (60.0, 0.25));
    let validator = jsonschema::draft202012::new(&scene_schema()).unwrap();
    let file: toml::Table = toml::from_str(&text).unwrap();
    assert!(validator.is_valid(&serde_json::to_value(file).unwrap()));
}

#[test]
fn poses_of_meshes_are_those_of_their_boxes() {
    let folder = folder();
    let scene = from_meshes(&folder.path().join("my.toml"), &pair(folder.path())).unwrap();
    let near = |pose: &Pose, position: [f64; 3]| {
        let close = pose.iter().zip(position).all(|(one, other)| (one - other).abs() < 1e-9);
        assert!(close && pose[3..] == [1.0, 0.0, 0.0, 0.0], "{pose:?}");
    };
    near(&scene.goal, [0.1, 0.015, 0.0262]);
    near(&scene.starts[0].pose, [0.1, 0.015, 0.076]);
    let task = scene.task(None, None).unwrap();
    let mut mated = scene.goal;
    mated.0[2] -= 2e-4;
    assert!((task.clearance(&mated) - 0.001).abs() < 1e-6, "the body is where its mesh is, but for a little lift");
    assert!(scene.body[0].shape.center().iter().all(|coordinate| coordinate.abs() < 1e-6));
    assert_eq!((scene.offset_magnitude, scene.limits.contact_force, scene.position_tolerance), (0.001, 60.0, None));
    assert_eq!(scene.coverage, Coverage::Disc { axis: [0.0, 0.0, 1.0] });
    for (axis, position) in [("-z", [0.1, 0.015, -0.024]), ("+X", [0.15, 0.015, 0.026]), ("-y", [0.1, -0.035, 0.026])] {
        let text = written("my.toml".as_ref(), &pair(folder.path()), &out(axis)).unwrap();
        let start: toml::Table = toml::from_str(&text).unwrap();
        let found = start["start"][0]["position"].as_array().unwrap();
        let is_near = |(one, other): (&toml::Value, f64)| (one.as_float().unwrap() - other).abs() < 1e-9;
        assert!(found.iter().zip(position).all(is_near), "{axis}: {found:?}");
    }
}

#[test]
fn meshes_are_found_from_the_folder_of_the_scene() {
    let folder = folder();
    for (file, mesh) in [
        ("my.toml", "meshes/body.stl"),
        ("meshes/my.toml", "body.stl"),
        ("scenes/new/my.toml", "../../meshes/body.stl"),
        ("scenes/../my.toml", "meshes/body.stl"),
    ] {
        let file = folder.path().join(file);
        std::fs::create_dir_all(folder.path().join("scenes")).unwrap();
        from_meshes(&file, &pair(folder.path())).unwrap_or_else(|error| panic!("{error}"));
        let text = std::fs::read_to_string(file).unwrap();
        assert!(text.contains(&format!("mesh = \"{mesh}\"")), "{mesh}");
    }
}

#[test]
fn meshes_that_cannot_be_used_are_refused() {
    let folder = folder();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("part.ply", b"v 0 0 0\n");
    write("none.stl", b"solid none\nendsolid none\n");
    write("text.stl", b"hello");
    write("flat.stl", stl([0.0; 3], [1.0, 1.0, 0.0]).as_bytes());
    let right = pair(folder.path());
    let file = folder.path().join("my.toml");
    for (name, words) in [
        ("gone.stl", "gone.stl: mesh: cannot be read: No such file"),
        ("part.ply", "part.ply: mesh: 'ply' is not a known format: use .stl or .obj"),
        ("none.stl", "none.stl: mesh: it has no triangles"),
        ("flat.stl", "flat.stl: mesh: "),
        ("text.stl", "text.stl: mesh: "),
        ("meshes", "is not a known format"),
    ] {
        let wrong = folder.path().join(name);
        for meshes in [
            FilePair { body: wrong.clone(), ..right.clone() },
            FilePair { environment: wrong.clone(), ..right.clone() },
        ] {
            let error = written(&file, &meshes, &out("z")).expect_err(name).to_string();
            assert!(error.contains(words), "{error}");
        }
    }
    let feet = FilePair { unit: Some("feet".to_owned()), ..right };
    let error = written(&file, &feet, &out("z")).unwrap_err().to_string();
    assert!(error.contains("unknown unit `feet`: choose one of m, cm, mm, inch"), "{error}");
}

#[test]
fn models_need_no_unit() {
    let folder = folder();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let link = |name: &str| {
        format!(
            "<link name='{name}'><collision><origin xyz='0.1 0.015 0.026' rpy='0 0 1.5707963267948966'/>
             <geometry><box size='0.03 0.02 0.05'/></geometry></collision></link>"
        )
    };
    write("body.urdf", &format!("<robot>{}</robot>", link("a")));
    write("two.urdf", &format!("<robot>{}{}</robot>", link("a"), link("b")));
    let right = pair(folder.path());
    let body = |name: &str| FilePair { body: folder.path().join(name), ..right.clone() };
    let scene = from_meshes(&folder.path().join("my.toml"), &body("body.urdf")).unwrap();
    let of_mesh = from_meshes(&folder.path().join("mesh.toml"), &right).unwrap();
    for (one, other) in [(scene.goal, of_mesh.goal), (scene.starts[0].pose, of_mesh.starts[0].pose)] {
        assert!(one.iter().zip(other.iter()).all(|(one, other)| (one - other).abs() < 1e-9), "{one:?} {other:?}");
    }
    let without_unit = FilePair { unit: None, environment: folder.path().join("body.urdf"), ..body("body.urdf") };
    from_meshes(&folder.path().join("models.toml"), &without_unit).unwrap();
    let refusal = |files: &FilePair| written("my.toml".as_ref(), files, &out("z")).unwrap_err().to_string();
    assert!(
        refusal(&FilePair { unit: None, ..right.clone() }).contains("a mesh needs its unit (--unit): m, cm, mm, inch")
    );
    assert!(refusal(&body("two.urdf")).contains("has several links; choose one with --link: a, b"));
    let second = FilePair { body_link: Some("b".to_owned()), ..body("two.urdf") };
    from_meshes(&folder.path().join("second.toml"), &second).unwrap();
    let third = FilePair { body_link: Some("c".to_owned()), ..body("two.urdf") };
    assert!(refusal(&third).contains("has no link `c` with collision shapes"));
    let of_mesh = FilePair { body_link: Some("b".to_owned()), ..right };
    assert!(refusal(&of_mesh).contains("a mesh has no links, such as `b`"));
}

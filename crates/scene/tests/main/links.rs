//! Parts that are links of SDF, URDF and MJCF files.

use proptest::prelude::*;
use scene::{Scene, SceneError, Source};

use crate::support::replaced;

/// The scene with a model file as its environment, and these keys of the part.
fn load(file: &str, model: &str, keys: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(file), model).unwrap();
    std::fs::write(folder.path().join("wedge.obj"), WEDGE).unwrap();
    std::fs::write(folder.path().join("step.obj"), STEP).unwrap();
    let wall = "box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]";
    let text = replaced(wall, &format!("model = \"{file}\"\n{keys}"));
    Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
}

/// A tetrahedron with edges of 1 along the axes.
const WEDGE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
/// A step of 2 x 2 x 1 without a quarter: not convex.
const STEP: &str = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\n\
    v 0 2 1\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";

/// A URDF with one link of these collisions.
fn urdf(collisions: &str) -> String {
    format!("<robot name='r'>\n<link name='tool'>{collisions}</link></robot>")
}

fn collision(name: &str, origin: &str, geometry: &str) -> String {
    format!("<collision name='{name}'><origin {origin}/><geometry>{geometry}</geometry></collision>")
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.environment.iter().map(|part| part.name.as_str()).collect()
}

/// Numbers of facets and volumes (cm^3) of the parts.
fn facets_and_volumes(scene: &Scene) -> Vec<(usize, f64)> {
    scene.environment.iter().map(|part| (part.shape.normals().len(), 1e6 * part.shape.volume())).collect()
}

fn is_near(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() < 1e-6
}

#[test]
fn all_shapes_of_a_link_are_parts_that_are_counted() {
    let model = urdf(
        &[
            collision("block", "xyz='0.1 0 0'", "<box size='0.02 0.02 0.02'/>"),
            collision("step", "xyz='0.2 0 0'", "<mesh filename='step.obj' scale='0.01 0.01 0.01'/>"),
            collision("rod", "xyz='0.3 0 0'", "<cylinder radius='0.01' length='0.03'/>"),
        ]
        .concat(),
    );
    let scene = load("model.urdf", &model, "facets = 12").unwrap();
    assert_eq!(names(&scene), ["wall.1", "wall.2", "wall.3", "wall.4"]);
    let found = facets_and_volumes(&scene);
    assert!(found[0].0 == 6 && is_near(found[0].1, 8.0), "{found:?}");
    // Around the cylinder.
    assert!(found[3].0 == 14 && is_near(found[3].1, 36.0 * (std::f64::consts::PI / 12.0).tan()), "{found:?}");
    let shapes: Vec<_> =
        scene.environment_meshes.iter().map(|mesh| (mesh.shape.as_deref(), mesh.parts.clone())).collect();
    assert_eq!(shapes, [(Some("block"), 0..1), (Some("step"), 1..3), (Some("rod"), 3..4)]);
    assert!(scene.environment_meshes.iter().all(|mesh| mesh.name == "wall" && mesh.file.ends_with("model.urdf")));
}

#[test]
fn a_link_of_one_convex_shape_is_one_part() {
    let model = urdf(&collision("block", "xyz='0.1 0 0'", "<box size='0.02 0.04 0.06'/>"));
    let scene = load("model.urdf", &model, "link = \"tool\"\nposition = [0, 0, 1]").unwrap();
    assert_eq!(names(&scene), ["wall"]);
    let [center, size] = [scene.environment[0].shape.center(), [scene.environment[0].shape.size(); 3]];
    assert!((center[0] - 0.1).abs() < 1e-9 && (center[2] - 1.0).abs() < 1e-9 && is_near(size[0], 0.06), "{center:?}");
}

#[test]
fn a_shape_inside_of_another_one_is_no_part() {
    let model = urdf(
        &[
            collision("core", "xyz='0.1 0 0'", "<box size='0.01 0.01 0.01'/>"),
            collision("block", "xyz='0.1 0 0'", "<box size='0.02 0.02 0.02'/>"),
            collision("twin", "xyz='0.1 0 0'", "<box size='0.02 0.02 0.02'/>"),
            collision("beside", "xyz='0.115 0 0'", "<box size='0.02 0.02 0.02'/>"),
        ]
        .concat(),
    );
    let scene = load("model.urdf", &model, "").unwrap();
    assert_eq!(names(&scene), ["wall.1", "wall.2"]);
    let parts: Vec<_> = scene.environment_meshes.iter().map(|mesh| mesh.parts.clone()).collect();
    assert_eq!(parts, [0..0, 0..1, 1..1, 1..2]);
}

#[test]
fn a_clearance_is_taken_off_all_shapes() {
    let model = urdf(
        &[
            collision("block", "xyz='0.1 0 0'", "<box size='0.02 0.04 0.06'/>"),
            collision("rod", "xyz='0.3 0 0'", "<cylinder radius='0.01' length='0.03'/>"),
        ]
        .concat(),
    );
    let found = facets_and_volumes(&load("m.urdf", &model, "clearance = \"1 mm\"\nfacets = 8").unwrap());
    assert!(is_near(found[0].1, 1.8 * 3.8 * 5.8), "{found:?}");
    assert!(is_near(found[1].1, 0.9 * 0.9 * 2.8 * 8.0 * (std::f64::consts::PI / 8.0).tan()), "{found:?}");
    let error = load("m.urdf", &model, "clearance = \"10 mm\"").unwrap_err();
    assert!(error.message().contains("m.urdf, shape `block`: no material is left"), "{error}");
}

#[test]
fn density_gives_the_mass_of_shapes_that_do_not_overlap() {
    let body = |collisions: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("m.urdf"), urdf(collisions)).unwrap();
        let text = replaced("box = [0.02, 0.02, 0.1]", "model = \"m.urdf\"\ndensity = 1000");
        Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
    };
    let block = |name: &str, x: f64| collision(name, &format!("xyz='{x} 0 0'"), "<box size='0.02 0.02 0.02'/>");
    let inertia = body(&(block("a", -0.01) + &block("b", 0.01))).unwrap().inertia;
    assert!(is_near(inertia.mass().unwrap(), 0.016), "{inertia:?}");
    assert!(is_near(inertia.rotational()[(0, 0)], 0.016 * (0.02f64.powi(2) + 0.02f64.powi(2)) / 12.0));
    assert!(is_near(inertia.rotational()[(1, 1)], 0.016 * (0.04f64.powi(2) + 0.02f64.powi(2)) / 12.0));
    let error = body(&(block("a", -0.009) + &block("b", 0.009))).unwrap_err();
    assert!(error.message().contains("shape `b`: it may overlap with shape `a`"), "{error}");
}

#[test]
fn pairs_may_name_a_link_or_one_of_its_parts() {
    let model = urdf(
        &[
            collision("block", "xyz='0.1 0 0'", "<box size='0.02 0.02 0.02'/>"),
            collision("rod", "xyz='0.3 0 0'", "<cylinder radius='0.01' length='0.03'/>"),
        ]
        .concat(),
    );
    let pairs = |name: &str| {
        let keys = format!("[contact]\npairs = [[\"shaft\", \"{name}\"]]");
        load("model.urdf", &model, &keys).unwrap().pairs
    };
    assert_eq!(pairs("wall"), [(0, 0), (0, 1)]);
    assert_eq!(pairs("wall.2"), [(0, 1)]);
}

#[test]
fn what_is_wrong_with_a_model_is_said_where_it_is() {
    let block = collision("block", "xyz='0 0 0'", "<box size='1 1 1'/>");
    let two =
        format!("<robot><link name='one'>{block}</link>\n<link name='two'>{block}</link><link name='bare'/></robot>");
    let twins = two.replace("'two'", "'one'");
    // In the scene: file or link.
    for (model, keys, place, words) in [
        (two.as_str(), "", (7, 9), "has several links; choose one with `link`: one, two"),
        (&two, "link = \"twoo\"", (8, 8), "has no link `twoo` with collision shapes, did you mean `two`?"),
        (&two, "link = \"bare\"", (8, 8), "has no link `bare` with collision shapes"),
        (&twins, "link = \"one\"", (8, 8), "has 2 links `one`: rename all but one"),
        ("<robot/>", "", (7, 9), "has no link with collision shapes"),
        (
            "<sdf><model><link><collision><geometry><empty/></geometry></collision></link></model></sdf>",
            "",
            (7, 9),
            "all collision shapes of the link are empty",
        ),
    ] {
        let error = load("m.urdf", model, keys).unwrap_err();
        assert!(error.message().contains(words), "{error}");
        assert_eq!((error.line(), error.column()), (Some(place.0), Some(place.1)), "{error}");
        assert!(error.headline().contains("scene.toml:"), "{error}");
    }
    // In the model.
    for (model, place, words) in [
        (urdf(&collision("ball", "", "<sphere radius='1'/>")), (2, 62), "part `wall`: sphere is not supported"),
        (urdf(&collision("gone", "", "<mesh filename='gone.stl'/>")), (2, 19), "part `wall`: shape `gone`: mesh "),
        (
            urdf(&collision("dae", "", "<mesh filename='a.dae'/>")),
            (2, 19),
            "'dae' is not a known format: use .stl or .obj",
        ),
        ("<robot>\n<link>".to_owned(), (1, 1), "part `wall`: is not well-formed XML"),
    ] {
        let error = load("m.urdf", &model, "").unwrap_err();
        assert!(error.message().contains(words), "{error}");
        assert!(error.headline().contains("m.urdf:"), "{error}");
        assert_eq!((error.line(), error.column()), (Some(place.0), Some(place.1)), "{error}");
    }
    // Files that are not there, keys that do not belong.
    for (from, keys, words) in [
        ("box = [0.1, 0.1, 0.1]", "model = \"gone.sdf\"", "the model cannot be read: there is no such file"),
        ("box = [0.1, 0.1, 0.1]", "model = \"\"", "part.model is empty"),
        ("box = [0.1, 0.1, 0.1]", "model = \"m.sdf\"\nunit = \"mm\"", "`unit` belongs to `mesh`"),
        ("box = [0.1, 0.1, 0.1]", "box = [0.1, 0.1, 0.1]\nlink = \"a\"", "`link` belongs to `model`"),
        ("box = [0.1, 0.1, 0.1]", "box = [0.1, 0.1, 0.1]\nfacets = 8", "`facets` belongs to `mesh` or `model`"),
        ("box = [0.1, 0.1, 0.1]", "box = [0.1, 0.1, 0.1]\nmodel = \"a\"", "exactly one of"),
    ] {
        let error = crate::support::parse(&replaced(from, keys)).unwrap_err();
        assert!(error.message().contains(words), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_box_of_any_format_is_the_box_of_a_scene(
        edges in prop::array::uniform3(0.01f64..0.2),
        position in prop::array::uniform3(-0.2f64..0.2),
        [roll, pitch, yaw] in prop::array::uniform3(-3.0f64..3.0),
    ) {
        let ([a, b, c], [x, y, z]) = (edges, position);
        let sdf = format!("<sdf><model><link name='l'><collision><pose>{x} {y} {z} {roll} {pitch} {yaw}</pose><geometry>\
            <box><size>{a} {b} {c}</size></box></geometry></collision></link></model></sdf>");
        let urdf = urdf(&collision("s", &format!("xyz='{x} {y} {z}' rpy='{roll} {pitch} {yaw}'"),
            &format!("<box size='{a} {b} {c}'/>")));
        let mjcf = format!("<mujoco><compiler angle='radian' eulerseq='XYZ'/><worldbody><geom type='box' \
            pos='{x} {y} {z}' euler='{roll} {pitch} {yaw}' size='{} {} {}'/></worldbody></mujoco>", 0.5 * a, 0.5 * b, 0.5 * c);
        let quaternion = nalgebra::UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        let expected = collision::Polytope::from_box(edges).unwrap()
            .placed(position, [quaternion.w, quaternion.i, quaternion.j, quaternion.k]);
        for (file, text) in [("a.sdf", sdf), ("a.urdf", urdf), ("a.xml", mjcf)] {
            let scene = load(file, &text, "").unwrap();
            let shape = &scene.environment[0].shape;
            prop_assert_eq!((scene.environment.len(), shape.normals().len(), shape.vertices().len()), (1, 6, 8));
            for corner in expected.vertices() {
                let distance = |other: &[f64; 3]| (0..3).map(|axis| (corner[axis] - other[axis]).powi(2)).sum::<f64>();
                prop_assert!(shape.vertices().iter().any(|other| distance(other) < 1e-20), "{} {:?}", file, corner);
            }
        }
    }
}

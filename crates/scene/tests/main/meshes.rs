//! Parts from meshes: convex or not, round or not, and files that are none.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::Matrix3;
use scene::{KnownMeshes, Scene, SceneError, Source};

use crate::support::replaced;

type Triangle = [[f64; 3]; 3];

/// The scene with a mesh file of these bytes.
fn load(bytes: &[u8]) -> Result<Scene, SceneError> {
    load_with(bytes, "unit = \"mm\"")
}

/// The same with these keys of the mesh.
fn load_with(bytes: &[u8], keys: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("wall.stl"), bytes).unwrap();
    let wall = "box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]";
    let text = replaced(wall, &format!("mesh = \"wall.stl\"\n{keys}"));
    Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
}

/// A known mesh is that of the scene where file and unit are the same.
#[test]
fn a_known_mesh_is_not_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("wall.stl");
    std::fs::write(&file, binary(&prism(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]], &fan(4), 10.0)))
        .unwrap();
    let mut known = KnownMeshes::default();
    let solid = known.solid(&file, 1e-3).unwrap();
    known.add(&file, 1e-3, Arc::clone(&solid));
    let wall = "box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]";
    let solid_in = |unit: &str| {
        let text = replaced(wall, &format!("mesh = \"wall.stl\"\nunit = \"{unit}\""));
        let scene = Scene::parse_knowing(Source { file: &folder.path().join("scene.toml"), text: &text }, &known);
        Arc::clone(&scene.unwrap().environment_meshes[0].solid)
    };
    assert!(Arc::ptr_eq(&solid_in("mm"), &solid));
    let larger = solid_in("cm").bounding_box();
    assert!((larger[1][0] - larger[0][0] - 0.1).abs() < 1e-12, "another unit is read");
}

/// A message about the mesh, at its line of the scene.
fn refusal(bytes: &[u8]) -> String {
    let error = load(bytes).unwrap_err();
    assert_eq!((error.line(), error.column()), (Some(7), Some(8)), "{error}");
    error.message().to_owned()
}

/// Numbers of facets and vertices of the shape.
fn size(bytes: &[u8]) -> (usize, usize) {
    let scene = load(bytes).unwrap_or_else(|error| panic!("{error}"));
    let shape = &scene.environment[0].shape;
    (shape.normals().len(), shape.vertices().len())
}

fn binary(triangles: &[Triangle]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(triangle.as_flattened().iter().flat_map(|coordinate| (*coordinate as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// The same surface with its triangles the other way round.
fn inverted(triangles: &[Triangle]) -> Vec<Triangle> {
    triangles.iter().map(|&[a, b, c]| [a, c, b]).collect()
}

fn quad([a, b, c, d]: [[f64; 3]; 4]) -> [Triangle; 2] {
    [[a, b, c], [a, c, d]]
}

/// A prism over a polygon with a triangulation of the polygon.
fn prism(polygon: &[[f64; 2]], caps: &[[usize; 3]], height: f64) -> Vec<Triangle> {
    let corner = |index: usize, z: f64| [polygon[index][0], polygon[index][1], z];
    let sides = (0..polygon.len()).flat_map(|from| {
        let to = (from + 1) % polygon.len();
        quad([corner(from, 0.0), corner(to, 0.0), corner(to, height), corner(from, height)])
    });
    let caps = caps.iter().flat_map(|&[a, b, c]| {
        [[corner(a, height), corner(b, height), corner(c, height)], [corner(a, 0.0), corner(c, 0.0), corner(b, 0.0)]]
    });
    sides.chain(caps).collect()
}

/// Triangles from the first corner of a polygon that sees all of it.
fn fan(corners: usize) -> Vec<[usize; 3]> {
    (1..corners - 1).map(|corner| [0, corner, corner + 1]).collect()
}

/// A cylinder, turned and moved so that no coordinate is a round number.
fn cylinder(sides: usize) -> Vec<Triangle> {
    let angle = |side: usize| TAU * side as f64 / sides as f64;
    let polygon: Vec<[f64; 2]> = (0..sides).map(|side| [10.0 * angle(side).cos(), 10.0 * angle(side).sin()]).collect();
    let (sine, cosine) = 0.4f64.sin_cos();
    let placed = |[x, y, z]: [f64; 3]| [x + 31.7, cosine * y - sine * z - 12.3, sine * y + cosine * z + 101.9];
    prism(&polygon, &fan(sides), 30.0).into_iter().map(|triangle| triangle.map(placed)).collect()
}

/// A box of 30 x 30 x 20 with a pocket of 10 x 10 in the middle of its top.
fn pocket(depth: f64) -> Vec<Triangle> {
    let square = |low: f64, high: f64, z: f64| [[low, low, z], [high, low, z], [high, high, z], [low, high, z]];
    let between = |one: [[f64; 3]; 4], other: [[f64; 3]; 4]| {
        (0..4).flat_map(move |from| {
            let to = (from + 1) % 4;
            quad([one[from], one[to], other[to], other[from]])
        })
    };
    let (bottom, top) = (square(0.0, 30.0, 0.0), square(0.0, 30.0, 20.0));
    let (rim, floor) = (square(10.0, 20.0, 20.0), square(10.0, 20.0, 20.0 - depth));
    let walls = between(bottom, top).chain(between(top, rim)).chain(between(rim, floor));
    walls.chain(quad(floor)).chain(inverted(&quad(bottom))).collect()
}

#[test]
fn a_round_part_has_as_many_facets_as_asked_for() {
    for sides in [16, 64, 300] {
        let triangles = cylinder(sides);
        for triangles in [inverted(&triangles), triangles] {
            let scene = load_with(&binary(&triangles), "unit = \"mm\"\nfacets = 12").unwrap();
            let [part] = &scene.environment[..] else { panic!("{}", scene.environment.len()) };
            assert_eq!((part.name.as_str(), part.shape.normals().len()), ("wall", 14));
            // Around the cylinder: 2 n tan(pi / n) of r^2 h / 2.
            let volume = 12.0 * (TAU / 24.0).tan() * 0.01 * 0.01 * 0.03;
            assert!((part.shape.volume() / volume - 1.0).abs() < 1e-3, "{} {volume}", part.shape.volume());
        }
    }
}

/// A round hole of 10.1 mm in a round block, and a round peg of 10 mm in it: the files of body and environment.
fn round_fit([body, environment]: [&str; 2], keys: &str) -> Result<Scene, SceneError> {
    let circle = |radius: f64, z: f64| {
        (0..64)
            .map(move |side| TAU * side as f64 / 64.0)
            .map(move |angle| [radius * angle.cos(), radius * angle.sin(), z])
    };
    let ring = |from: Vec<[f64; 3]>, to: Vec<[f64; 3]>| {
        (0..64).flat_map(move |side| {
            let next = (side + 1) % 64;
            quad([from[side], from[next], to[next], to[side]])
        })
    };
    let corners = [(20.0, 0.0), (20.0, 30.0), (10.1, 30.0), (10.1, 0.0), (20.0, 0.0)];
    let block: Vec<Triangle> = corners
        .windows(2)
        .flat_map(|pair| ring(circle(pair[0].0, pair[0].1).collect(), circle(pair[1].0, pair[1].1).collect()))
        .collect();
    let polygon: Vec<[f64; 2]> = circle(10.0, 0.0).map(|[x, y, _]| [x, y]).collect();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("block.stl"), binary(&block)).unwrap();
    std::fs::write(folder.path().join("peg.stl"), binary(&prism(&polygon, &fan(64), 30.0))).unwrap();
    let mesh = |name: &str| format!("mesh = \"{name}.stl\"\nunit = \"mm\"\n{keys}");
    let text = replaced("box = [0.02, 0.02, 0.1]", &mesh(body));
    let text = text.replacen("box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]", &mesh(environment), 1);
    Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
}

#[test]
fn facets_that_take_the_gap_of_a_round_fit_are_refused() {
    // 64 facets take 0.012 mm, 12 take 0.34 mm of the gap of 0.1 mm: of a peg that goes into a hole, and of a ring that
    // goes onto a post.
    for parts in [["peg", "block"], ["block", "peg"]] {
        let scene = round_fit(parts, "").unwrap();
        let fit = scene.fit.unwrap();
        assert!((fit.hole - 0.0101).abs() < 1e-8 && (fit.gap - 1e-4).abs() < 1e-8, "{fit:?}");
        for mesh in scene.body_meshes.iter().chain(&scene.environment_meshes) {
            assert_eq!(mesh.settings.facets, 64);
        }
        let error = round_fit(parts, "facets = 12").unwrap_err();
        assert!(error.message().contains("12 facets of a full turn take 0.3528 mm of the gap of 0.1000 mm"), "{error}");
    }
}

#[test]
fn what_is_not_convex_becomes_several_parts() {
    let l = [[0.0, 0.0], [20.0, 0.0], [20.0, 5.0], [5.0, 5.0], [5.0, 20.0], [0.0, 20.0]];
    let l = prism(&l, &fan(6), 60.0);
    let u = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [20.0, 20.0], [20.0, 5.0], [10.0, 5.0], [10.0, 20.0], [0.0, 20.0]];
    let u = prism(&u, &[[0, 5, 6], [0, 6, 7], [0, 4, 5], [0, 1, 4], [1, 2, 4], [2, 3, 4]], 60.0);
    for (triangles, count) in [(l, 2), (u, 3), (pocket(4.0), 5)] {
        for triangles in [inverted(&triangles), triangles] {
            let scene = load(&binary(&triangles)).unwrap();
            let names: Vec<&str> = scene.environment.iter().map(|part| part.name.as_str()).collect();
            let right: Vec<String> = (1..=count).map(|number| format!("wall.{number}")).collect();
            assert_eq!(names, right);
            assert_eq!(scene.environment_meshes[0].parts, 0..count);
        }
    }
}

#[test]
fn pairs_may_name_a_mesh_or_one_of_its_parts() {
    let listed = |pairs: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("wall.stl"), binary(&pocket(4.0))).unwrap();
        let wall = "box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]";
        let text = replaced(wall, "mesh = \"wall.stl\"\nunit = \"mm\"");
        let text = format!("{text}\n[contact]\npairs = {pairs}\n");
        Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
    };
    assert_eq!(listed("[[\"shaft\", \"wall\"]]").unwrap().pairs.len(), 5);
    assert_eq!(listed("[[\"shaft\", \"wall.2\"]]").unwrap().pairs, [(0, 1)]);
    let error = listed("[[\"shaft\", \"wall.7\"]]").unwrap_err();
    assert!(error.message().contains("no part `wall.7`"), "{error}");
}

#[test]
fn a_clearance_moves_all_surfaces_inwards() {
    let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
    let cube = binary(&prism(&square, &fan(4), 20.0));
    for clearance in ["\"0.5 mm\"", "\"0.05cm\"", "0.0005", "\"5e-4 m\""] {
        let scene = load_with(&cube, &format!("unit = \"mm\"\nclearance = {clearance}")).unwrap();
        assert!((scene.environment[0].shape.size() - 0.019).abs() < 1e-9, "{clearance}");
    }
    for wrong in ["\"0.5\"", "\"half a mm\"", "\"0.5 km\"", "-1.0", "\"200 mm\""] {
        let error = load_with(&cube, &format!("unit = \"mm\"\nclearance = {wrong}")).unwrap_err();
        assert!(error.message().contains("part.clearance"), "{error}");
    }
}

#[test]
fn density_gives_the_body_its_mass_wherever_its_origin_is() {
    let load = |position: &str, goal: &str| {
        let folder = tempfile::tempdir().unwrap();
        let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
        std::fs::write(folder.path().join("cube.stl"), binary(&prism(&square, &fan(4), 20.0))).unwrap();
        let shape = format!("mesh = \"cube.stl\"\nunit = \"mm\"\ndensity = 1000\nposition = {position}");
        let text = replaced("box = [0.02, 0.02, 0.1]", &shape).replace("mass = 1.0\n", "");
        let (before, after) = text.split_once("[goal]").unwrap();
        let text = format!("{before}[goal]{}", after.replacen("[1, 0, 0, 0]", goal, 1));
        Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text }).unwrap().inertia
    };
    let inertia = load("[-0.01, -0.01, -0.01]", "[1.0, 0.0, 0.0, 0.0]");
    assert!((inertia.mass().unwrap() / 0.008 - 1.0).abs() < 1e-6, "{inertia:?}");
    let own = 0.008 * 0.02 * 0.02 / 6.0;
    assert!((inertia.rotational()[(1, 1)] / own - 1.0).abs() < 1e-6);
    // Its centre of mass is 1 cm along x from its origin, and at the goal along y of the world.
    let inertia = load("[0.0, -0.01, -0.01]", "[0.70710678118654757, 0.0, 0.0, 0.70710678118654757]");
    assert!((inertia.rotational()[(1, 1)] / (own + 0.008 * 0.01 * 0.01) - 1.0).abs() < 1e-6);
    // Turning about z moves it along -x, against the turn about y.
    let coupling = Matrix3::new(0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0) * (0.008 * 0.01);
    assert!((inertia.coupling() - coupling).amax() < 1e-9, "{}", inertia.coupling());
}

#[test]
fn a_body_that_a_wrong_unit_makes_smaller_than_its_offsets_is_noticed() {
    let folder = tempfile::tempdir().unwrap();
    let square = [[0.0, 0.0], [0.03, 0.0], [0.03, 0.03], [0.0, 0.03]];
    std::fs::write(folder.path().join("cube.stl"), binary(&prism(&square, &fan(4), 0.03))).unwrap();
    let warnings = |unit: &str| {
        let text = replaced("box = [0.02, 0.02, 0.1]", &format!("mesh = \"cube.stl\"\nunit = \"{unit}\""));
        Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text }).unwrap().warnings
    };
    assert!(warnings("m").is_empty());
    let asked = "0.001 m: is it in metres, and is the `unit` of the body's mesh right?";
    assert!(warnings("inch").iter().any(|warning| warning.contains(asked)), "{:?}", warnings("inch"));
}

#[test]
fn files_that_are_no_mesh_are_refused() {
    let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
    let cube = prism(&square, &fan(4), 20.0);
    assert_eq!(size(&binary(&cube)), (6, 8));
    assert!(refusal(b"").contains("empty"));
    assert!(refusal(b"solid nothing\nendsolid nothing\n").contains("it has no triangles"));
    assert!(refusal(&binary(&[])).contains("it has no triangles"));
    assert!(refusal(&binary(&cube)[..300]).contains("wall.stl"));
    for broken in [f64::NAN, f64::INFINITY, 1e12] {
        let mut triangles = cube.clone();
        triangles[4][1][2] = broken;
        assert!(refusal(&binary(&triangles)).contains("has a coordinate that is not a finite number"));
    }
    assert!(refusal(&binary(&cube[..2])).contains("the surface is open"));
    let repaired = load(&binary(&cube[..11])).unwrap();
    assert_eq!((repaired.environment_meshes[0].solid.repairs().len(), repaired.environment.len()), (1, 1));
    let many: Vec<Triangle> = cube.iter().copied().cycle().take(200_001).collect();
    let message = refusal(&binary(&many));
    assert!(message.contains("more than 200000 triangles are too many"), "{message}");
}

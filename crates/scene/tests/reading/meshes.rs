//! Meshes that are convex, that are not, and files that are none.

use std::f64::consts::TAU;

use scene::{Scene, SceneError, Source};

use crate::support::replaced;

type Triangle = [[f64; 3]; 3];

/// The scene with a mesh file of these bytes.
fn load(bytes: &[u8]) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("wall.stl"), bytes).unwrap();
    let wall = "box = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]";
    let text = replaced(wall, "mesh = \"wall.stl\"\nunit = \"mm\"");
    Scene::parse(Source { file: &folder.path().join("scene.toml"), text: &text })
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
fn a_tessellated_cylinder_is_convex_in_both_orientations() {
    for sides in [16, 64, 300] {
        let triangles = cylinder(sides);
        for triangles in [inverted(&triangles), triangles] {
            assert_eq!(size(&binary(&triangles)), (sides + 2, 2 * sides));
        }
    }
}

#[test]
fn shapes_whose_vertices_all_lie_on_the_hull_are_not_convex_for_that() {
    let l = [[0.0, 0.0], [20.0, 0.0], [20.0, 5.0], [5.0, 5.0], [5.0, 20.0], [0.0, 20.0]];
    let l = prism(&l, &fan(6), 60.0);
    let u = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [20.0, 20.0], [20.0, 5.0], [10.0, 5.0], [10.0, 20.0], [0.0, 20.0]];
    let u = prism(&u, &[[0, 5, 6], [0, 6, 7], [0, 4, 5], [0, 1, 4], [1, 2, 4], [2, 3, 4]], 60.0);
    for (triangles, depth, place) in [(l, "5.000 mm", "(10.0000, 5.0000, "), (u, "10.000 mm", "(10.0000, ")] {
        for triangles in [inverted(&triangles), triangles] {
            let message = refusal(&binary(&triangles));
            assert!(message.contains("not convex: at ") && message.contains("split it into convex parts"), "{message}");
            assert!(message.contains(depth) && message.contains(place), "{message}");
        }
    }
}

#[test]
fn a_pocket_is_found_unless_it_is_a_scratch() {
    for triangles in [pocket(4.0), inverted(&pocket(4.0))] {
        let message = refusal(&binary(&triangles));
        assert!(
            message.contains("0000, 16.0000) in the unit of the file, its surface lies 4.000 mm inside"),
            "{message}"
        );
    }
    assert!(refusal(&binary(&pocket(0.01))).contains("lies 0.010 mm inside"));
    assert_eq!(size(&binary(&pocket(0.001))), (6, 8));
}

#[test]
fn files_that_are_no_mesh_are_refused() {
    let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
    let cube = prism(&square, &fan(4), 20.0);
    assert_eq!(size(&binary(&cube)), (6, 8));
    assert!(refusal(b"").contains("the file is empty"));
    assert!(refusal(b"solid nothing\nendsolid nothing\n").contains("it has no triangles"));
    assert!(refusal(&binary(&[])).contains("it has no triangles"));
    assert!(refusal(&binary(&cube)[..300]).contains("wall.stl"));
    for broken in [f64::NAN, f64::INFINITY] {
        let mut triangles = cube.clone();
        triangles[4][1][2] = broken;
        assert!(refusal(&binary(&triangles)).contains("triangle 5 has a coordinate that is not a finite number"));
    }
    let mut far = cube.clone();
    far[4][1][2] = 1e12;
    assert!(refusal(&binary(&far)).contains("lengths are in metres"));
    assert!(refusal(&binary(&cube[..2])).contains("the part is flat"));
    let many: Vec<Triangle> = cube.iter().copied().cycle().take(200_001).collect();
    assert!(refusal(&binary(&many)).contains("more than 200000 triangles"));
}

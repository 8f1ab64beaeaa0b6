//! Properties of covers of random shapes, and soups of triangles that must not panic.

use std::f64::consts::TAU;

use crate::shapes::{self, Point, Shape, prism, rotation, stack};
use mesh::{Cover, CoverSettings, Deviation, Solid, TriangleMesh};
use proptest::prelude::*;

/// Whether a point is inside a part, by the solid angles under which triangles are seen.
fn is_inside(shape: &Shape, point: Point) -> bool {
    let from = |corner: usize| -> Point { std::array::from_fn(|axis| shape.vertices[corner][axis] - point[axis]) };
    let dot = |a: Point, b: Point| a.iter().zip(b).map(|(one, other)| one * other).sum::<f64>();
    let cross = |a: Point, b: Point| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let mut turns = 0.0;
    for polygon in &shape.polygons {
        for at in 2..polygon.len() {
            let [a, b, c] = [polygon[0], polygon[at - 1], polygon[at]].map(from);
            let (la, lb, lc) = (dot(a, a).sqrt(), dot(b, b).sqrt(), dot(c, c).sqrt());
            let below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
            turns += 2.0 * dot(a, cross(b, c)).atan2(below) / (2.0 * TAU);
        }
    }
    turns > 0.5
}

fn depth(cover: &Cover, point: Point) -> f64 {
    let depth = |piece: &mesh::Piece| {
        let rows = piece.normals.iter().zip(&piece.offsets);
        rows.map(|(normal, offset)| offset - normal.iter().zip(point).map(|(n, p)| 1e-3 * n * p).sum::<f64>())
            .fold(f64::INFINITY, f64::min)
    };
    cover.pieces().iter().map(depth).fold(f64::NEG_INFINITY, f64::max)
}

/// A polygon around the origin that need not be convex.
fn star() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(4.0..15.0f64, 3..9).prop_map(|radii| {
        let count = radii.len() as f64;
        let corner = |(index, radius): (usize, f64)| {
            let angle = TAU * index as f64 / count;
            [radius * angle.cos(), radius * angle.sin()]
        };
        radii.into_iter().enumerate().map(corner).collect()
    })
}

fn points() -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec([-16.0..16.0, -16.0..16.0, -1.0..21.0f64], 200)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(30))]

    #[test]
    fn covers_of_planar_parts_are_exact(outline in star(), points in points(), angle in 0.0..3.0f64) {
        let shape = prism(&outline, 20.0);
        let cover = shape.cover(24);
        for point in points {
            let depth = depth(&cover, point);
            prop_assert!(depth.abs() < 1e-7 || (depth > 0.0) == is_inside(&shape, point), "{point:?} {depth}");
        }
        let turned = shape.turned(&rotation(angle)).cover(24);
        prop_assert!(turned.pieces().len().abs_diff(cover.pieces().len()) <= 1);
        let deviation = Deviation::measure(&shape.solid(), &cover);
        prop_assert!(deviation.mesh_to_cover < 1e-6 && deviation.cover_to_mesh < 1e-6, "{deviation:?}");
    }

    #[test]
    fn covers_of_round_parts_contain_them(
        sides in 30..70usize, phase in 0.0..1.0f64, facets in 5..20usize, wall in 1.0..8.0f64, taper in -1.0..1.0f64,
        points in points(),
    ) {
        let ring = |radius: f64, z: f64| shapes::circle(radius, z, sides, phase);
        let loops = [ring(14.0, 0.0), ring(14.0, 20.0), ring(14.0 - wall, 20.0), ring(14.0 - wall + 0.4 * taper, 5.0)];
        let shape = stack(&loops, false);
        let cover = shape.cover(facets);
        let surfaces = cover.curved_surfaces().iter();
        let error = surfaces.map(|(surface, facets)| surface.error(*facets) + surface.mesh_error).fold(0.0, f64::max);
        for point in points {
            let depth = depth(&cover, point);
            if is_inside(&shape, point) {
                prop_assert!(depth > -1e-8, "{point:?} {depth}");
            } else {
                prop_assert!(depth < error + 1e-8, "{point:?} {depth} {error}");
            }
        }
    }
}

/// Coordinates of which many are equal or nearly so.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        (0..4i32).prop_map(f64::from),
        (0..4i32).prop_map(|value| f64::from(value) + 1e-7),
        -1.0..4.0f64,
        Just(f64::NAN),
        Just(1e30),
        Just(1e-300),
    ]
}

fn soup() -> impl Strategy<Value = (Vec<Point>, Vec<[usize; 3]>)> {
    let near = (0..3i32).prop_map(f64::from);
    let vertices = prop_oneof![
        prop::collection::vec([near.clone(), near.clone(), near], 4..20),
        prop::collection::vec([coordinate(), coordinate(), coordinate()], 4..20),
    ];
    vertices.prop_flat_map(|vertices| {
        let count = vertices.len() + usize::from(vertices.len() % 7 == 0);
        (Just(vertices), prop::collection::vec([0..count, 0..count, 0..count], 1..40))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn soups_do_not_panic((vertices, triangles) in soup(), rounding in prop_oneof![Just(0.0), Just(1e-6), Just(0.1)]) {
        if let Ok(solid) = TriangleMesh::new(&vertices, &triangles, 1e-3, rounding).and_then(|mesh| Solid::of(&mesh)) {
            let _ = Cover::of(&solid, &CoverSettings::default());
        }
    }

    #[test]
    fn damaged_parts_do_not_panic(damage in prop::collection::vec((0..1000usize, 0..1000usize, coordinate()), 1..5)) {
        let mut shape = shapes::countersunk_block(20);
        for (kind, place, value) in damage {
            let (vertex, polygon) = (place % shape.vertices.len(), place % shape.polygons.len());
            match kind % 4 {
                0 => shape.vertices[vertex][kind % 3] = value,
                1 => shape.polygons[polygon].reverse(),
                2 => drop(shape.polygons.remove(polygon)),
                _ => shape.polygons.push(shape.polygons[polygon].clone()),
            }
        }
        let triangles: Vec<[usize; 3]> = shape
            .polygons
            .iter()
            .flat_map(|polygon| (2..polygon.len()).map(|at| [polygon[0], polygon[at - 1], polygon[at]]))
            .collect();
        let solid = TriangleMesh::new(&shape.vertices, &triangles, 1e-3, 0.0).and_then(|mesh| Solid::of(&mesh));
        let settings = CoverSettings { facets: 8, ..CoverSettings::default() };
        let cover = solid.as_ref().map(|solid| Cover::of(solid, &settings));
        if let (Ok(solid), Ok(Ok(cover))) = (&solid, &cover) {
            let deviation = Deviation::measure(solid, cover);
            prop_assert!(deviation.uncovered < 1e-6, "{deviation:?}");
        }
    }

    #[test]
    fn garbled_files_do_not_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), lines in "([vf] [-0-9./ e]{0,20}\n){0,12}") {
        for (suffix, content) in [(".stl", bytes.clone()), (".obj", bytes), (".obj", lines.into_bytes())] {
            let file = tempfile::Builder::new().suffix(suffix).tempfile().unwrap();
            std::fs::write(file.path(), content).unwrap();
            if let Ok(mesh) = TriangleMesh::read(file.path(), 1.0) {
                let _ = Solid::of(&mesh);
            }
        }
    }
}

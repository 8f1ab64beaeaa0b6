//! Hulls of very many points, of degenerate points and of halfspaces: a valid part or an error, in bounded time.

use std::f64::consts::TAU;

use collision::{Polytope, PolytopeError};
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;

type Points = Vec<[f64; 3]>;

fn height(normal: &[f64; 3], offset: f64, point: &[f64; 3]) -> f64 {
    Vector3::from(*normal).dot(&Vector3::from(*point)) - offset
}

fn rows(part: &Polytope) -> impl Iterator<Item = (&[f64; 3], f64)> {
    part.normals().iter().zip(part.offsets().iter().copied())
}

fn nearest(part: &Polytope, point: &[f64; 3]) -> f64 {
    let distance = |vertex: &[f64; 3]| (Vector3::from(*vertex) - Vector3::from(*point)).norm();
    part.vertices().iter().map(distance).fold(f64::INFINITY, f64::min)
}

/// The part contains the points, each facet has three vertices and the centre is inside.
fn check(part: &Polytope, points: &[[f64; 3]], tolerance: f64) {
    for (normal, offset) in rows(part) {
        let depth = |point: &[f64; 3]| height(normal, offset, point);
        assert!(points.iter().all(|point| depth(point) <= tolerance));
        assert!(part.vertices().iter().filter(|vertex| depth(vertex) >= -10.0 * tolerance).count() >= 3);
        assert!(depth(&part.center()) < 0.0);
    }
    assert!(part.vertices().iter().all(|vertex| points.contains(vertex)));
}

/// Largest distance from the first point.
fn extent(points: &[[f64; 3]]) -> f64 {
    points.iter().map(|point| (Vector3::from(*point) - Vector3::from(points[0])).norm()).fold(0.0, f64::max)
}

fn turned(points: Points) -> Points {
    let turn = UnitQuaternion::from_euler_angles(0.3, -0.7, 1.1);
    points.into_iter().map(|point| (turn * Vector3::from(point)).into()).collect()
}

fn prism(sides: usize) -> Points {
    let corner = |index: usize| {
        let (sine, cosine) = (TAU * (index / 2) as f64 / sides as f64).sin_cos();
        [0.03 * cosine, 0.03 * sine, 0.1 * (index % 2) as f64]
    };
    turned((0..2 * sides).map(corner).collect())
}

/// Points in no order on a sphere around the origin.
fn sphere(count: usize) -> Points {
    let point = |index: usize| {
        let z = 1.0 - (2 * index + 1) as f64 / count as f64;
        let (sine, cosine) = (2.399_963 * index as f64).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        [radius * cosine, radius * sine, z]
    };
    (0..count).map(point).collect()
}

/// A grid on the faces of a cube.
fn grid(steps: usize) -> Points {
    let edge = 0..=steps;
    let nodes = edge.clone().flat_map(|x| (0..=steps).flat_map(move |y| (0..=steps).map(move |z| [x, y, z])));
    let surface = nodes.filter(|node| node.iter().any(|&index| index == 0 || index == steps));
    turned(surface.map(|node| node.map(|index| 0.1 * index as f64 / steps as f64)).collect())
}

#[test]
fn thousands_of_vertices_are_no_problem() {
    for (points, facets, vertices) in [(prism(1000), 1002, 2000), (grid(18), 6, 8)] {
        let part = Polytope::from_vertices(&points).unwrap();
        assert_eq!((part.normals().len(), part.vertices().len()), (facets, vertices));
        check(&part, &points, 1e-7 * extent(&points));
    }
    let points = sphere(2000);
    let part = Polytope::from_vertices(&points).unwrap();
    assert_eq!(part.vertices().len(), 2000);
    check(&part, &points, 1e-7 * extent(&points));
}

#[test]
fn a_thousand_halfspaces_are_no_problem() {
    let normals = sphere(1000);
    let part = Polytope::from_halfspaces(&normals, &[0.05; 1000]).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (1000, 1996));
    // All but the base meet in one vertex.
    let side = |index: usize| {
        let (sine, cosine) = (TAU * index as f64 / 999.0).sin_cos();
        [0.8 * cosine, 0.8 * sine, 0.6]
    };
    let normals: Points = (0..999).map(side).chain([[0.0, 0.0, -1.0]]).collect();
    let cone = Polytope::from_halfspaces(&normals, &[0.05; 1000]).unwrap();
    assert_eq!((cone.normals().len(), cone.vertices().len()), (1000, 1000));
    let open = Polytope::from_halfspaces(&normals[..999], &[0.05; 999]);
    assert!(matches!(open, Err(PolytopeError::Unbounded { direction }) if direction[2] < -0.9), "{open:?}");
}

#[test]
fn too_many_or_too_large_numbers_are_refused_at_once() {
    let points = sphere(10_001);
    assert_eq!(Polytope::from_vertices(&points), Err(PolytopeError::TooManyVertices { count: 10_001 }));
    let halfspaces = Polytope::from_halfspaces(&points[..2001], &[1.0; 2001]);
    assert_eq!(halfspaces, Err(PolytopeError::TooManyHalfspaces { count: 2001 }));
    let mut far = prism(3);
    far[2][1] = -1e7;
    assert_eq!(Polytope::from_vertices(&far), Err(PolytopeError::TooLarge { index: 2 }));
    assert_eq!(Polytope::from_box([1.0, 1.0, 1e300]), Err(PolytopeError::TooLarge { index: 2 }));
    let normals = [[1e-9, 0.0, 0.0], [-1.0, 0.0, 0.0]];
    assert_eq!(Polytope::from_halfspaces(&normals, &[1.0; 2]), Err(PolytopeError::TooLarge { index: 0 }));
    assert!(Polytope::from_box([1e-300; 3]).is_err());
}

#[test]
fn a_tolerance_for_rounded_coordinates_merges_their_facets() {
    let rounded: Points = prism(32).into_iter().map(|point| point.map(|x| (1e7 * x).round() / 1e7)).collect();
    assert!(Polytope::from_vertices(&rounded).unwrap().normals().len() > 34);
    let part = Polytope::from_vertices_within(&rounded, 2e-7).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (34, 64));
    check(&part, &rounded, 2e-7);
    assert_eq!(Polytope::from_vertices_within(&rounded, 0.0), Polytope::from_vertices(&rounded));
    assert!(Polytope::from_vertices_within(&rounded, 0.1).is_err());
    assert!(Polytope::from_vertices_within(&rounded, f64::INFINITY).is_err());
}

#[test]
fn a_flat_cone_keeps_its_vertices() {
    let rim = (0..200).map(|index| (TAU * index as f64 / 200.0).sin_cos()).map(|(y, x)| [0.1 * x, 0.1 * y, 0.0]);
    let points: Points = rim.chain([[0.0, 0.0, 1e-4]]).collect();
    let part = Polytope::from_vertices(&points).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (201, 201));
}

/// Points with any degeneracy: coplanar, collinear, equal, clustered and almost so, small and large, near and far.
fn degenerate() -> impl Strategy<Value = Points> {
    let coordinates = prop_oneof![
        prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 1..60),
        prop::collection::vec(prop::array::uniform3((0..4u8).prop_map(f64::from)), 1..60),
        prop::collection::vec(prop::sample::select(vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 2.0, 3.0]]), 1..60),
    ];
    let thickness = || prop_oneof![Just(0.0), Just(1.0), (-9.0..-4.0f64).prop_map(|power| 10f64.powf(power))];
    let noise = prop_oneof![Just(0.0), (-9.0..-5.0f64).prop_map(|power| 10f64.powf(power))];
    let size = (-4.0..3.0f64).prop_map(|power| 10f64.powf(power));
    (coordinates, [thickness(), thickness()], noise, size, 0..3usize, any::<u64>()).prop_map(
        |(points, [y, z], noise, size, clusters, seed)| {
            let mut random = seed | 1;
            let mut jitter = || {
                random = random.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
                noise * ((random >> 40) as f64 / (1u64 << 23) as f64 - 1.0)
            };
            let place = |(index, [x, v, w]): (usize, [f64; 3])| {
                let shift = 20.0 * (index % (clusters + 1)) as f64;
                [x + shift + jitter(), y * v + jitter(), z * w + shift + jitter()].map(|coordinate| size * coordinate)
            };
            turned(points.into_iter().enumerate().map(place).collect())
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4 * ProptestConfig::default().cases))]

    #[test]
    fn any_points_give_a_valid_part_or_an_error(points in degenerate()) {
        if let Ok(part) = Polytope::from_vertices(&points) {
            check(&part, &points, 1.01e-7 * extent(&points));
            if let Ok(part) = Polytope::from_halfspaces(part.normals(), part.offsets()) {
                prop_assert!(part.vertices().as_flattened().iter().all(|coordinate| coordinate.is_finite()));
            }
        }
    }

    #[test]
    fn any_halfspaces_give_a_valid_part_or_an_error(
        rows in prop::collection::vec((prop::array::uniform3(-2..3i8), -1..5i8), 1..40),
        noise in prop_oneof![Just(0.0), Just(1e-9), Just(1e-7), Just(1e-5)],
        size in (-4.0..3.0f64).prop_map(|power| 10f64.powf(power)),
    ) {
        let normals: Points = rows.iter().map(|row| row.0.map(|component| f64::from(component) + noise)).collect();
        let offsets: Vec<f64> = rows.iter().map(|row| size * f64::from(row.1)).collect();
        prop_assume!(rows.iter().all(|row| row.0 != [0; 3]));
        if let Ok(part) = Polytope::from_halfspaces(&normals, &offsets) {
            // Rows that are almost parallel make needles, whose tips no three rows determine.
            prop_assume!(part.size() < 100.0 * size);
            let tolerance = 1e-4 * size;
            for vertex in part.vertices() {
                for (normal, offset) in normals.iter().zip(&offsets) {
                    prop_assert!(height(normal, *offset, vertex) <= tolerance);
                }
            }
            for (normal, offset) in self::rows(&part) {
                let touching = part.vertices().iter().filter(|vertex| height(normal, offset, vertex) >= -tolerance);
                prop_assert!(touching.count() >= 3);
            }
        }
    }

    #[test]
    fn halfspaces_of_a_hull_have_its_vertices(points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 4..80)) {
        let Ok(part) = Polytope::from_vertices(&points) else { return Ok(()) };
        let back = Polytope::from_halfspaces(part.normals(), part.offsets()).unwrap();
        prop_assert!(part.vertices().iter().all(|vertex| nearest(&back, vertex) < 1e-3));
        let again = Polytope::from_vertices(back.vertices()).unwrap();
        for point in &points {
            prop_assert!(self::rows(&again).all(|(normal, offset)| height(normal, offset, point) < 1e-5));
        }
    }
}

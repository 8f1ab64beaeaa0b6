//! Polytopes from vertices, boxes and halfspaces, and what is not one.

use collision::{Polytope, PolytopeError};

const UNIT: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];

fn corners(size: f64) -> Vec<[f64; 3]> {
    let side = |bit: usize, index: usize| if index >> bit & 1 == 0 { -size } else { size };
    (0..8).map(|index| [side(0, index), side(1, index), side(2, index)]).collect()
}

/// Every vertex satisfies all rows and lies on at least three; every row is unit and touched.
fn check(part: &Polytope, size: f64) {
    let height = |normal: &[f64; 3], vertex: &[f64; 3]| -> f64 { (0..3).map(|axis| normal[axis] * vertex[axis]).sum() };
    let tolerance = 1e-9 * size;
    let rows = || part.normals().iter().zip(part.offsets());
    for vertex in part.vertices() {
        assert!(rows().all(|(normal, offset)| height(normal, vertex) <= offset + tolerance));
        let touching = rows().filter(|(normal, offset)| height(normal, vertex) >= **offset - tolerance);
        assert!(touching.count() >= 3);
    }
    for (normal, offset) in rows() {
        assert!((height(normal, normal) - 1.0).abs() < 1e-14);
        assert!(part.vertices().iter().filter(|vertex| height(normal, vertex) >= offset - tolerance).count() >= 3);
        assert!(height(normal, &part.center()) < *offset);
    }
}

#[test]
fn coplanar_hull_facets_are_merged() {
    for size in [1e-4, 0.05, 100.0] {
        let part = Polytope::from_vertices(&corners(size)).unwrap();
        assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
        check(&part, size);
    }
}

#[test]
fn points_on_faces_edges_and_inside_are_dropped() {
    let mut points = corners(0.05);
    points.extend([[0.05, 0.0, 0.0], [0.05, 0.05, 0.01], [0.0, 0.0, 0.0], [0.01, -0.02, 0.03]]);
    points.extend(corners(0.05));
    let part = Polytope::from_vertices(&points).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
    check(&part, 0.05);
}

#[test]
fn parts_far_from_their_origin_keep_their_shape() {
    let points: Vec<[f64; 3]> = corners(0.05).into_iter().map(|[x, y, z]| [x + 3.0, y - 2.0, z + 1.0]).collect();
    let part = Polytope::from_vertices(&points).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
    let part = Polytope::from_halfspaces(part.normals(), part.offsets()).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
}

#[test]
fn regular_prisms_of_many_sides_keep_all_of_them() {
    for sides in [5, 16, 58] {
        let angle = |side: usize| std::f64::consts::TAU * side as f64 / sides as f64;
        let points: Vec<[f64; 3]> = (0..2 * sides)
            .map(|point| {
                let (sine, cosine) = angle(point / 2).sin_cos();
                [0.03 * cosine, 0.03 * sine, if point % 2 == 0 { 0.0 } else { 0.1 }]
            })
            .collect();
        let part = Polytope::from_vertices(&points).unwrap();
        assert_eq!((part.normals().len(), part.vertices().len()), (sides + 2, 2 * sides), "{sides} sides");
        check(&part, 0.1);
    }
}

#[test]
fn noise_of_file_precision_does_not_split_faces() {
    // Coordinates as in a file of single precision.
    let points: Vec<[f64; 3]> = corners(0.05)
        .into_iter()
        .map(|[x, y, z]| {
            let (sine, cosine) = 0.3_f64.sin_cos();
            [cosine * x - sine * y, sine * x + cosine * y, z].map(|coordinate| f64::from(coordinate as f32))
        })
        .collect();
    assert_eq!(Polytope::from_vertices(&points).unwrap().normals().len(), 6);
}

#[test]
fn redundant_and_repeated_rows_are_removed() {
    let mut normals = UNIT.to_vec();
    let mut offsets = vec![0.05; 6];
    normals.extend([[2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 3.0], [1.0, 1.0, 1.0]]);
    // Repeated with another length, touching an edge only, outside, touching a corner only.
    offsets.extend([0.1, 0.1, 0.3, 0.15]);
    let part = Polytope::from_halfspaces(&normals, &offsets).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
    check(&part, 0.05);
}

#[test]
fn placing_moves_rows_vertices_and_centre_together() {
    let part = Polytope::from_box([0.1, 0.06, 0.03]).unwrap().placed([0.4, -0.2, 0.1], [0.9, 0.3, -0.2, 0.1]);
    check(&part, 0.1);
    let center = part.center();
    assert!((0..3).all(|axis| (center[axis] - [0.4, -0.2, 0.1][axis]).abs() < 1e-12));
}

#[test]
fn what_is_no_polytope_says_why() {
    use PolytopeError as Error;
    let flat: Vec<[f64; 3]> = corners(0.05).into_iter().map(|[x, y, _]| [x, y, 0.2]).collect();
    assert!(matches!(Polytope::from_vertices(&flat), Err(Error::Flat { .. })));
    let line: Vec<[f64; 3]> = (0..6).map(|step| [f64::from(step), 2.0 * f64::from(step), 0.0]).collect();
    assert!(matches!(Polytope::from_vertices(&line), Err(Error::Flat { .. })));
    let same = [[1.0, 2.0, 3.0]; 9];
    assert_eq!(Polytope::from_vertices(&same), Err(Error::TooFewVertices { count: 1 }));
    assert_eq!(Polytope::from_vertices(&[]), Err(Error::TooFewVertices { count: 0 }));
    let mut infinite = corners(0.05);
    infinite[3][1] = f64::INFINITY;
    assert_eq!(Polytope::from_vertices(&infinite), Err(Error::NotFinite { index: 3 }));

    assert!(matches!(Polytope::from_box([0.1, 0.0, 0.1]), Err(Error::EdgeLength { .. })));
    assert!(matches!(Polytope::from_box([0.1, f64::NAN, 0.1]), Err(Error::EdgeLength { .. })));

    let halfspaces = |normals: &[[f64; 3]], offsets: &[f64]| Polytope::from_halfspaces(normals, offsets);
    assert_eq!(halfspaces(&UNIT, &[0.1; 5]), Err(Error::Lengths { normals: 6, offsets: 5 }));
    let mut zero = UNIT;
    zero[4] = [0.0; 3];
    assert_eq!(halfspaces(&zero, &[0.1; 6]), Err(Error::ZeroNormal { index: 4 }));
    assert_eq!(halfspaces(&UNIT, &[0.1, 0.1, f64::NAN, 0.1, 0.1, 0.1]), Err(Error::NotFinite { index: 2 }));
    assert_eq!(halfspaces(&UNIT, &[0.1, 0.1, 0.1, -0.2, 0.1, 0.1]), Err(Error::Empty));
    assert_eq!(halfspaces(&UNIT, &[0.1, 0.1, 0.1, -0.1, 0.1, 0.1]), Err(Error::Empty), "no thickness");
    let open = halfspaces(&UNIT[..5], &[0.1; 5]).unwrap_err();
    let Error::Unbounded { direction } = open else { panic!("{open:?}") };
    assert!(direction[2] < -0.9);
    assert!(matches!(halfspaces(&[], &[]), Err(Error::Unbounded { .. })));
    let slab = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
    assert!(matches!(halfspaces(&slab, &[0.1; 2]), Err(Error::Unbounded { .. })));
}

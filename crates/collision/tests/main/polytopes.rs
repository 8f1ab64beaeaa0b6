//! Polytopes from good and bad descriptions.

use collision::{Polytope, PolytopeError};

const CUBE: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [1.0, 1.0, 1.0],
];

fn box_halfspaces() -> (Vec<[f64; 3]>, Vec<f64>) {
    let part = Polytope::from_box([2.0, 2.0, 2.0]).unwrap();
    (part.normals().to_vec(), part.offsets().to_vec())
}

#[test]
fn triangles_of_a_face_are_merged_and_inner_points_dropped() {
    let mut points = CUBE.to_vec();
    points.extend([[0.5, 0.5, 0.5], [0.5, 0.5, 0.0], [0.0, 0.0, 0.0], [0.5, 0.0, 0.0]]);
    let part = Polytope::from_vertices(&points).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
    let center = part.center();
    assert!(center.iter().all(|coordinate| (coordinate - 0.5).abs() < 1e-12));
}

#[test]
fn rounded_vertices_still_make_flat_faces() {
    let rounded: Vec<[f64; 3]> =
        CUBE.iter().map(|v| [v[0] + 3e-9 * v[1], v[1] - 2e-9 * v[2], v[2] + 1e-9 * v[0]]).collect();
    assert_eq!(Polytope::from_vertices(&rounded).unwrap().normals().len(), 6);
}

#[test]
fn redundant_repeated_and_scaled_rows_are_removed() {
    let (mut normals, mut offsets) = box_halfspaces();
    normals.extend([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]);
    offsets.extend([1.0, 2.0, 2.0, 9.0]);
    let part = Polytope::from_halfspaces(&normals, &offsets).unwrap();
    assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
    assert_eq!(part, Polytope::from_box([2.0, 2.0, 2.0]).unwrap());
}

#[test]
fn an_unbounded_part_names_the_open_direction() {
    let (normals, offsets) = box_halfspaces();
    let open = Polytope::from_halfspaces(&normals[..5], &offsets[..5]);
    let Err(PolytopeError::Unbounded { direction }) = open else { panic!("{open:?}") };
    assert!((direction[2] + 1.0).abs() < 1e-12, "{direction:?}");
    let slab = Polytope::from_halfspaces(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], &[1.0, 1.0]);
    assert!(matches!(slab, Err(PolytopeError::Unbounded { .. })));
}

#[test]
fn bad_descriptions_are_refused() {
    let (normals, mut offsets) = box_halfspaces();
    offsets[3] = -2.0;
    assert_eq!(Polytope::from_halfspaces(&normals, &offsets), Err(PolytopeError::Empty));
    assert!(matches!(Polytope::from_halfspaces(&normals, &offsets[1..]), Err(PolytopeError::Lengths { .. })));
    let zero = Polytope::from_halfspaces(&[[0.0; 3]], &[1.0]);
    assert_eq!(zero, Err(PolytopeError::ZeroNormal { index: 0 }));
    assert!(matches!(Polytope::from_vertices(&CUBE[..3]), Err(PolytopeError::TooFewVertices { count: 3 })));
    let square = [CUBE[0], CUBE[1], CUBE[2], CUBE[4]];
    assert!(matches!(Polytope::from_vertices(&square), Err(PolytopeError::Flat { .. })));
    let mut broken = CUBE;
    broken[2][1] = f64::NAN;
    assert_eq!(Polytope::from_vertices(&broken), Err(PolytopeError::NotFinite { index: 2 }));
    assert!(matches!(Polytope::from_box([1.0, 0.0, 1.0]), Err(PolytopeError::EdgeLength { .. })));
    assert!(matches!(Polytope::from_box([1.0, f64::NAN, 1.0]), Err(PolytopeError::EdgeLength { .. })));
}

#[test]
fn a_placed_part_keeps_its_shape() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let part = Polytope::from_box([0.2, 0.4, 0.6]).unwrap().placed([1.0, 2.0, 3.0], [half, 0.0, 0.0, half]);
    assert!((part.size() - 0.6).abs() < 1e-12);
    for vertex in part.vertices() {
        let extents = [0.2, 0.1, 0.3];
        for axis in 0..3 {
            assert!((vertex[axis] - [1.0, 2.0, 3.0][axis]).abs() - extents[axis] < 1e-12);
        }
    }
}

//! Hulls of shapes that are easy to get wrong: tiny, large, far away, many-sided, rounded.

use collision::Polytope;

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
fn cubes_of_any_size_have_six_faces() {
    for size in [1e-4, 0.05, 100.0] {
        let part = Polytope::from_vertices(&corners(size)).unwrap();
        assert_eq!((part.normals().len(), part.vertices().len()), (6, 8));
        check(&part, size);
    }
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

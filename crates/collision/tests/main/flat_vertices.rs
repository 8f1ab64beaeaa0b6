//! Vertices at which facets meet at small angles.

use collision::Polytope;

/// Deterministic numbers in (-1, 1).
fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

#[test]
fn flat_vertices_are_kept() {
    let mut seed = 7;
    for _ in 0..20_000 {
        let count = 6 + (8.0 * (0.5 + 0.5 * noise(&mut seed))) as usize;
        let points: Vec<[f64; 3]> = (0..count).map(|_| std::array::from_fn(|_| 0.02 * noise(&mut seed))).collect();
        let part = Polytope::from_vertices(&points).unwrap();
        let height = |point: &[f64; 3], facet: usize| {
            let normal = part.normals()[facet];
            (0..3).map(|axis| normal[axis] * point[axis]).sum::<f64>() - part.offsets()[facet]
        };
        for point in &points {
            let facets = (0..part.offsets().len()).filter(|&facet| height(point, facet).abs() < 1e-12).count();
            assert!(facets < 3 || part.vertices().contains(point), "{point:?} of {points:?}");
        }
    }
}

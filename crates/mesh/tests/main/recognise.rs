//! Curved surfaces found in meshes.

use std::f64::consts::{PI, TAU};

use crate::shapes::{Shape, block_with_hole, chamfered_peg, circle, countersunk_block, prism, rotation, stack, tube};
use mesh::{CurvedKind, CurvedSurface};

fn found(shape: &Shape) -> Vec<CurvedSurface> {
    shape.solid().curved_surfaces()
}

fn assert_near(one: f64, other: f64, tolerance: f64) {
    assert!((one - other).abs() <= tolerance, "{one} is not {other}");
}

#[test]
fn a_chamfered_peg_is_a_cylinder_and_a_cone() {
    for shape in [chamfered_peg(48), chamfered_peg(48).turned(&rotation(1.0))] {
        let surfaces = found(&shape);
        assert_eq!(surfaces.len(), 2, "{surfaces:?}");
        for surface in &surfaces {
            assert!(surface.is_convex && surface.mesh_facets == 48);
            assert_near(surface.angle, TAU, 1e-9);
        }
        let cylinder = surfaces.iter().find(|surface| surface.kind == CurvedKind::Cylinder).unwrap();
        let cone = surfaces.iter().find(|surface| surface.kind == CurvedKind::Cone).unwrap();
        assert_near(cylinder.radii[0], 4e-3, 1e-8);
        assert_near(cone.radii[0].min(cone.radii[1]), 3e-3, 1e-7);
        assert_near(cylinder.mesh_error, 4e-3 * (1.0 - (PI / 48.0).cos()), 1e-7);
        assert_near(cylinder.error(12), 4e-3 * (1.0 / (PI / 12.0).cos() - 1.0), 1e-7);
    }
}

#[test]
fn holes_are_concave() {
    let surfaces = found(&countersunk_block(60));
    assert_eq!(surfaces.len(), 2);
    assert!(surfaces.iter().all(|surface| !surface.is_convex));
    let surfaces = found(&tube(40));
    assert_eq!(surfaces.iter().map(|surface| surface.is_convex).filter(|is_convex| *is_convex).count(), 1);
    assert_near(surfaces.iter().find(|surface| !surface.is_convex).unwrap().radii[0], 6e-3, 1e-9);
}

#[test]
fn coarse_prisms_stay_what_they_are() {
    for sides in [3, 6, 8, 12, 14] {
        assert!(found(&block_with_hole(sides, 0.1)).is_empty(), "{sides}");
    }
    assert!(found(&chamfered_peg(12)).is_empty());
    assert_eq!(found(&block_with_hole(16, 0.1)).len(), 1);
}

/// A rectangle with rounded corners.
fn rounded(half: f64, radius: f64, per_corner: usize) -> Vec<[f64; 2]> {
    let corner = |quarter: usize| {
        let center = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]][quarter];
        (0..=per_corner).map(move |step| {
            let angle = PI / 2.0 * (quarter as f64 + step as f64 / per_corner as f64);
            [center[0] * (half - radius) + radius * angle.cos(), center[1] * (half - radius) + radius * angle.sin()]
        })
    };
    (0..4).flat_map(corner).collect()
}

#[test]
fn fillets_are_arcs_and_planes_stay_out_of_them() {
    let shape = prism(&rounded(10.0, 3.0, 9), 15.0);
    let surfaces = found(&shape);
    assert_eq!(surfaces.len(), 4, "{surfaces:?}");
    for surface in &surfaces {
        assert_near(surface.angle, PI / 2.0, 1e-6);
        assert_near(surface.radii[0], 3e-3, 1e-9);
    }
    // With 24 facets per turn each quarter has five of its own between the four planes.
    let cover = shape.cover(24);
    assert_eq!((cover.pieces().len(), cover.pieces()[0].normals.len()), (1, 2 + 4 + 4 * 5));
}

#[test]
fn facets_have_the_phase_of_the_frame() {
    let peg = stack(&[circle(4.0, 0.0, 50, 0.1), circle(4.0, 9.0, 50, 0.1)], false);
    let cover = peg.cover(8);
    let normals = &cover.pieces()[0].normals;
    assert_eq!(normals.len(), 10);
    for normal in normals.iter().filter(|normal| normal[2].abs() < 0.5) {
        let eighths = normal[1].atan2(normal[0]) / (PI / 4.0);
        assert_near(eighths, eighths.round(), 1e-9);
    }
    let hole = block_with_hole(64, 0.1).cover(8);
    let walls = hole.pieces().iter().flat_map(|piece| &piece.normals).filter(|normal| normal[2] == 0.0);
    for normal in walls {
        let eighths = normal[1].atan2(normal[0]) / (PI / 4.0);
        assert_near(eighths, eighths.round(), 1e-9);
    }
}

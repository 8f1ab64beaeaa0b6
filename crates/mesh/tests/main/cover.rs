//! Covers of canonical shapes: number of pieces, deviation, clearance.

use std::f64::consts::PI;

use crate::shapes::{
    self, CROSS, L, Shape, T_SLOT, block_with_hole, chamfered_peg, countersunk_block, cube, prism, rotation, stack,
    tube,
};
use mesh::{Cover, CoverSettings, Deviation, MeshError};

fn pieces(shape: &Shape) -> usize {
    shape.cover(24).pieces().len()
}

/// Number of pieces, also of the shape turned and rounded.
fn assert_pieces(shape: &Shape, expected: usize) {
    assert_eq!(pieces(shape), expected);
    for angle in [0.3, 1.1, 2.5] {
        assert_eq!(pieces(&shape.turned(&rotation(angle))), expected, "turned by {angle}");
    }
}

#[test]
fn convex_parts_are_one_piece() {
    assert_pieces(&cube(10.0), 1);
    assert_pieces(&chamfered_peg(48), 1);
    let hexagon: Vec<[f64; 2]> = shapes::circle(8.0, 0.0, 6, 0.2).iter().map(|[x, y, _]| [*x, *y]).collect();
    assert_pieces(&prism(&hexagon, 20.0), 1);
    assert_eq!(prism(&hexagon, 20.0).cover(24).pieces()[0].normals.len(), 8);
}

#[test]
fn prisms_with_inner_corners_have_few_pieces() {
    assert_pieces(&prism(&L, 7.0), 2);
    assert_pieces(&prism(&CROSS, 7.0), 2);
    // Floor, two walls and two lips.
    assert_pieces(&prism(&T_SLOT, 7.0), 5);
}

#[test]
fn a_blind_hole_has_a_wall_per_side_and_a_floor() {
    for (sides, phase) in [(4, PI / 4.0), (4, 0.3), (8, PI / 8.0), (6, 0.1)] {
        let shape = block_with_hole(sides, phase);
        assert_pieces(&shape, sides + 1);
    }
    let cover = block_with_hole(8, PI / 8.0).cover(24);
    let rows: Vec<usize> = cover.pieces().iter().map(|piece| piece.normals.len()).collect();
    assert!(rows.iter().all(|rows| (5..=7).contains(rows)), "{rows:?}");
    assert!(cover.pieces().iter().flat_map(|piece| &piece.is_surface).all(|is_surface| *is_surface));
}

#[test]
fn a_round_hole_has_a_wall_per_facet_and_a_floor() {
    assert_eq!(block_with_hole(96, 0.0).cover(16).pieces().len(), 17);
    assert_eq!(block_with_hole(90, 0.03).cover(16).pieces().len(), 17);
}

#[test]
fn a_countersink_needs_no_pieces_of_its_own() {
    assert_eq!(countersunk_block(96).cover(16).pieces().len(), 17);
    assert_eq!(countersunk_block(90).cover(16).pieces().len(), 17);
}

#[test]
fn a_tube_has_a_piece_per_facet() {
    assert_eq!(tube(96).cover(12).pieces().len(), 12);
}

#[test]
fn deviations_are_within_the_errors_that_are_reported() {
    let shapes = [block_with_hole(96, 0.0), countersunk_block(90), chamfered_peg(60), tube(72), prism(&T_SLOT, 7.0)];
    for shape in shapes {
        let solid = shape.solid();
        let cover = Cover::of(&solid, &CoverSettings { facets: 12, ..CoverSettings::default() }).unwrap();
        let deviation = Deviation::measure(&solid, &cover);
        let surfaces = cover.curved_surfaces().iter();
        let error = surfaces.map(|(surface, facets)| surface.error(*facets) + surface.mesh_error).fold(0.0, f64::max);
        let rounding = 2.0 * cover.tolerance();
        assert!(deviation.uncovered <= rounding, "{deviation:?}");
        assert_eq!(deviation.missing_volume, 0.0);
        assert!(deviation.mesh_to_cover <= error + rounding, "{deviation:?}, {error}");
        assert!(deviation.cover_to_mesh <= error + rounding, "{deviation:?}, {error}");
        // Facets that are much coarser than the mesh differ from it.
        assert!(deviation.cover_to_mesh >= 0.8 * error, "{deviation:?}, {error}");
    }
}

#[test]
fn small_surfaces_keep_the_error_of_large_ones_with_fewer_facets() {
    let ring = |radius, z| shapes::circle(radius, z, 96, 0.0);
    let small = stack(&[ring(1.0, 0.0), ring(1.0, 5.0)], false).moved([30.0, 0.0, 0.0]);
    let solid = block_with_hole(96, 0.0).and(&small).solid();
    let error = 10e-3 * (1.0 - (PI / 64.0).cos());
    let facets = |error: f64| {
        let cover = Cover::of(&solid, &CoverSettings { facets: 64, error, ..CoverSettings::default() }).unwrap();
        let surfaces = cover.curved_surfaces().iter();
        let mut facets: Vec<(usize, usize)> =
            surfaces.map(|(surface, facets)| ((1e3 * surface.radii[0]).round() as usize, *facets)).collect();
        facets.sort_unstable();
        (facets, cover.pieces().len())
    };
    // 20 facets around a radius of 1 mm are off by 12.5 um, 24 by 8.6 um; 64 in the hole by 12.0 um.
    assert_eq!(facets(error).0, [(1, 24), (10, 64)]);
    assert_eq!(facets(0.0).0, [(1, 64), (10, 64)]);
    assert_eq!(facets(error).1, 66);
}

#[test]
fn a_deviation_notices_what_is_missing_and_what_is_too_much() {
    let cover = prism(&L, 7.0).cover(24);
    let more = Deviation::measure(&cube(20.0).solid(), &cover);
    assert!(more.uncovered > 5e-3 && more.missing_volume > 1e-7, "{more:?}");
    let less = Deviation::measure(&prism(&L, 7.0).solid(), &cube(20.0).cover(24));
    let outside = 8e-6 - 175.0 * 7e-9;
    assert!((less.outside_volume - outside).abs() < 5.0 * less.volume_error, "{less:?}");
    assert!(less.cover_to_mesh > 5e-3);
}

#[test]
fn a_clearance_moves_surfaces_by_itself() {
    let shape = block_with_hole(8, PI / 8.0);
    let solid = shape.solid();
    let nominal = Cover::of(&solid, &CoverSettings::default()).unwrap();
    let settings = CoverSettings { clearance: 1e-4, ..CoverSettings::default() };
    let loose = Cover::of(&solid, &settings).unwrap();
    assert_eq!(nominal.pieces().len(), loose.pieces().len());
    for (before, after) in nominal.pieces().iter().zip(loose.pieces()) {
        for (normal, offset) in after.normals.iter().zip(&after.offsets) {
            let same = before.normals.iter().position(|other| other == normal).unwrap();
            assert!((before.offsets[same] - offset - 1e-4).abs() < 1e-12);
        }
    }
    let deviation = Deviation::measure(&solid, &loose);
    // Seen from an edge, two surfaces have moved.
    assert!(deviation.mesh_to_cover >= 0.99e-4 && deviation.mesh_to_cover <= 2e-4, "{deviation:?}");
    let all = CoverSettings { clearance: 0.1, ..CoverSettings::default() };
    assert_eq!(Cover::of(&solid, &all).unwrap_err(), MeshError::NothingLeft);
}

#[test]
fn cuts_do_not_move() {
    let solid = block_with_hole(4, 0.0).solid();
    let crop = Some([[-1.0, -1.0, -1.0], [0.004, 1.0, 1.0]]);
    let cover = Cover::of(&solid, &CoverSettings { crop, clearance: 1e-3, ..CoverSettings::default() }).unwrap();
    let farthest = cover.pieces().iter().flat_map(|piece| &piece.vertices).map(|vertex| vertex[0]).fold(0.0, f64::max);
    assert!((farthest - 0.004).abs() < 1e-12);
}

#[test]
fn a_tolerance_saves_halfspaces_and_grows_by_less() {
    let solid = chamfered_peg(12).solid();
    let exact = Cover::of(&solid, &CoverSettings::default()).unwrap();
    let tolerance = 0.5e-3;
    let coarse = Cover::of(&solid, &CoverSettings { tolerance, ..CoverSettings::default() }).unwrap();
    assert_eq!((exact.growth(), exact.pieces()[0].normals.len()), (0.0, 26));
    assert!(coarse.pieces()[0].normals.len() <= 22, "{}", coarse.pieces()[0].normals.len());
    assert!(coarse.growth() > 0.0 && coarse.growth() <= tolerance);
    let deviation = Deviation::measure(&solid, &coarse);
    assert!(deviation.uncovered < 1e-8, "{deviation:?}");
}

#[test]
fn settings_are_checked() {
    let solid = cube(10.0).solid();
    let refused = |settings: CoverSettings| Cover::of(&solid, &settings).unwrap_err();
    let default = CoverSettings::default();
    assert!(matches!(refused(CoverSettings { facets: 2, ..default }), MeshError::Setting { name: "facets", .. }));
    assert!(matches!(refused(CoverSettings { clearance: -1.0, ..default }), MeshError::Setting { .. }));
    assert!(matches!(refused(CoverSettings { tolerance: f64::NAN, ..default }), MeshError::Setting { .. }));
    let far = CoverSettings { crop: Some([[1.0; 3], [2.0; 3]]), ..default };
    assert_eq!(Cover::of(&block_with_hole(4, 0.0).solid(), &far).unwrap_err(), MeshError::NothingLeft);
    assert_eq!(Cover::of(&solid, &far).unwrap().pieces().len(), 1, "a convex part is whole");
}

#[test]
fn only_what_faces_a_place_is_covered() {
    // A block of 30 mm with a blind hole: a place in the hole sees its walls and its floor, one above the block its top.
    let solid = block_with_hole(6, 0.0).solid();
    let settings = CoverSettings::default();
    let [low, high] = solid.bounding_box();
    let side = |axis: usize, sign: f64, offset: f64| {
        let mut normal = [0.0; 3];
        normal[axis] = sign;
        (normal, offset)
    };
    let place = |from: [f64; 3], to: [f64; 3]| -> Vec<([f64; 3], f64)> {
        (0..3).flat_map(|axis| [side(axis, 1.0, to[axis]), side(axis, -1.0, -from[axis])]).collect()
    };
    let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.0];
    let size = high[0] - low[0];
    let all = Cover::of(&solid, &settings).unwrap();
    assert_eq!(all.pieces().len(), 7);
    let column = place(
        [middle[0] - 0.3 * size, middle[1] - 0.3 * size, low[2] - 1.0],
        [middle[0] + 0.3 * size, middle[1] + 0.3 * size, high[2] + 1.0],
    );
    assert_eq!(Cover::facing(&solid, &settings, &[column]).unwrap().pieces().len(), 7);
    let beside = place([high[0] - 1e-4, low[1], low[2]], [high[0] + 1.0, high[1], high[2]]);
    let cover = Cover::facing(&solid, &settings, &[beside]).unwrap();
    assert!(cover.pieces().len() < 7, "{}", cover.pieces().len());
    assert!(Deviation::measure(&solid, &cover).uncovered < 1e-8);
    let away = place([high[0] + 1.0, low[1], low[2]], [high[0] + 2.0, high[1], high[2]]);
    assert_eq!(Cover::facing(&solid, &settings, &[away]).unwrap_err(), MeshError::NothingLeft);
}

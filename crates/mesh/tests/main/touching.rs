//! Covers that are exact where something passes, and surfaces that cross themselves.

use crate::shapes::{Shape, block_with_hole, circle, cube, prism, square, stack};
use mesh::{Budget, Cover, Gauge, Passage, Repair, Solid, hull_triangles};
use nalgebra::Isometry3;

const BUDGET: Budget = Budget { share: 0.05, most: 5e-5, least: 2e-6, reach: 1e-3, spacing: 3e-4 };

/// Ways out along z, in steps of 2 mm.
fn ways() -> Vec<Isometry3<f64>> {
    (0..17).map(|step| Isometry3::translation(0.0, 0.0, 0.002 * f64::from(step))).collect()
}

fn triangles(solid: &Solid) -> Vec<[[f64; 3]; 3]> {
    solid.corner_triangles().collect()
}

/// Covers of a body and of what it is taken out of.
fn covers(body: &Solid, other: &Solid) -> [Cover; 2] {
    let poses = ways();
    let back: Vec<Isometry3<f64>> = poses.iter().map(Isometry3::inverse).collect();
    let cover = |solid: &Solid, by: &Solid, poses: &[Isometry3<f64>]| {
        Cover::touching(solid, &[Passage { triangles: &triangles(by), poses }], BUDGET).unwrap()
    };
    [cover(body, other, &back), cover(other, body, &poses)]
}

/// All corners of a solid are in pieces, but for rounding.
fn assert_contained(solid: &Solid, cover: &Cover) {
    for corner in solid.points() {
        let height = |piece: &mesh::Piece| {
            let heights = piece.normals.iter().zip(&piece.offsets);
            heights.map(|(n, d)| n[0] * corner[0] + n[1] * corner[1] + n[2] * corner[2] - d).fold(f64::MIN, f64::max)
        };
        let least = cover.pieces().iter().map(height).fold(f64::MAX, f64::min);
        assert!(least < 1e-6, "{corner:?} is {least} m outside");
    }
}

/// The gap between pieces, and that between meshes, at each way out.
fn assert_gaps_agree(body: &Solid, other: &Solid, [body_cover, other_cover]: &[Cover; 2]) {
    let gauge = Gauge::of(other);
    let hulls = |cover: &Cover| -> Vec<Gauge> {
        cover.pieces().iter().map(|piece| Gauge::new(&hull_triangles(&piece.vertices))).collect()
    };
    let (bodies, others) = (hulls(body_cover), hulls(other_cover));
    let body = Gauge::of(body);
    for pose in ways() {
        let given = gauge.gap(&body, &pose);
        let pairs = bodies.iter().flat_map(|hull| others.iter().map(|other| other.gap(hull, &pose)));
        let pieces = pairs.fold(f64::INFINITY, f64::min);
        assert!((pieces - given).abs() <= 0.25 * given, "{pieces} {given} at {pose}");
    }
}

/// A bolt with a zigzag thread of radii 8.7 and 9.7.
fn bolt() -> Shape {
    let rings: Vec<Vec<[f64; 3]>> =
        (0..20).map(|at| circle(if at % 2 == 0 { 9.7 } else { 8.7 }, 6.0 + f64::from(at), 48, 0.0)).collect();
    stack(&rings, false)
}

#[test]
fn a_bar_in_a_groove_keeps_its_gap() {
    let groove = prism(
        &[[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [18.0, 20.0], [18.0, 8.0], [12.0, 8.0], [12.0, 20.0], [0.0, 20.0]],
        20.0,
    );
    let bar = prism(&[[12.2, 8.2], [17.8, 8.2], [17.8, 25.0], [12.2, 25.0]], 15.0).moved([0.0, 0.0, 3.0]);
    let (bar, groove) = (bar.solid(), groove.solid());
    let covers = covers(&bar, &groove);
    assert_eq!(covers.each_ref().map(|cover| cover.pieces().len()), [1, 3]);
    assert_contained(&bar, &covers[0]);
    assert_contained(&groove, &covers[1]);
    assert_gaps_agree(&bar, &groove, &covers);
}

#[test]
fn walls_that_are_rough_within_the_budget_need_few_pieces() {
    // Walls of many facets, each corner off by up to 2 micrometres.
    let outline =
        [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [18.0, 20.0], [18.0, 8.0], [12.0, 8.0], [12.0, 20.0], [0.0, 20.0]];
    let off = |index: usize| 2e-3 * ((index * 7919) % 101) as f64 / 100.0;
    let layer = |layer: usize| -> Vec<[f64; 3]> {
        let side = |at: usize| {
            let (from, to) = (outline[at], outline[(at + 1) % outline.len()]);
            (0..4).map(move |step| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * step as f64 / 4.0))
        };
        let points = (0..outline.len()).flat_map(side).enumerate();
        let rough = |(at, [x, y]): (usize, [f64; 2])| {
            let index = 97 * layer + 3 * at;
            [x + off(index), y + off(index + 1), 4.0 * layer as f64]
        };
        points.map(rough).collect()
    };
    let mut groove = Shape::default();
    let layers: Vec<Vec<usize>> = (0..6).map(|at| groove.add(&layer(at))).collect();
    for pair in layers.windows(2) {
        for at in 0..pair[0].len() {
            let next = (at + 1) % pair[0].len();
            groove.polygons.push(vec![pair[0][at], pair[0][next], pair[1][next]]);
            groove.polygons.push(vec![pair[0][at], pair[1][next], pair[1][at]]);
        }
    }
    groove.polygons.push(layers[0].iter().rev().copied().collect());
    groove.polygons.push(layers[5].clone());
    let groove = groove.solid();
    let bar = prism(&[[12.2, 8.2], [17.8, 8.2], [17.8, 25.0], [12.2, 25.0]], 15.0).moved([0.0, 0.0, 3.0]).solid();
    let covers = covers(&bar, &groove);
    assert!(covers[1].pieces().len() <= 4, "{}", covers[1].pieces().len());
    assert_contained(&groove, &covers[1]);
    assert_gaps_agree(&bar, &groove, &covers);
}

#[test]
fn a_groove_that_nothing_enters_is_filled_and_told() {
    // The groove is on the far side of the block.
    let profile =
        [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [18.0, 20.0], [18.0, 15.0], [12.0, 15.0], [12.0, 20.0], [0.0, 20.0]];
    let block = prism(&profile, 20.0).solid();
    let bar = cube(10.0).moved([10.0, -10.3, 3.0]).solid();
    let covers = covers(&bar, &block);
    assert_eq!(covers[1].pieces().len(), 1);
    assert!(covers[1].growth() > 1e-3, "{}", covers[1].growth());
    assert_contained(&block, &covers[1]);
    assert_gaps_agree(&bar, &block, &covers);
}

#[test]
fn a_thread_in_a_wide_hole_and_a_hole_keep_their_gap() {
    let (bolt, block) = (bolt().solid(), block_with_hole(48, 0.0).solid());
    let covers = covers(&bolt, &block);
    assert_contained(&bolt, &covers[0]);
    assert_contained(&block, &covers[1]);
    assert_gaps_agree(&bolt, &block, &covers);
}

#[test]
fn bodies_that_cross_are_one() {
    let both = cube(10.0).and(&cube(10.0).moved([5.0, 4.0, 3.0])).solid();
    assert!(both.is_rough());
    assert!(matches!(both.repairs(), [Repair::Decided { open: 0, hidden: 0, .. }]), "{:?}", both.repairs());
    let volume = 1e9 * both.mass_properties().volume;
    assert!((volume / (2000.0 - 5.0 * 6.0 * 7.0) - 1.0).abs() < 0.02, "{volume}");
    // A rod above one of the two, 0.5 mm away.
    let rod = stack(&[square(2.0, 10.5), square(2.0, 30.0)], false).moved([2.5, 2.0, 0.0]).solid();
    let covers = covers(&rod, &both);
    assert_contained(&both, &covers[1]);
    assert_gaps_agree(&rod, &both, &covers);
}

#[test]
fn a_crack_is_no_opening_and_a_missing_face_is_one() {
    // The lid of a block floats above its sides.
    let gap = |gap: f64| {
        let mut shape = cube(100.0);
        let lid = shape.polygons.pop().unwrap();
        let corners: Vec<[f64; 3]> = lid.iter().map(|&corner| shape.vertices[corner]).collect();
        let mut raised: Vec<[f64; 3]> = corners.iter().map(|[x, y, z]| [*x, *y, z + gap]).collect();
        // A corner in the middle of a side of its own.
        let middle = std::array::from_fn(|axis| 0.5 * (raised[0][axis] + raised[1][axis]));
        raised.insert(1, middle);
        let lid = shape.add(&raised);
        shape.polygons.push(lid);
        shape.mesh()
    };
    let narrow = Solid::of(&gap(0.012)).unwrap();
    assert!(matches!(narrow.repairs(), [Repair::Decided { open: 9, .. }]), "{:?}", narrow.repairs());
    assert!(Solid::of(&gap(0.5)).unwrap_err().to_string().contains("open"));
}

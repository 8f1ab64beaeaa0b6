//! Contacts compared with those of an exhaustive search, as bodies move.

use collision::{Pair, Polytope};
use nalgebra::{Rotation3, Translation3};
use proptest::prelude::*;

use super::*;
use crate::arc::Arc;
use crate::axis::Axis;

/// The best axis of all facets and all pairs of edges. Edges are not examined when a facet alone separates the parts by
/// more than `reach` (m).
fn best_axis(body: &Solid, environment: &Solid, reach: f64) -> Axis {
    let (facet, vertex, separation) = best_facet(environment, body);
    let normal = environment.facets[facet].normal;
    let mut best = Axis { separation, normal, feature: Feature::EnvironmentFacet { facet, vertex } };
    let (facet, vertex, separation) = best_facet(body, environment);
    if separation > best.separation + PREFERENCE {
        let normal = -body.facets[facet].normal;
        best = Axis { separation, normal, feature: Feature::BodyFacet { facet, vertex } };
    }
    if best.separation > reach {
        return best;
    }
    match best_edges(body, environment) {
        Some(edges) if edges.separation > best.separation + PREFERENCE => edges,
        _ => best,
    }
}

fn best_facet(first: &Solid, second: &Solid) -> (usize, usize, f64) {
    let mut best = (0, 0, f64::NEG_INFINITY);
    for (index, facet) in first.facets.iter().enumerate() {
        let (vertex, height) = second.lowest(&facet.normal);
        if height - facet.offset > best.2 {
            best = (index, vertex, height - facet.offset);
        }
    }
    best
}

fn best_edges(body: &Solid, environment: &Solid) -> Option<Axis> {
    let mut best: Option<Axis> = None;
    for (first, edge) in body.edges.iter().enumerate() {
        for (second, opposite) in environment.edges.iter().enumerate() {
            let (arc, reversed) = (Arc::new(body, edge), Arc::new(environment, opposite).reversed());
            let gap = body.vertices[edge.ends[0]] - environment.vertices[opposite.ends[0]];
            let least = best.map_or(f64::NEG_INFINITY, |best| best.separation);
            if arc.crosses(&reversed)
                && let Some((separation, normal)) = arc.separation(&reversed, &gap, least)
            {
                best = Some(Axis { separation, normal, feature: Feature::Edges(first, second) });
            }
        }
    }
    best
}

fn placed(solid: &Solid, pose: &Isometry3<f64>) -> Solid {
    let mut placed = solid.clone();
    placed.place(solid, &pose.rotation.to_rotation_matrix(), &pose.translation.vector);
    placed
}

fn shapes(body: &Polytope, environment: &Polytope) -> Shapes {
    let shapes = Pair::new(body.clone(), environment.clone());
    Shapes::new(&[ContactPair { body: "body".into(), environment: "environment".into(), shapes }])
}

/// A prism over a regular polygon of about the size of the other shapes.
fn prism(sides: usize) -> Polytope {
    let vertex = |index: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * (index / 2) as f64 / sides as f64).sin_cos();
        [0.05 * cosine, 0.05 * sine, if index.is_multiple_of(2) { -0.06 } else { 0.06 }]
    };
    Polytope::from_vertices(&(0..2 * sides).map(vertex).collect::<Vec<_>>()).unwrap()
}

fn shape() -> impl Strategy<Value = Polytope> {
    let vertex = proptest::array::uniform3(-0.1..0.1_f64);
    let hull = |vertices: Vec<[f64; 3]>| Polytope::from_vertices(&vertices).ok();
    prop_oneof![
        proptest::collection::vec(vertex, 6..20).prop_filter_map("flat", hull),
        proptest::array::uniform3(0.02..0.2_f64).prop_map(|edges| Polytope::from_box(edges).unwrap()),
        (3..30_usize).prop_map(prism),
    ]
}

/// Upright, so that faces and edges are parallel, nearly so, or in any orientation.
fn orientation() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let rotation = prop_oneof![Just(0.0), -1e-6..1e-6_f64, -1e-3..1e-3_f64, -2.0..2.0_f64];
    proptest::array::uniform3(rotation).prop_map(|rotation| UnitQuaternion::from_scaled_axis(rotation.into()))
}

/// Gap of the first pose (m) along a direction: touching, apart, or deep penetration.
fn gap() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -1e-6..1e-6_f64, -1e-3..2e-3_f64, -0.2..0.02_f64]
}

/// Shift and rotation of every step, as multiples of the reach; a body may also slide or rest.
fn motion() -> impl Strategy<Value = Vec<[f64; 6]>> {
    let step = prop_oneof![
        Just([0.0; 6]),
        (-1.0..1.0_f64, -1.0..1.0_f64).prop_map(|(x, y)| [x, y, 0.0, 0.0, 0.0, 0.0]),
        proptest::array::uniform6(-1.0..1.0_f64),
        proptest::array::uniform6(-0.1..0.1_f64),
    ];
    (step.clone(), proptest::collection::vec(step, 1..60)).prop_map(|(drift, steps)| {
        steps.iter().map(|step| std::array::from_fn(|index| step[index] + 0.5 * drift[index])).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn a_moving_body_touches_where_an_exhaustive_search_says(
        (body, environment, orientation) in (shape(), shape(), orientation()),
        (direction, gap, motion) in (proptest::array::uniform3(-1..=1_i32), gap(), motion()),
        reach in prop_oneof![Just(0.0), 1e-6..1e-4_f64, 1e-4..1e-2_f64],
    ) {
        let shapes = shapes(&body, &environment);
        let (own, environment) = (&shapes.bodies[0], &shapes.pairs[0].environment);
        let mut pose = Isometry3::from_parts(Translation3::identity(), orientation);
        // In contact along the direction but for the gap.
        let direction = Vector3::from(direction.map(f64::from)).try_normalize(0.5).unwrap_or(Vector3::z());
        let lowest = placed(own, &pose).lowest(&direction).1;
        let highest = -environment.lowest(&-direction).1;
        pose.translation.vector = direction * (highest - lowest + gap);
        let mut finder = ContactFinder::new(&shapes, 0.0);
        for step in motion {
            let [x, y, z, p, q, r] = step.map(|component| component * reach);
            pose.translation.vector += Vector3::new(x, y, z);
            pose.rotation *= UnitQuaternion::from_scaled_axis(Vector3::new(p, q, r) / 0.1);
            let mut copy = finder.clone();
            let separation = finder.find(&pose, reach);
            prop_assert_eq!(copy.find(&pose, reach).min(reach), separation.min(reach), "a copy begins without memory");
            prop_assert_eq!(&copy.contacts, &finder.contacts);
            let expected = best_axis(&placed(own, &pose), environment, reach);
            if separation > reach {
                prop_assert!(expected.separation > reach, "{} and {:?}", separation, expected);
                prop_assert!(finder.contacts.is_empty());
                continue;
            }
            prop_assert_eq!(separation, expected.separation);
            prop_assert!(finder.contacts.iter().all(|contact| contact.normal == expected.normal));
            prop_assert!(separation >= 0.0 || !finder.contacts.is_empty());
        }
    }

    #[test]
    fn descending_along_edges_ends_at_the_lowest_vertex(
        shape in shape(),
        orientation in orientation(),
        direction in proptest::array::uniform3(-1.0..1.0_f64),
        first in 0..1000_usize,
    ) {
        let solid = placed(&Solid::new(&shape), &Isometry3::from_parts(Translation3::identity(), orientation));
        for direction in [direction, [0.0, 0.0, 1.0]].map(Vector3::from) {
            let (vertex, height) = solid.descend(first % solid.vertices.len(), &direction);
            prop_assert_eq!(height, direction.dot(&solid.vertices[vertex]));
            let lowest = solid.lowest(&direction).1;
            prop_assert!((height - lowest).abs() < 1e-15, "{} and {}", height, lowest);
        }
    }

    /// The planner's distance is an independent oracle: its sign is that of the separation.
    #[test]
    fn separation_has_the_sign_of_the_exact_distance(
        (body, environment) in (shape(), shape()),
        shift in proptest::array::uniform3(-0.2..0.2_f64),
        orientation in orientation(),
    ) {
        let pose = Isometry3::from_parts(shift.into(), orientation);
        let separation = ContactFinder::new(&shapes(&body, &environment), 0.0).find(&pose, 1.0);
        let rotation = orientation.quaternion();
        let [x, y, z] = shift;
        let pose = [x, y, z, rotation.w, rotation.i, rotation.j, rotation.k];
        let distance = Pair::new(body, environment).exact_distance(&pose);
        prop_assume!(distance.abs() > 2.0 * PREFERENCE);
        prop_assert!(separation * distance > 0.0, "{} and {}", separation, distance);
    }
}

#[test]
fn a_turn_moves_points_no_further_than_its_bound() {
    for angle in [0.0, 1e-9, 1e-3, 0.5, 2.0, 3.1] {
        for sign in [1.0, -1.0] {
            let rotation = UnitQuaternion::from_scaled_axis(Vector3::z() * angle);
            let rotated = UnitQuaternion::new_unchecked(rotation.into_inner() * sign);
            let moved = (Rotation3::from(rotation) * Vector3::x() - Vector3::x()).norm();
            let bound = largest_rotation(&UnitQuaternion::identity(), &rotated);
            assert!(bound >= moved - 1e-15 && bound <= angle + 1e-15, "{angle}: {bound} and {moved}");
        }
    }
}

#[test]
fn contacts_block_the_parts_of_a_way_that_lead_into_them() {
    let cube = Polytope::from_box([0.1; 3]).unwrap();
    let shapes = shapes(&cube, &cube);
    let mut finder = ContactFinder::new(&shapes, 0.0);
    let way = Vector3::new(3.0, -1.0, -2.0);
    assert_eq!(finder.unblocked(&way), way, "nothing touches");
    let normals = |finder: &mut ContactFinder, normals: &[Vector3<f64>]| {
        let contact = |normal: &Vector3<f64>| Contact { pair: 0, point: Vector3::zeros(), normal: *normal, gap: 0.0 };
        finder.contacts = normals.iter().map(contact).collect();
    };
    normals(&mut finder, &[Vector3::z(), Vector3::z(), -Vector3::y()]);
    assert_eq!(finder.unblocked(&way), Vector3::new(3.0, -1.0, 0.0), "along a floor and away from a wall");
    // In a narrow groove, the normal of one wall leads into the other.
    let wall = |side: f64| Vector3::new(0.8 * side, 0.0, 0.6);
    normals(&mut finder, &[wall(1.0), wall(-1.0), Vector3::z()]);
    let left = finder.unblocked(&Vector3::new(1.0, 2.0, -1.0));
    assert!((left - Vector3::new(0.0, 2.0, 0.0)).norm() < 0.1, "about along the groove: {left}");
}

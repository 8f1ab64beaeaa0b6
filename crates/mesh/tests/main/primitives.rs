//! Boxes and cylinders as meshes.

use std::f64::consts::PI;

use mesh::{Cover, CoverSettings, CurvedKind, Solid, TriangleMesh};
use proptest::prelude::*;

fn solid(mesh: TriangleMesh) -> Solid {
    Solid::of(&mesh).unwrap()
}

fn near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 1e-9 * other.abs()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_box_is_exact(edges in prop::array::uniform3(1e-4f64..2.0)) {
        let solid = solid(TriangleMesh::cuboid(edges).unwrap());
        prop_assert!(solid.repairs().is_empty() && solid.curved_surfaces().is_empty());
        prop_assert!(near(solid.mass_properties().volume, edges.iter().product()));
        let cover = Cover::of(&solid, &CoverSettings::default()).unwrap();
        let [piece] = cover.pieces() else { panic!("{} pieces", cover.pieces().len()) };
        prop_assert_eq!(piece.normals.len(), 6);
        for (normal, offset) in piece.normals.iter().zip(&piece.offsets) {
            let axis = (0..3).find(|&axis| normal[axis].abs() == 1.0);
            prop_assert!(axis.is_some_and(|axis| near(*offset, 0.5 * edges[axis])), "{:?} {}", normal, offset);
        }
    }

    #[test]
    fn a_cylinder_is_recognised(radius in 1e-4f64..1.0, slenderness in 0.05f64..20.0, facets in 3usize..40) {
        let length = slenderness * radius;
        let solid = solid(TriangleMesh::cylinder(radius, length).unwrap());
        let surfaces = solid.curved_surfaces();
        let [surface] = &surfaces[..] else { panic!("{surfaces:?}") };
        prop_assert!(surface.kind == CurvedKind::Cylinder && surface.is_convex);
        prop_assert!(near(surface.radii[0], radius) && surface.radii[0] == surface.radii[1]);
        prop_assert!((solid.mass_properties().volume / (PI * radius * radius * length) - 1.0).abs() < 4e-4);
        let cover = Cover::of(&solid, &CoverSettings { facets, ..CoverSettings::default() }).unwrap();
        let [piece] = cover.pieces() else { panic!("{} pieces", cover.pieces().len()) };
        prop_assert_eq!(piece.normals.len(), facets + 2);
        for (normal, offset) in piece.normals.iter().zip(&piece.offsets) {
            let right = if normal[2].abs() > 0.5 { 0.5 * length } else { radius };
            prop_assert!(near(*offset, right), "{:?}: {} is not {}", normal, offset, right);
        }
    }
}

//! Degenerate contacts, invalid poses, and exact distances compared with enumeration.

use collision::{Instructions, Pair, Polytope, Request, Solutions};
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};
use proptest::prelude::*;

type Pose = [f64; 7];

const SMOOTHINGS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];

fn smoothed(pair: &Pair, pose: &Pose, tau: f64) -> f64 {
    pair.distance(pose, tau).unwrap().smoothed_distance
}

fn cubes() -> Pair {
    Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap())
}

/// Minimum of `2 alpha` over all corners of the linear program (Eq. sdfopt), by enumeration.
fn enumerated_distance(pair: &Pair, at: Pose) -> f64 {
    let [x, y, z, w, i, j, k] = at;
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k));
    let position = Vector3::new(x, y, z);
    let moved = pair.body().normals().iter().zip(pair.body().offsets()).map(|(normal, offset)| {
        let normal = rotation * Vector3::from(*normal);
        (normal, offset + normal.dot(&position))
    });
    let fixed = pair.environment().normals().iter().zip(pair.environment().offsets());
    let rows: Vec<(Vector4<f64>, f64)> = moved
        .chain(fixed.map(|(normal, offset)| (Vector3::from(*normal), *offset)))
        .map(|(normal, offset)| (Vector4::new(normal.x, normal.y, normal.z, -1.0), offset))
        .collect();
    let mut least = f64::INFINITY;
    for a in 0..rows.len() {
        for b in a + 1..rows.len() {
            for c in b + 1..rows.len() {
                for d in c + 1..rows.len() {
                    let corner = [a, b, c, d].map(|row| rows[row]);
                    let matrix = Matrix4::from_rows(&corner.map(|(row, _)| row.transpose()));
                    if matrix.determinant().abs() < 1e-9 {
                        continue;
                    }
                    let offsets = Vector4::from(corner.map(|(_, offset)| offset));
                    let Some(z) = matrix.full_piv_lu().solve(&offsets) else { continue };
                    if rows.iter().all(|(row, offset)| row.dot(&z) <= offset + 1e-12) {
                        least = least.min(2.0 * z[3]);
                    }
                }
            }
        }
    }
    least
}

proptest! {
    #[test]
    fn exact_distance_solves_the_linear_program(
        edges in prop::array::uniform6(0.02..0.2f64),
        position in prop::array::uniform3(-0.2..0.2f64),
        quaternion in prop::array::uniform4(0.1..1.5f64),
    ) {
        let [a, b, c, d, e, f] = edges;
        let pair = Pair::new(Polytope::from_box([a, b, c]).unwrap(), Polytope::from_box([d, e, f]).unwrap());
        let ([x, y, z], [w, i, j, k]) = (position, quaternion);
        let at = [x, y, z, w, i, -j, k];
        let (exact, expected) = (pair.exact_distance(&at), enumerated_distance(&pair, at));
        prop_assert!((exact - expected).abs() <= 1e-11, "{exact} instead of {expected}");
    }
}

#[test]
fn crossed_edges_converge() {
    let (sine, cosine) = (std::f64::consts::PI / 8.0).sin_cos();
    let reach = 0.05 + 0.05 * std::f64::consts::SQRT_2;
    for tau in SMOOTHINGS {
        let phi = smoothed(&cubes(), &[reach, 0.0, 0.0, cosine, 0.0, 0.0, sine], tau);
        assert!((-1e-12..=12.0 * tau * (1.0 + 1e-8)).contains(&phi), "tau = {tau:e}: {phi}");
    }
}

/// A large peg that leaves its hole: its lower face is in the plane of the upper faces around it.
#[test]
fn large_parts_with_faces_in_one_plane_have_a_distance() {
    let sides: Vec<[f64; 3]> = (0..8)
        .map(|side| std::f64::consts::FRAC_PI_4 * f64::from(side))
        .map(|angle| [angle.cos(), angle.sin(), 0.0])
        .collect();
    let caps = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let normals: Vec<[f64; 3]> = sides.iter().copied().chain(caps).collect();
    let peg = Polytope::from_halfspaces(&normals, &[[0.5; 8].as_slice(), &[0.02, 0.02]].concat()).unwrap();
    let (side, clearance) = (sides[1], 3e-4);
    let wall = [side, side.map(|part| -part), [side[1], -side[0], 0.0], [-side[1], side[0], 0.0], caps[0], caps[1]];
    let wall = Polytope::from_halfspaces(&wall, &[0.9333, -0.5 - clearance, 0.64, 0.64, 0.0, 0.024]).unwrap();
    let distance = Pair::new(peg, wall).exact_distance(&[0.0, 0.0, 0.02, 1.0, 0.0, 0.0, 0.0]);
    assert!((distance - clearance).abs() < 1e-5, "{distance}");
}

#[test]
fn an_invalid_pose_is_an_error_in_every_coordinate() {
    let good = [0.13, 0.02, -0.01, 0.9, 0.1, 0.2, -0.3];
    let zero_quaternion = [0.13, 0.02, -0.01, 0.0, 0.0, 0.0, 0.0];
    for instructions in Instructions::available() {
        for coordinate in 0..8 {
            let mut bad = good;
            if coordinate < 7 {
                bad[coordinate] = f64::NAN;
            } else {
                bad = zero_quaternion;
            }
            let poses = [good, good, bad, good];
            let mut values = [[0.0; 7]; 4];
            let mut solutions = Solutions::default();
            // Also again: what failed is not kept.
            for _ in 0..2 {
                let request = Request::Values(&mut values);
                let error = cubes().evaluate(instructions, &poses, 1e-4, &mut solutions, request).unwrap_err();
                assert_eq!(error.index, 2, "{instructions:?}, coordinate {coordinate}");
            }
        }
    }
}

#[test]
fn no_poses_are_no_work() {
    cubes().contacts(&[], 1e-4, &mut Solutions::default(), &mut [[0.0; 7]; 0]).unwrap();
}

/// A small version of `examples/robustness.rs`: irregular parts that coincide.
#[test]
fn twins_in_the_same_place_converge() {
    let corners: [[f64; 3]; 7] = [
        [0.05, 0.0, 0.01],
        [-0.04, 0.02, 0.0],
        [0.0, -0.05, 0.02],
        [0.01, 0.04, -0.03],
        [0.0, 0.01, 0.05],
        [-0.02, -0.02, -0.04],
        [0.03, 0.03, 0.03],
    ];
    let part = Polytope::from_vertices(&corners).unwrap();
    let pair = Pair::new(part.clone(), part);
    let poses: Vec<Pose> = [0.0, 1e-12, 1e-6, 1e-3].map(|shift| [shift, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).to_vec();
    for tau in SMOOTHINGS {
        let mut values = [[0.0; 7]; 4];
        let (solutions, request) = (&mut Solutions::default(), Request::Values(&mut values));
        let iterations = pair.evaluate(Instructions::best(), &poses, tau, solutions, request).unwrap();
        assert!(iterations <= 14, "tau = {tau:e}: {iterations} iterations");
    }
}

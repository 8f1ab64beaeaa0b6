//! Properties that distances and derivatives have at every pose, and hard cases by name.

use collision::{Instructions, Pair, Polytope, Request};
use nalgebra::{Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};
use proptest::prelude::*;

type Pose = [f64; 7];
type Matrix = [[f64; 7]; 7];

/// Everything at many poses with the given instructions.
fn evaluate(
    pair: &Pair,
    instructions: Instructions,
    poses: &[Pose],
    tau: f64,
    seeds: &[[f64; 7]],
) -> (Vec<[f64; 7]>, Vec<Matrix>, Vec<Matrix>) {
    let count = poses.len();
    let (mut values, mut jacobians) = (vec![[0.0; 7]; count], vec![[[0.0; 7]; 7]; count]);
    let mut hessians = jacobians.clone();
    let request = Request::Hessians { seeds, values: &mut values, jacobians: &mut jacobians, hessians: &mut hessians };
    pair.evaluate(instructions, poses, tau, request).unwrap();
    (values, jacobians, hessians)
}

fn smoothed(pair: &Pair, pose: &Pose, tau: f64) -> f64 {
    pair.distance(pose, tau).unwrap().smoothed_distance
}

fn cubes() -> Pair {
    Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap())
}

fn isometry([x, y, z, w, i, j, k]: Pose) -> (UnitQuaternion<f64>, Vector3<f64>) {
    (UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k)), Vector3::new(x, y, z))
}

fn pose((rotation, position): (UnitQuaternion<f64>, Vector3<f64>)) -> Pose {
    let [i, j, k, w]: [f64; 4] = rotation.coords.into();
    [position.x, position.y, position.z, w, i, j, k]
}

/// Minimum of `2 alpha` over all corners of the linear program (Eq. sdfopt), by enumeration.
fn enumerated_distance(pair: &Pair, at: Pose) -> f64 {
    let (rotation, position) = isometry(at);
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

fn number(size: f64) -> impl Strategy<Value = f64> {
    -size..size
}

/// Quaternions of any norm that is not close to zero.
fn any_pose() -> impl Strategy<Value = Pose> {
    (proptest::array::uniform3(number(0.2)), proptest::array::uniform4(number(1.5)))
        .prop_filter("a quaternion", |(_, quaternion)| quaternion.iter().map(|c| c * c).sum::<f64>() > 0.1)
        .prop_map(|([x, y, z], [w, i, j, k])| [x, y, z, w, i, j, k])
}

fn any_part() -> impl Strategy<Value = Polytope> {
    let points = proptest::collection::vec(proptest::array::uniform3(number(0.05)), 6..14);
    let hull = points.prop_filter_map("a solid", |points| Polytope::from_vertices(&points).ok());
    let cuboid = proptest::array::uniform3(0.02..0.2).prop_map(|edges| Polytope::from_box(edges).unwrap());
    prop_oneof![hull, cuboid]
}

fn any_pair() -> impl Strategy<Value = Pair> {
    (any_part(), any_part()).prop_map(|(body, environment)| Pair::new(body, environment))
}

fn any_smoothing() -> impl Strategy<Value = f64> {
    (-7.0..-2.0).prop_map(|exponent: f64| 10f64.powf(exponent))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn roles_can_be_swapped(pair in any_pair(), at in any_pose(), tau in any_smoothing()) {
        let (rotation, position) = isometry(at);
        let inverse = pose((rotation.inverse(), -(rotation.inverse() * position)));
        let swapped = Pair::new(pair.environment().clone(), pair.body().clone());
        prop_assert!((smoothed(&pair, &at, tau) - smoothed(&swapped, &inverse, tau)).abs() <= 1e-9);
    }

    #[test]
    fn moving_both_parts_changes_nothing(
        pair in any_pair(), at in any_pose(), motion in any_pose(), tau in any_smoothing(),
    ) {
        let ((turn, shift), (rotation, position)) = (isometry(motion), isometry(at));
        let [x, y, z, w, i, j, k] = motion;
        let moved = Pair::new(pair.body().clone(), pair.environment().placed([x, y, z], [w, i, j, k]));
        let together = pose((turn * rotation, turn * position + shift));
        prop_assert!((smoothed(&pair, &at, tau) - smoothed(&moved, &together, tau)).abs() <= 1e-9);
    }

    /// The duality gap of the point `tau` of the central path is `n_g tau`.
    #[test]
    fn smoothing_adds_at_most_the_duality_gap(pair in any_pair(), at in any_pose(), tau in any_smoothing()) {
        let added = smoothed(&pair, &at, tau) - pair.exact_distance(&at);
        prop_assert!(added >= -1e-11 && added <= pair.row_count() as f64 * tau * (1.0 + 1e-8) + 1e-11, "{added:e}");
    }

    #[test]
    fn less_smoothing_is_closer(pair in any_pair(), at in any_pose(), tau in any_smoothing()) {
        prop_assert!(smoothed(&pair, &at, 0.5 * tau) <= smoothed(&pair, &at, tau) + 1e-12);
    }

    #[test]
    fn exact_distance_solves_the_linear_program(
        edges in proptest::array::uniform6(0.02..0.2), at in any_pose(),
    ) {
        let [a, b, c, d, e, f] = edges;
        let pair = Pair::new(Polytope::from_box([a, b, c]).unwrap(), Polytope::from_box([d, e, f]).unwrap());
        let (exact, expected) = (pair.exact_distance(&at), enumerated_distance(&pair, at));
        prop_assert!((exact - expected).abs() <= 1e-11, "{exact} instead of {expected}");
    }

    #[test]
    fn derivatives_match_central_differences(
        pair in any_pair(), at in any_pose(), seed in proptest::array::uniform7(number(1.0)),
    ) {
        check_derivatives(&pair, at, 1e-3, seed)?;
    }

    #[test]
    fn instructions_do_not_change_a_bit(
        pair in any_pair(), poses in proptest::collection::vec(any_pose(), 1..20), tau in any_smoothing(),
    ) {
        let seeds = vec![[0.5, -1.0, 0.3, 0.7, -0.2, 0.9, 0.1]; poses.len()];
        let expected = evaluate(&pair, Instructions::scalar(), &poses, tau, &seeds);
        for instructions in [Some(Instructions::best()), Instructions::avx2()].into_iter().flatten() {
            prop_assert!(evaluate(&pair, instructions, &poses, tau, &seeds) == expected, "{instructions:?}");
        }
    }
}

/// `DW` against differences of `W`, `<s, D2W>` against differences of `s' DW`.
fn check_derivatives(pair: &Pair, at: Pose, tau: f64, seed: [f64; 7]) -> Result<(), TestCaseError> {
    const STEP: f64 = 1e-6;
    let poses: Vec<Pose> = std::iter::once(at)
        .chain((0..14).map(|index| {
            let mut moved = at;
            moved[index / 2] += if index % 2 == 0 { STEP } else { -STEP };
            moved
        }))
        .collect();
    let (values, jacobians, hessians) = evaluate(pair, Instructions::best(), &poses, tau, &[seed; 15]);
    let weighted = |jacobian: &Matrix, row: usize| -> f64 { (0..7).map(|c| seed[c] * jacobian[c][row]).sum() };
    let scale = |matrix: &Matrix| matrix.as_flattened().iter().fold(1.0, |scale: f64, entry| scale.max(entry.abs()));
    let (first_scale, second_scale) = (scale(&jacobians[0]), scale(&hessians[0]));
    for column in 0..7 {
        let (ahead, behind) = (1 + 2 * column, 2 + 2 * column);
        for row in 0..7 {
            let analytic = jacobians[0][row][column];
            let difference = (values[ahead][row] - values[behind][row]) / (2.0 * STEP);
            prop_assert!(
                (analytic - difference).abs() <= 1e-5 * first_scale,
                "DW[{row}][{column}]: analytic {analytic:e}, difference {difference:e}"
            );
            let analytic = hessians[0][row][column];
            let difference = (weighted(&jacobians[ahead], row) - weighted(&jacobians[behind], row)) / (2.0 * STEP);
            prop_assert!(
                (analytic - difference).abs() <= 1e-5 * second_scale,
                "D2W[{row}][{column}]: analytic {analytic:e}, difference {difference:e}"
            );
        }
    }
    Ok(())
}

const SMOOTHINGS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];

#[test]
fn coincident_parts_converge() {
    for tau in SMOOTHINGS {
        let phi = smoothed(&cubes(), &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], tau);
        assert!(phi >= -0.1 && phi <= -0.1 + 12.0 * tau * (1.0 + 1e-8), "tau = {tau:e}: {phi}");
    }
}

#[test]
fn parallel_faces_converge() {
    for tau in SMOOTHINGS {
        for shift in [0.0, 0.02, 0.05, 0.1] {
            let phi = smoothed(&cubes(), &[0.1, shift, 0.0, 1.0, 0.0, 0.0, 0.0], tau);
            assert!((-1e-12..=12.0 * tau * (1.0 + 1e-8)).contains(&phi), "tau = {tau:e}, shift {shift}: {phi}");
        }
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

#[test]
fn a_pose_that_is_no_number_is_an_error_and_spoils_no_other() {
    let good = [0.13, 0.02, -0.01, 0.9, 0.1, 0.2, -0.3];
    let zero_quaternion = [0.13, 0.02, -0.01, 0.0, 0.0, 0.0, 0.0];
    for instructions in [Some(Instructions::best()), Instructions::avx2(), Some(Instructions::scalar())] {
        let Some(instructions) = instructions else { continue };
        for coordinate in 0..8 {
            let mut bad = good;
            if coordinate < 7 {
                bad[coordinate] = f64::NAN;
            } else {
                bad = zero_quaternion;
            }
            let poses = [good, good, bad, good];
            let mut values = [[0.0; 7]; 4];
            let error = cubes().evaluate(instructions, &poses, 1e-4, Request::Values(&mut values)).unwrap_err();
            assert_eq!(error.index, 2, "{instructions:?}, coordinate {coordinate}");
        }
    }
}

#[test]
fn no_poses_are_no_work() {
    cubes().contacts(&[], 1e-4, &mut []).unwrap();
}

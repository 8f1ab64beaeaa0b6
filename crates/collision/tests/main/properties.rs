//! Properties of every pair and pose.

use collision::{Instructions, Pair, Polytope, Request, Solutions};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;

fn solid() -> impl Strategy<Value = Polytope> {
    let points = prop::collection::vec(prop::array::uniform3(-0.05..0.05f64), 6..12);
    points.prop_filter_map("points that span a solid", |points| Polytope::from_vertices(&points).ok())
}

fn pose() -> impl Strategy<Value = [f64; 7]> {
    (prop::array::uniform3(-0.1..0.1f64), prop::array::uniform4(-1.0..1.0f64))
        .prop_filter("a quaternion", |(_, q)| q.iter().map(|c| c * c).sum::<f64>() > 0.05)
        .prop_map(|(p, q)| [p[0], p[1], p[2], q[0], q[1], q[2], q[3]])
}

fn unit(pose: &[f64; 7]) -> (Vector3<f64>, UnitQuaternion<f64>) {
    let quaternion = Quaternion::new(pose[3], pose[4], pose[5], pose[6]);
    (Vector3::new(pose[0], pose[1], pose[2]), UnitQuaternion::new_normalize(quaternion))
}

fn raw(position: Vector3<f64>, turn: UnitQuaternion<f64>) -> [f64; 7] {
    [position.x, position.y, position.z, turn.w, turn.i, turn.j, turn.k]
}

const IDENTITY: [f64; 7] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.min(200)))]

    #[test]
    fn smoothing_only_adds_and_adds_little(a in solid(), b in solid(), pose in pose(), exponent in 2.0..6.0f64) {
        let pair = Pair::new(a, b);
        let tau = 10f64.powf(-exponent);
        let exact = pair.exact_distance(&pose);
        let smoothed = pair.distance(&pose, tau).unwrap().smoothed_distance;
        let tighter = pair.distance(&pose, 0.5 * tau).unwrap().smoothed_distance;
        // The duality gap on the central path is n_g tau.
        prop_assert!(smoothed >= tighter - 1e-10);
        prop_assert!(smoothed - exact >= -1e-10, "{smoothed} {exact}");
        prop_assert!(smoothed - exact <= pair.row_count() as f64 * tau + 1e-10);
    }

    #[test]
    fn exact_distances_are_the_same_one_by_one_and_together(a in solid(), b in solid(), poses in prop::collection::vec(pose(), 0..20)) {
        let pair = Pair::new(a, b);
        let together = pair.exact_distances(&poses);
        prop_assert_eq!(together.len(), poses.len());
        for (pose, distance) in poses.iter().zip(together) {
            prop_assert!((pair.exact_distance(pose) - distance).abs() < 1e-10);
        }
    }

    #[test]
    fn smoothed_distances_are_the_same_one_by_one_and_together(
        (a, b) in (solid(), solid()),
        poses in prop::collection::vec(pose(), 0..20),
        tau in 1e-5..1e-2_f64,
    ) {
        let pair = Pair::new(a, b);
        let alone = |pose: &[f64; 7]| pair.distance(pose, tau).unwrap().smoothed_distance;
        let all: Vec<f64> = poses.iter().map(alone).collect();
        prop_assert_eq!(pair.smoothed_distances(&poses, tau), all);
    }

    #[test]
    fn a_pair_has_the_distance_of_the_swapped_pair(a in solid(), b in solid(), pose in pose()) {
        let (position, turn) = unit(&pose);
        let back = raw(-(turn.inverse() * position), turn.inverse());
        let (pair, swapped) = (Pair::new(a.clone(), b.clone()), Pair::new(b, a));
        for tau in [2.5e-3, 1e-4] {
            let (one, other) = (pair.distance(&pose, tau).unwrap(), swapped.distance(&back, tau).unwrap());
            prop_assert!((one.smoothed_distance - other.smoothed_distance).abs() < 1e-9);
        }
        prop_assert!((pair.exact_distance(&pose) - swapped.exact_distance(&back)).abs() < 1e-10);
    }

    #[test]
    fn moving_both_parts_changes_nothing(a in solid(), b in solid(), pose in pose(), motion in pose()) {
        let (position, turn) = unit(&pose);
        let (shift, rotation) = unit(&motion);
        let quaternion = [rotation.w, rotation.i, rotation.j, rotation.k];
        let moved = Pair::new(a.clone(), b.placed(shift.into(), quaternion));
        let moved_pose = raw(rotation * position + shift, rotation * turn);
        let pair = Pair::new(a, b);
        let distance = |pair: &Pair, pose: &[f64; 7]| pair.distance(pose, 1e-4).unwrap().smoothed_distance;
        prop_assert!((distance(&pair, &pose) - distance(&moved, &moved_pose)).abs() < 1e-9);
    }

    #[test]
    fn derivatives_agree_with_differences(
        a in solid(),
        b in solid(),
        pose in pose(),
        seed in prop::array::uniform10(-1.0..1.0f64),
    ) {
        let (pair, tau, step) = (Pair::new(a, b), 2.5e-3, 1e-5);
        let (mut values, mut jacobians, mut hessians) = ([[0.0; 10]], [[[0.0; 7]; 10]], [[[0.0; 7]; 7]]);
        let mut solutions = Solutions::default();
        pair.contact_jacobians(&[pose], tau, &mut solutions, &mut values, &mut jacobians).unwrap();
        pair.contact_hessians(&[pose], tau, &[seed], &mut solutions, &mut hessians).unwrap();
        let at = |column: usize, step: f64| {
            let mut moved = pose;
            moved[column] += step;
            let (mut values, mut jacobians) = ([[0.0; 10]], [[[0.0; 7]; 10]]);
            pair.contact_jacobians(&[moved], tau, &mut Solutions::default(), &mut values, &mut jacobians).unwrap();
            let gradient: [f64; 7] = std::array::from_fn(|c| (0..10).map(|r| seed[r] * jacobians[0][r][c]).sum());
            (values[0], gradient)
        };
        let scale = |matrix: &[[f64; 7]]| matrix.as_flattened().iter().fold(1.0f64, |s, v| s.max(v.abs()));
        let (first, second) = (scale(&jacobians[0]), scale(&hessians[0]));
        for column in 0..7 {
            let (ahead, behind) = (at(column, step), at(column, -step));
            for row in 0..10 {
                let difference = (ahead.0[row] - behind.0[row]) / (2.0 * step);
                let analytic = jacobians[0][row][column];
                prop_assert!((analytic - difference).abs() < 1e-4 * first, "DW ({row}, {column}): {analytic} {difference}");
            }
            for row in 0..7 {
                let difference = (ahead.1[row] - behind.1[row]) / (2.0 * step);
                let analytic = hessians[0][row][column];
                prop_assert!((analytic - difference).abs() < 1e-4 * second, "D2W ({row}, {column}): {analytic} {difference}");
            }
        }
    }

    #[test]
    fn contact_points_change_no_bit_of_the_rest(a in solid(), b in solid(), pose in pose(), seed in prop::array::uniform7(-1.0..1.0f64)) {
        let (pair, tau, mut solutions) = (Pair::new(a, b), 1e-4, Solutions::default());
        let (mut values, mut jacobians, mut hessians) = ([[0.0; 7]], [[[0.0; 7]; 7]], [[[0.0; 7]; 7]]);
        pair.contact_jacobians(&[pose], tau, &mut solutions, &mut values, &mut jacobians).unwrap();
        pair.contact_hessians(&[pose], tau, &[seed], &mut solutions, &mut hessians).unwrap();
        let (mut more_values, mut more_jacobians, mut same_hessians) = ([[0.0; 10]], [[[0.0; 7]; 10]], [[[0.0; 7]; 7]]);
        let more_seed: [f64; 10] = std::array::from_fn(|component| seed.get(component).copied().unwrap_or(0.0));
        pair.contact_jacobians(&[pose], tau, &mut solutions, &mut more_values, &mut more_jacobians).unwrap();
        pair.contact_hessians(&[pose], tau, &[more_seed], &mut solutions, &mut same_hessians).unwrap();
        prop_assert_eq!(&more_values[0][..7], &values[0]);
        prop_assert_eq!(&more_jacobians[0][..7], &jacobians[0]);
        prop_assert_eq!(same_hessians, hessians);
    }

    /// The growth that the smoothed distance stands for is enough for both parts to contain the point.
    #[test]
    fn grown_parts_contain_the_contact_point(a in solid(), b in solid(), pose in pose(), exponent in 2.0..8.0f64) {
        let pair = Pair::new(a, b);
        let mut values = [[0.0; 10]];
        pair.contacts(&[pose], 10f64.powf(-exponent), &mut Solutions::default(), &mut values).unwrap();
        let (growth, point) = (0.5 * values[0][0], Vector3::from_column_slice(&values[0][7..]));
        let (position, turn) = unit(&pose);
        for (part, local) in [(pair.body(), turn.inverse() * (point - position)), (pair.environment(), point)] {
            for (normal, offset) in part.normals().iter().zip(part.offsets()) {
                prop_assert!(Vector3::from(*normal).dot(&local) < offset + growth);
            }
        }
    }

    #[test]
    fn instruction_sets_and_batches_give_the_same_bits(
        a in solid(),
        b in solid(),
        poses in prop::collection::vec(pose(), 1..20),
    ) {
        let pair = Pair::new(a, b);
        let seeds = vec![[0.3, -0.7, 1.0, 0.2, -0.5, 0.9, 0.1]; poses.len()];
        let run = |instructions: Instructions, poses: &[[f64; 7]]| {
            let zeros = vec![[[0.0; 7]; 7]; poses.len()];
            let (mut values, mut jacobians, mut hessians) = (vec![[0.0; 7]; poses.len()], zeros.clone(), zeros);
            let evaluate = |request: Request| {
                pair.evaluate(instructions, poses, 1e-4, &mut Solutions::default(), request).unwrap();
            };
            evaluate(Request::Jacobians(&mut values, &mut jacobians));
            evaluate(Request::Hessians(&seeds[..poses.len()], &mut hessians));
            (values, jacobians, hessians)
        };
        let best = run(Instructions::best(), &poses);
        for instructions in Instructions::available() {
            prop_assert_eq!(&best, &run(instructions, &poses), "{:?}", instructions);
        }
        let alone = run(Instructions::best(), &poses[..1]);
        prop_assert_eq!(&best.0[..1], &alone.0[..]);
        let mut only_values = vec![[0.0; 7]; poses.len()];
        pair.contacts(&poses, 1e-4, &mut Solutions::default(), &mut only_values).unwrap();
        for (one, other) in only_values.iter().flatten().zip(best.0.iter().flatten()) {
            prop_assert!((one - other).abs() < 1e-9);
        }
    }
}

#[test]
fn distances_at_an_invalid_pose_are_nan_there_alone() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap());
    let apart = [0.0, 0.0, 0.3, 1.0, 0.0, 0.0, 0.0];
    let poses = [apart, [f64::NAN; 7], apart];
    for (distances, accuracy) in [(pair.exact_distances(&poses), 1e-10), (pair.smoothed_distances(&poses, 1e-6), 1e-4)]
    {
        assert!((distances[0] - 0.2).abs() < accuracy && distances[2] == distances[0], "{distances:?}");
        assert!(distances[1].is_nan());
    }
}

/// Requests at two lists of poses and two smoothings in turn, each pose with its own seed.
#[test]
fn kept_solutions_change_no_bit() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.2, 0.1, 0.05]).unwrap());
    let pose = |index: usize| [0.01 * index as f64, 0.02, 0.09, 1.0, 0.1, -0.02 * index as f64, 0.0];
    let lists: [Vec<[f64; 7]>; 2] = [(0..11).map(pose).collect(), (5..16).map(pose).collect()];
    let seeds: [[f64; 7]; 11] = std::array::from_fn(|index| [0.3, -0.7, 1.0, 0.2, -0.5, 0.9, index as f64]);
    let mut kept = Solutions::default();
    for (poses, tau) in [(&lists[0], 1e-3), (&lists[1], 1e-3), (&lists[1], 1e-4), (&lists[0], 1e-4)] {
        let evaluate = |solutions: [&mut Solutions; 3]| {
            let zeros = vec![[[0.0; 7]; 7]; 11];
            let (mut values, mut jacobians, mut hessians) = (vec![[0.0; 7]; 11], zeros.clone(), zeros);
            let [one, two, three] = solutions;
            pair.contacts(poses, tau, one, &mut values).unwrap();
            let first = values.clone();
            pair.contact_jacobians(poses, tau, two, &mut values, &mut jacobians).unwrap();
            pair.contact_hessians(poses, tau, &seeds, three, &mut hessians).unwrap();
            (first, values, jacobians, hessians)
        };
        let mut fresh: [Solutions; 3] = Default::default();
        let expected = evaluate(fresh.each_mut());
        let mut values = vec![[0.0; 7]; 11];
        pair.contacts(poses, tau, &mut kept, &mut values).unwrap();
        assert_eq!(values, expected.0);
        let mut copies = [kept.clone(), kept.clone(), kept.clone()];
        assert_eq!(evaluate(copies.each_mut()), expected);
        let request = Request::Values(&mut values);
        assert_eq!(pair.evaluate(Instructions::best(), poses, tau, &mut kept, request), Ok(0), "solved again");
    }
}

#[test]
fn parallel_faces_converge() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap());
    for gap in [1e-9, 1e-3, 0.0, -1e-3, -0.05] {
        let pose = [0.0, 0.0, 0.1 + gap, 1.0, 0.0, 0.0, 0.0];
        for tau in [2.5e-3, 1e-5, 1e-8] {
            pair.distance(&pose, tau).unwrap();
        }
        assert!((pair.exact_distance(&pose) - gap).abs() < 1e-10);
    }
}

#[test]
fn coincident_parts_converge() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap());
    for tau in [1e-2, 1e-4, 1e-8] {
        pair.distance(&IDENTITY, tau).unwrap();
    }
    assert!((pair.exact_distance(&IDENTITY) + 0.1).abs() < 1e-10);
}

#[test]
fn a_distance_that_fails_says_where() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.1; 3]).unwrap());
    let poses = [IDENTITY, [f64::NAN, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]];
    let error = pair.contacts(&poses, 1e-3, &mut Solutions::default(), &mut [[0.0; 7]; 2]).unwrap_err();
    assert_eq!((error.index, error.tau), (1, 1e-3));
}

/// The point with the largest product of distances to the side faces of both parts.
#[test]
fn faces_touch_at_the_analytic_centre_of_the_patch() {
    let pair = Pair::new(Polytope::from_box([0.1; 3]).unwrap(), Polytope::from_box([0.2; 3]).unwrap());
    let pose = [0.07, -0.06, 0.15, 1.0, 0.0, 0.0, 0.0];
    let mut values = [[0.0; 10]];
    pair.contacts(&[pose], 1e-8, &mut Solutions::default(), &mut values).unwrap();
    let point = &values[0][7..];
    assert!((point[2] - 0.1).abs() < 1e-6, "{point:?}");
    for axis in 0..2 {
        let faces = [pose[axis] - 0.05, pose[axis] + 0.05, -0.1, 0.1];
        let slope: f64 = faces.iter().map(|face| 1.0 / (point[axis] - face)).sum();
        assert!(slope.abs() < 1e-2, "{point:?}: slope {slope}");
    }
}

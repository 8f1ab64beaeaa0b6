//! Joint positions along motions of the part, and what is said of motions that an arm cannot follow.

use std::path::Path;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use robot::{Arm, FollowReason, InverseError, JointVector};

fn arm(name: &str) -> Arm {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms").join(name).with_extension("urdf");
    Arm::read(&path, "tip").unwrap()
}

fn ready(arm: &Arm) -> JointVector {
    arm.configuration(&[0.2, -1.3, 1.7, -2.0, -1.5, 0.3]).unwrap()
}

/// The pose at a configuration, moved by 10 cm and turned by 0.4 rad within a time (s).
fn motion(arm: &Arm, from: &JointVector, time: f64) -> Vec<(f64, Isometry3<f64>)> {
    let start = arm.pose(from);
    let moved = |step: u32| {
        let share = f64::from(step) / 50.0;
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.1, 0.2, -0.3) * share);
        let shift = Translation3::from(Vector3::new(0.05, 0.08, -0.03) * share);
        (share * time, Isometry3::from_parts(shift * start.translation, start.rotation * turn))
    };
    (0..=50).map(moved).collect()
}

#[test]
fn an_arm_follows_a_motion_on_one_branch() {
    let arm = arm("six");
    let from = ready(&arm);
    let motion = motion(&arm, &from, 2.0);
    let path = arm.follow(&motion, &from).unwrap();
    assert_eq!(path.configurations.len(), motion.len());
    for ((_, pose), configuration) in motion.iter().zip(&path.configurations) {
        let reached = arm.pose(configuration);
        assert!((reached.translation.vector - pose.translation.vector).norm() < 1e-9);
        assert!(reached.rotation.angle_to(&pose.rotation) < 1e-9);
    }
    let changes: Vec<JointVector> = path.configurations.windows(2).map(|pair| (pair[1] - pair[0]) / 0.04).collect();
    let speed = path.speed.unwrap();
    let fastest = changes.iter().map(JointVector::amax).fold(0.0, f64::max);
    assert!((speed.value - fastest).abs() < 1e-9 && fastest < 1.0, "{speed:?} {fastest}");
    let distances = path.configurations.iter().flat_map(|configuration| {
        arm.joints().iter().zip(configuration.iter()).map(|(joint, position)| joint.limit_distance(*position))
    });
    assert_eq!(path.limit_distance.unwrap().value, distances.fold(f64::INFINITY, f64::min));
    assert_eq!(arm.joints()[path.limit_distance.unwrap().joint].name, "elbow");
    let values = path.configurations.iter().map(|configuration| arm.at(configuration).smallest_singular_value());
    assert_eq!(path.singular_value.unwrap().0, values.fold(f64::INFINITY, f64::min));
}

#[test]
fn followed_back_a_motion_has_the_same_path() {
    let arm = arm("six");
    let from = ready(&arm);
    let mut motion = motion(&arm, &from, 2.0);
    let forth = arm.follow(&motion, &from).unwrap();
    let back = arm.follow_back(&motion, forth.configurations.last().unwrap()).unwrap();
    assert_eq!(back.configurations.len(), motion.len());
    for (one, other) in forth.configurations.iter().zip(&back.configurations) {
        assert!((one - other).amax() < 1e-9);
    }
    let (distance, expected) = (back.limit_distance.unwrap(), forth.limit_distance.unwrap());
    assert!((distance.time - expected.time).abs() < 1e-9 && distance.joint == expected.joint);
    assert!((back.singular_value.unwrap().1 - forth.singular_value.unwrap().1).abs() < 1e-9);
    // Of the same pair of poses, it names the earlier.
    let (speed, expected) = (back.speed.unwrap(), forth.speed.unwrap());
    assert!((speed.time - (expected.time - 0.04)).abs() < 1e-9 && speed.joint == expected.joint);
    motion[30].1.translation.vector *= 10.0;
    let error = arm.follow_back(&motion, &from).unwrap_err();
    assert!((error.time - 1.2).abs() < 1e-9, "{error}");
}

#[test]
fn a_motion_without_poses_is_an_empty_path() {
    let arm = arm("six");
    for path in [arm.follow(&[], &ready(&arm)), arm.follow_back(&[], &ready(&arm))] {
        let path = path.unwrap();
        assert!(path.configurations.is_empty() && path.speed.is_none() && path.singular_value.is_none());
    }
}

#[test]
fn a_motion_that_is_too_fast_is_refused() {
    let arm = arm("six");
    let from = ready(&arm);
    let error = arm.follow(&motion(&arm, &from, 0.01), &from).unwrap_err();
    assert_eq!(error.time, 0.0002);
    assert!(matches!(&error.reason, FollowReason::Speed { limit: 3.1, speed, .. } if *speed > 3.1), "{error}");
    let message = error.to_string();
    assert!(message.starts_with("at 0.0002 s: joint `"), "{message}");
    assert!(message.ends_with(" rad/s, and its limit is 3.100 rad/s; give the motion more time"), "{message}");
}

#[test]
fn a_motion_out_of_reach_is_refused_at_its_time() {
    let arm = arm("six");
    let from = ready(&arm);
    let mut motion = motion(&arm, &from, 2.0);
    motion[30].1.translation.vector *= 10.0;
    let error = arm.follow(&motion, &from).unwrap_err();
    assert_eq!(error.time, 1.2);
    let FollowReason::Pose(InverseError::NotReached { distance, .. }) = &error.reason else { panic!("{error}") };
    assert!(*distance > 1.0, "{error}");
    assert!(error.to_string().starts_with("at 1.2 s: the arm does not reach the pose: it stays "), "{error}");
}

#[test]
fn a_pose_beyond_a_limit_is_refused() {
    let arm = arm("gantry");
    let from = arm.configuration(&[0.5, 0.1, 0.2, 0.3, 0.4, 0.1]).unwrap();
    let mut beyond = from;
    beyond[0] = 0.65;
    let error = arm.inverse_kinematics(&arm.pose(&beyond), &from).unwrap_err();
    let message = error.to_string();
    let beginning = "the arm reaches the pose only beyond a limit: joint `x` cannot be at 0.6";
    assert!(message.starts_with(beginning), "{message}");
    assert!(
        message.ends_with(" m: its range is -0.6 to 0.6 m; move the base or choose another configuration"),
        "{message}"
    );
}

#[test]
fn times_that_do_not_increase_are_refused() {
    let arm = arm("six");
    let from = ready(&arm);
    let mut motion = motion(&arm, &from, 2.0);
    motion[3].0 = motion[2].0;
    let error = arm.follow(&motion, &from).unwrap_err();
    assert_eq!(error.to_string(), "at 0.08 s: the time of a pose must be after that of the pose before");
}

//! The reference at the rate of a robot.

use export::{Frames, SmoothReference, resample, trajectory_csv};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use simulation::Reference;
use store::{StateRow, read_csv, write_file};
use task::{Pose, State};

/// A robot whose tool is the part and whose base is the world.
fn here() -> Frames {
    Frames { base: Isometry3::identity(), grasp: Isometry3::identity() }
}

/// Two to ten knots.
fn reference() -> impl Strategy<Value = Reference> {
    let knot = prop::array::uniform13(-1.0..1.0).prop_map(State).prop_filter("a quaternion is not zero", |knot| {
        knot[3..7].iter().map(|component| component * component).sum::<f64>() > 0.01
    });
    (prop::collection::vec(knot, 2..10), 0.01..0.2).prop_map(|(knots, time_step)| Reference::new(time_step, &knots))
}

fn read(reference: &Reference, rate: f64) -> Vec<StateRow> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("trajectory.csv");
    let states = resample(&SmoothReference::new(reference), &here(), rate).unwrap();
    write_file(&file, &trajectory_csv(&states, rate).unwrap()).unwrap();
    read_csv(&file).unwrap()
}

/// Knots as plans have them: close to each other.
fn planned() -> impl Strategy<Value = Reference> {
    let step = prop::array::uniform6(-0.02..0.02_f64);
    (prop::collection::vec(step, 2..8), 0.02..0.2).prop_map(|(steps, time_step)| {
        let mut pose = Isometry3::identity();
        let mut states = vec![Pose::IDENTITY.at_rest()];
        for [x, y, z, a, b, c] in steps {
            pose.translation.vector += Vector3::new(x, y, z);
            pose.rotation *= UnitQuaternion::from_scaled_axis(Vector3::new(a, b, c));
            states.push(Pose::from(&pose).at_rest());
        }
        Reference::new(time_step, &states)
    })
}

proptest! {
    /// Every sample has a unit quaternion near to that of the sample before, and comes `1 / rate` after it.
    #[test]
    fn samples_are_even(reference in reference(), rate in 50.0_f64..1000.0) {
        let rows = read(&reference, rate);
        let duration = reference.intervals() as f64 * reference.time_step();
        let end = rows.last().unwrap().time();
        prop_assert!(end >= duration - 1e-6 && end < duration + 1.0 / rate + 1e-6);
        for (index, row) in rows.iter().enumerate() {
            prop_assert!((row.time() - index as f64 / rate).abs() < 1e-8);
            let norm = row.state()[3..7].iter().map(|component| component * component).sum::<f64>().sqrt();
            prop_assert!((norm - 1.0).abs() < 1e-12);
        }
        for pair in rows.windows(2) {
            let [one, other] = [pair[0].state(), pair[1].state()];
            prop_assert!((3..7).map(|index| one[index] * other[index]).sum::<f64>() > 0.0);
        }
    }

    /// Velocities are the derivatives of poses, everywhere, so they are continuous; no position leaves the box of its knots.
    #[test]
    fn velocities_are_derivatives(reference in planned(), share in 0.0..1.0_f64) {
        const STEP: f64 = 1e-5;
        let smooth = SmoothReference::new(&reference);
        let knots = share * reference.intervals() as f64;
        let at = |shift: f64| smooth.at((knots + shift).clamp(0.0, reference.intervals() as f64));
        let (before, now, after) = (at(-STEP), at(0.0), at(STEP));
        let time = 2.0 * STEP * reference.time_step();
        if knots > STEP && knots < reference.intervals() as f64 - STEP {
            let velocity = (after.pose.translation.vector - before.pose.translation.vector) / time;
            let spin = (before.pose.rotation.inverse() * after.pose.rotation).scaled_axis() / time;
            // A second derivative may step at a knot.
            let bend = 50.0 * STEP * 0.02 / reference.time_step();
            prop_assert!((velocity - now.velocity).norm() < bend + 1e-6, "{velocity} {}", now.velocity);
            prop_assert!((spin - now.angular_velocity).norm() < bend + 1e-6, "{spin} {}", now.angular_velocity);
        }
        let [from, to] = [0, 1].map(|next| reference.at((knots as usize + next).min(reference.intervals()), 0.0).pose);
        for axis in 0..3 {
            let ends = [from.translation.vector[axis], to.translation.vector[axis]];
            let (low, high) = (ends[0].min(ends[1]) - 1e-12, ends[0].max(ends[1]) + 1e-12);
            prop_assert!((low..=high).contains(&now.pose.translation.vector[axis]));
        }
    }
}

/// A sample at a knot is the knot, the reference begins and ends at rest, and on the way at constant speed it keeps it.
#[test]
fn samples_at_knots_are_the_knots() {
    let states: Vec<State> = (0..4)
        .map(|step| {
            let angle = 0.3 * f64::from(step);
            let (x, qw, qx) = (0.01 * f64::from(step), (angle / 2.0).cos(), (angle / 2.0).sin());
            State([x, 0.0, 0.2, qw, qx, 0.0, 0.0, 0.25, 0.0, 0.0, 7.5, 0.0, 0.0])
        })
        .collect();
    let rows = read(&Reference::new(0.04, &states), 500.0);
    assert_eq!(rows.len(), 61);
    for (knot, state) in states.iter().enumerate() {
        let row = rows[20 * knot].state();
        for index in 0..7 {
            assert!((row[index] - state[index]).abs() < 1e-9, "knot {knot}: {row:?}");
        }
    }
    let halfway = rows[30].state();
    assert!((halfway[0] - 0.015).abs() < 1e-9 && (halfway[7] - 0.25).abs() < 1e-9, "{halfway:?}");
    assert!((halfway[10] - 7.5).abs() < 1e-9, "{halfway:?}");
    assert_eq!(rows[0].state()[7..], [0.0; 6]);
    assert_eq!(rows[60].state()[7..], [0.0; 6]);
}

/// Nobody waits for a trajectory that is longer than an hour at 1 kHz.
#[test]
fn too_many_samples_are_refused() {
    let still = Pose::IDENTITY.at_rest();
    let error =
        resample(&SmoothReference::new(&Reference::new(1e4, &[still, still])), &here(), 1e3).unwrap_err().to_string();
    assert!(error.contains("choose a lower rate"), "{error}");
}

//! The reference at the rate of a robot.

use export::{Frames, resample, trajectory_csv};
use nalgebra::{Isometry3, Vector3};
use planner::files::{StateRow, read_csv, write_file};
use proptest::prelude::*;
use simulation::Reference;

/// A robot whose tool is the part and whose base is the world.
fn here() -> Frames {
    Frames { base: Isometry3::identity(), grasp: Isometry3::identity() }
}

/// Two to ten knots.
fn reference() -> impl Strategy<Value = Reference> {
    let knot = prop::array::uniform13(-1.0..1.0).prop_filter("a quaternion is not zero", |knot: &[f64; 13]| {
        knot[3..7].iter().map(|component| component * component).sum::<f64>() > 0.01
    });
    (prop::collection::vec(knot, 2..10), 0.01..0.2).prop_map(|(knots, time_step)| Reference::new(time_step, &knots))
}

fn read(reference: &Reference, rate: f64) -> Vec<StateRow> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("trajectory.csv");
    write_file(&file, &trajectory_csv(&resample(reference, &here(), rate).unwrap(), rate).unwrap()).unwrap();
    read_csv(&file).unwrap()
}

proptest! {
    /// Every sample is on the straight way between its knots, has a unit quaternion near to that of the sample before, and
    /// comes `1 / rate` after it.
    #[test]
    fn samples_are_on_the_way(reference in reference(), rate in 50.0_f64..1000.0) {
        let rows = read(&reference, rate);
        let duration = reference.intervals() as f64 * reference.time_step();
        let end = rows.last().unwrap().time();
        prop_assert!(end >= duration - 1e-6 && end < duration + 1.0 / rate + 1e-6);
        for (index, row) in rows.iter().enumerate() {
            prop_assert!((row.time() - index as f64 / rate).abs() < 1e-8);
            let state = row.state();
            let norm = state[3..7].iter().map(|component| component * component).sum::<f64>().sqrt();
            prop_assert!((norm - 1.0).abs() < 1e-12);
            let knots = (row.time() / reference.time_step()).min(reference.intervals() as f64 - 1e-9);
            let expected = reference.at(knots as usize, knots.fract()).pose;
            let position = Vector3::from_column_slice(&state[..3]);
            prop_assert!((position - expected.translation.vector).norm() < 1e-4);
        }
        for pair in rows.windows(2) {
            let [one, other] = [pair[0].state(), pair[1].state()];
            prop_assert!((3..7).map(|index| one[index] * other[index]).sum::<f64>() > 0.0);
        }
    }
}

/// A sample at a knot is the knot, and at the end the reference rests.
#[test]
fn samples_at_knots_are_the_knots() {
    let states: Vec<[f64; 13]> = (0..4)
        .map(|step| {
            let angle = 0.3 * f64::from(step);
            let (x, qw, qx) = (0.01 * f64::from(step), (angle / 2.0).cos(), (angle / 2.0).sin());
            [x, 0.0, 0.2, qw, qx, 0.0, 0.0, 0.25, 0.0, 0.0, 7.5, 0.0, 0.0]
        })
        .collect();
    let rows = read(&Reference::new(0.04, &states), 500.0);
    assert_eq!(rows.len(), 61);
    for (knot, state) in states.iter().enumerate() {
        let row = rows[20 * knot].state();
        for index in 0..7 {
            // Rounding moves samples by a millionth of the time between two.
            assert!((row[index] - state[index]).abs() < 1e-7, "knot {knot}: {row:?}");
        }
    }
    let halfway = rows[10].state();
    assert!((halfway[0] - 0.005).abs() < 1e-7 && (halfway[3] - 0.075_f64.cos()).abs() < 1e-7, "{halfway:?}");
    assert_eq!(halfway[7..], states[1][7..]);
    assert_eq!(rows[60].state()[7..], [0.0; 6]);
}

/// Nobody waits for a trajectory that is longer than an hour at 1 kHz.
#[test]
fn too_many_samples_are_refused() {
    let still = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let error = resample(&Reference::new(1e4, &[still, still]), &here(), 1e3).unwrap_err().to_string();
    assert!(error.contains("choose a lower rate"), "{error}");
}

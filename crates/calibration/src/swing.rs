//! Robots that oscillate by themselves, as with too much latency for their gains.

use nalgebra::Isometry3;

use crate::deviation::{COMPONENTS, deviation};

/// A robot oscillates if it leaves its reference faster than this factor times the reference's recent speed. A joint
/// that slips after sticking is slower.
const TIMES: f64 = 3.0;
/// Number of recent poses: a tracking error has decayed after that many.
const LATELY: usize = 100;
/// Smallest speed of a reference that counts, as a fraction of its largest one: it may rest.
const SLOWEST: f64 = 0.1;

/// Index of the first pose of a robot from whose recent past an oscillation follows: oscillations grow from unknown
/// causes. The poses of robot and reference are at the same times, about every 10 ms.
pub fn end_before_swing(believed: &[Isometry3<f64>], reference: &[Isometry3<f64>]) -> Option<usize> {
    let followed: Vec<[f64; 2]> = reference.windows(2).map(|pair| sizes(&deviation(&pair[1], &pair[0]))).collect();
    let fastest = followed.iter().fold([0.0_f64; 2], |fastest, way| [fastest[0].max(way[0]), fastest[1].max(way[1])]);
    // Translations and rotations relative to their largest speeds: joints couple them.
    let speed = |way: &[f64; 2]| {
        (0..2).filter(|&part| fastest[part] > 0.0).map(|part| way[part] / fastest[part]).fold(0.0, f64::max)
    };
    let tracking_errors: Vec<[f64; COMPONENTS]> =
        believed.iter().zip(reference).map(|(pose, from)| deviation(pose, from)).collect();
    let is_swinging = |&index: &usize| {
        let left = sizes(&std::array::from_fn(|row| tracking_errors[index][row] - tracking_errors[index - 1][row]));
        let lately = followed[index.saturating_sub(LATELY)..index].iter().map(speed).fold(SLOWEST, f64::max);
        speed(&left) > TIMES * lately
    };
    (1..tracking_errors.len()).find(is_swinging).map(|index| index.saturating_sub(LATELY))
}

/// Length (m) and angle (rad).
fn sizes(deviation: &[f64; COMPONENTS]) -> [f64; 2] {
    let size = |part: &[f64]| part.iter().map(|number| number * number).sum::<f64>().sqrt();
    [size(&deviation[..3]), size(&deviation[3..])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_that_lags_or_sticks_does_not_swing_and_one_that_shakes_does() {
        let at = |x: f64| Isometry3::translation(x, 0.0, 0.0);
        let reference: Vec<_> = (0..100).map(|step| at(1e-4 * f64::from(step))).collect();
        let stuck: Vec<_> = (0..100).map(|step| at(1e-3 * f64::from(step / 10))).collect();
        assert_eq!(end_before_swing(&reference[..90], &reference[10..]), None);
        assert_eq!(
            end_before_swing(&stuck.iter().map(|pose| at(0.2 * pose.translation.x)).collect::<Vec<_>>(), &reference),
            None
        );
        let mut shaken = reference.clone();
        shaken[60] = at(0.0);
        assert_eq!(end_before_swing(&shaken, &reference), Some(0));
    }
}

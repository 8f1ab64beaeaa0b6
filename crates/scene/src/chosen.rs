//! Defaults that depend on the scene.

use std::f64::consts::TAU;

use admittance::PositionRobot;
use nalgebra::Vector3;
use task::algebra::norm;
use task::{Coverage, Horizon, Limits, Pose};

use crate::error::SceneError;
use crate::keys::key;
use crate::scene::Scene;
use crate::table::Table;

/// Acceleration (m/s^2) of a body that is off by the offset magnitude.
const PULL: f64 = 1.0;
/// Softest and stiffest controllers per kilogram of the body (N/m kg).
const SOFTEST: f64 = 50.0;
const STIFFEST: f64 = 1000.0;
/// Length of a step (s).
const TIME_STEP: f64 = 0.04;
/// Most steps that are chosen, and with the much damping of an admittance law, which answers slowly.
const MOST_STEPS: f64 = 1000.0;
const SLOW_STEPS: f64 = 100.0;
/// Shortest plan (s), and in time constants of the controlled body.
const SHORTEST: f64 = 3.0;
const TIME_CONSTANTS: f64 = 28.0;
/// Mean speed (m/s) beyond [`NEAR`] (m) from the goal.
const SPEED: f64 = 0.1;
const NEAR: f64 = 0.1;
/// Contact force (N) that shifts a part against an admittance law.
const GENTLE_FORCE: f64 = 15.0;
/// Planned directions of a disc.
const DIRECTIONS: usize = 6;

/// Stiffness (N/m) with which a body that is off by the offset magnitude (m) is pulled back by 1 m/s^2, within usual
/// limits.
pub fn translational_stiffness(offset_magnitude: f64, mass: f64) -> f64 {
    let bounds = key("impedance", "translational_stiffness").bounds();
    (mass * (PULL / offset_magnitude).clamp(SOFTEST, STIFFEST)).clamp(bounds.low, bounds.high)
}

/// Rotational stiffness (Nm/rad) beside a translational one (N/m) for a mass (kg). The published experiments have 5 Nm/rad
/// beside 50 N/m for 1 kg.
pub fn rotational_stiffness(translational: f64, mass: f64) -> f64 {
    let bounds = key("impedance", "rotational_stiffness").bounds();
    (mass * (0.5 * translational / mass).sqrt()).clamp(bounds.low, bounds.high)
}

/// A duration (s) in which the controlled body settles and covers the longest path from its starts to the goal.
pub fn duration<'start>(starts: impl Iterator<Item = &'start Pose>, goal: &Pose, time_constant: f64) -> f64 {
    let length = |start: &Pose| norm(&[0, 1, 2].map(|axis| start[axis] - goal[axis]));
    let path = starts.map(length).fold(0.0, f64::max);
    let far = (path - NEAR).max(0.0) / SPEED;
    SHORTEST.max(TIME_CONSTANTS * time_constant) + far
}

/// Time (s) in which contacts that push with a gentle force shift the part by twice the largest offset (m) against the damping
/// of an admittance law.
pub fn sliding_time(robot: &PositionRobot, offset_magnitude: f64) -> f64 {
    2.0 * offset_magnitude * robot.gains.damping[0] / GENTLE_FORCE
}

/// Length of a step (s) of a plan for an admittance law.
pub fn slow_time_step(duration: f64) -> f64 {
    TIME_STEP.max(duration / SLOW_STEPS)
}

/// A time grid of a duration (s), with the length of a step (s) or their number if these are given.
pub fn horizon(duration: f64, steps: Option<usize>, time_step: Option<f64>) -> Horizon {
    let longest = key("horizon", "time_step").bounds().high;
    let time_step = time_step.unwrap_or_else(|| match steps {
        Some(steps) => (duration / steps as f64).min(longest),
        None => TIME_STEP.max(duration / MOST_STEPS).min(longest),
    });
    let steps = steps.unwrap_or_else(|| (duration / time_step).ceil().clamp(1.0, MOST_STEPS) as usize);
    Horizon { steps, time_step }
}

/// The defaults chosen for a scene, as text of TOML.
pub fn remarks(table: &Table, scene: &Scene) -> Result<Vec<String>, SceneError> {
    let Scene { impedance, horizon, .. } = scene;
    let mut values = vec![
        ("impedance", "translational_stiffness", format!("{:.1} N/m", impedance.translational_stiffness)),
        ("impedance", "rotational_stiffness", format!("{:.2} Nm/rad", impedance.rotational_stiffness)),
        ("horizon", "steps", horizon.steps.to_string()),
        ("horizon", "time_step", format!("{:.4} s", horizon.time_step)),
    ];
    let Limits { translational_velocity, rotational_velocity, .. } = scene.limits;
    if translational_velocity.is_finite() {
        values.push(("limits", "translational_velocity", format!("{translational_velocity:.3} m/s")));
    }
    if rotational_velocity.is_finite() {
        values.push(("limits", "rotational_velocity", format!("{rotational_velocity:.3} rad/s")));
    }
    let planned = format!("{} planned offsets", scene.offset_directions.len());
    match scene.coverage {
        Coverage::Hull => {}
        Coverage::Disc { axis: [x, y, z] } => {
            values.push(("robustness", "coverage", format!("\"disc\" across ({x:.3}, {y:.3}, {z:.3}), {planned}")));
        }
        Coverage::Ball => values.push(("robustness", "coverage", format!("\"ball\", {planned}"))),
    }
    let mut remarks = Vec::new();
    for (name, key, value) in values {
        if table.table(name)?.find(key).is_none() {
            remarks.push(format!("{name}.{key} = {value}"));
        }
    }
    Ok(remarks)
}

/// The axis (body frame) along which the body is inserted: the straight line from start to goal; where they are one
/// place, the body's z axis.
pub fn insertion_axis(start: &Pose, goal: &Pose) -> [f64; 3] {
    let (start, goal) = (start.isometry(), goal.isometry());
    let way = goal.rotation.inverse() * (start.translation.vector - goal.translation.vector);
    way.try_normalize(f64::EPSILON).unwrap_or(Vector3::z()).map(rounded).into()
}

/// Directions (body frame) whose offsets are planned to cover a disc or a ball: at equal angles in the plane of the
/// disc, both directions along every axis for a ball. A hull has only those that the scene gives.
pub fn directions(coverage: &Coverage) -> Vec<[f64; 3]> {
    let span = coverage.span();
    let directions: Vec<Vector3<f64>> = match span[..] {
        [first, second] => {
            let angles = (0..DIRECTIONS).map(|index| TAU * index as f64 / DIRECTIONS as f64);
            angles.map(|angle| first * angle.cos() + second * angle.sin()).collect()
        }
        _ => span.iter().flat_map(|axis| [*axis, -axis]).collect(),
    };
    directions.into_iter().map(|direction| direction.map(rounded).into()).collect()
}

/// Drops the last digits, so that zeros stay zeros.
fn rounded(component: f64) -> f64 {
    (1e12 * component).round() / 1e12 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_peg_of_the_paper_is_chosen_as_published() {
        let stiffness = translational_stiffness(0.02, 1.0);
        assert_eq!((stiffness, rotational_stiffness(stiffness, 1.0)), (50.0, 5.0));
        let [start, goal] = [0.09, 0.0].map(|z| Pose([0.0, 0.0, z, 1.0, 0.0, 0.0, 0.0]));
        let duration = duration([&start].into_iter(), &goal, (1.0 / stiffness).sqrt());
        let horizon = horizon(duration, None, None);
        assert_eq!(horizon, Horizon { steps: 99, time_step: 0.04 });
    }

    #[test]
    fn given_steps_or_their_length_are_kept() {
        assert_eq!(horizon(4.0, Some(50), None), Horizon { steps: 50, time_step: 0.08 });
        assert_eq!(horizon(4.0, None, Some(0.5)), Horizon { steps: 8, time_step: 0.5 });
        assert_eq!(horizon(4.0, Some(3), Some(0.5)), Horizon { steps: 3, time_step: 0.5 });
    }

    #[test]
    fn directions_are_unit_vectors_across_the_insertion() {
        let goal = Pose([0.0, 0.0, 0.0, 0.6, 0.0, 0.8, 0.0]);
        for start in [[0.1, 0.2, -0.3], [0.0, 0.0, 0.1], [0.0; 3]] {
            let axis = insertion_axis(&Pose::new(start, [1.0, 0.0, 0.0, 0.0]), &goal);
            let directions = directions(&Coverage::Disc { axis });
            let directions: Vec<Vector3<f64>> = directions.into_iter().map(Vector3::from).collect();
            let way = goal.isometry().rotation.inverse() * Vector3::from(start);
            let sum: Vector3<f64> = directions.iter().sum();
            assert!(sum.norm() < 1e-9, "{directions:?}");
            for direction in directions {
                assert!((direction.norm() - 1.0).abs() < 1e-9 && direction.dot(&way).abs() < 1e-9, "{direction}");
            }
        }
    }
}

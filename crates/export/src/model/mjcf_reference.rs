//! A reference that moves by itself in MuJoCo, which has no tables of time.
//!
//! A joint `clock` moves by 1 m/s. Every interval between knots is an actuator whose force grows with the clock from zero at its
//! beginning to a limit at its end, and stays there: the sum of these is linear between knots. It moves a heavy body without
//! contacts on stiff, critically damped joints: three slides, then three hinges. That body follows with a constant delay,
//! by which all actuators begin earlier.

use std::fmt::Write;

use nalgebra::{Isometry3, UnitQuaternion};
use plan::PlannerError;
use simulation::Reference;

use crate::model::{numbers, position_and_quaternion};

/// Site at the position of the reference, with the axes of the world.
pub const POSITION: &str = "reference/position";
/// Site with the pose of the reference.
pub const POSE: &str = "reference/pose";

/// Mass (kg) and moments of inertia (kg m^2): the controller's forces must not move the reference.
const INERTIA: f64 = 1e3;
/// Frequency (1/s) of its joints; its delay is twice the inverse.
const FREQUENCY: f64 = 1e3;
/// How much less a coordinate of the reference counts than the clock in the tendon that joins both. Small, because the reference
/// must not delay its own forces.
const SHARE: f64 = 1e-3;
/// Mass (kg) and damping (Ns/m) of the clock, which the forces of the reference must not brake.
const CLOCK: [f64; 2] = [1e11, 1e17];
/// Names of the joints.
const JOINTS: [&str; 6] = ["x", "y", "z", "a", "b", "c"];
/// Largest rotation (rad) about the middle hinge: at a right angle, the others have the same axis.
const LARGEST_TILT: f64 = 1.4;

/// The parts of a model that make the reference.
pub struct MovingReference {
    /// Bodies.
    pub bodies: String,
    /// Tendons.
    pub tendons: String,
    /// Actuators.
    pub actuators: String,
}

impl MovingReference {
    /// Of a reference; `geoms` are shown at it.
    ///
    /// # Errors
    /// When it rotates too far from its start for three hinges.
    pub fn new(reference: &Reference, geoms: &str) -> Result<Self, PlannerError> {
        let coordinates = coordinates(reference)?;
        let start = reference.states()[0].pose().isometry();
        let mut tendons = String::new();
        let [_, speed] = CLOCK;
        let mut actuators = format!(
            "    <general name=\"reference/clock\" joint=\"reference/clock\" gainprm=\"0\" biastype=\"affine\" biasprm=\"{speed} 0 0\" \
             group=\"4\"/>\n"
        );
        for (axis, joint) in JOINTS.iter().enumerate() {
            let _ = writeln!(
                tendons,
                "    <fixed name=\"reference/{joint}\"><joint joint=\"reference/clock\" coef=\"1\"/>\
                 <joint joint=\"reference/{joint}\" coef=\"{SHARE}\"/></fixed>"
            );
            let knots: Vec<f64> = coordinates.iter().map(|knot| knot[axis]).collect();
            for (index, ramp) in ramps(&knots, reference.time_step()).iter().enumerate() {
                actuators += &ramp.actuator(&format!("reference/{joint}"), index);
            }
        }
        Ok(Self { bodies: bodies(&start, geoms), tendons, actuators })
    }
}

/// A change of a coordinate at constant speed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ramp {
    begin: f64,
    end: f64,
    change: f64,
}

impl Ramp {
    fn actuator(&self, tendon: &str, index: usize) -> String {
        let force = INERTIA * FREQUENCY * FREQUENCY * self.change / SHARE;
        let slope = force / (self.end - self.begin);
        let begin = self.begin - 2.0 / FREQUENCY;
        let (low, high) = (force.min(0.0), force.max(0.0));
        format!(
            "    <general name=\"{tendon}{index}\" tendon=\"{tendon}\" gainprm=\"0\" biastype=\"affine\" biasprm=\"{} {slope} 0\" \
             forcelimited=\"true\" forcerange=\"{low} {high}\" group=\"4\"/>\n",
            -slope * begin
        )
    }
}

/// The changes of a coordinate from knot to knot; equal ones in a row are one.
fn ramps(knots: &[f64], time_step: f64) -> Vec<Ramp> {
    /// Changes (m or rad) that count as none, and as equal.
    const LEAST: f64 = 1e-10;
    let mut ramps: Vec<Ramp> = Vec::new();
    let mut last = f64::INFINITY;
    for (index, pair) in knots.windows(2).enumerate() {
        let change = pair[1] - pair[0];
        let end = (index + 1) as f64 * time_step;
        match ramps.last_mut() {
            Some(ramp) if (change - last).abs() <= LEAST => (ramp.end, ramp.change) = (end, ramp.change + change),
            _ => ramps.push(Ramp { begin: index as f64 * time_step, end, change }),
        }
        last = change;
    }
    ramps.retain(|ramp| ramp.change.abs() > LEAST);
    ramps
}

/// Displacement (m, along the axes of the world) from the first knot, then the angles (rad) of hinges about x, y and z in a row.
fn coordinates(reference: &Reference) -> Result<Vec<[f64; 6]>, PlannerError> {
    let poses: Vec<Isometry3<f64>> = reference.states().iter().map(|state| state.pose().isometry()).collect();
    let mut last = [0.0; 3];
    let mut coordinates = Vec::with_capacity(poses.len());
    for pose in &poses {
        let [x, y, z]: [f64; 3] = (pose.translation.vector - poses[0].translation.vector).into();
        let rotation = poses[0].rotation.inverse() * pose.rotation;
        let angles = hinges(&rotation).filter(|[_, tilt, _]| tilt.abs() <= LARGEST_TILT).ok_or_else(|| PlannerError::Choice {
            name: "to mjcf",
            problem: format!("the reference rotates by more than {LARGEST_TILT} rad about its y axis, which three hinges in a row cannot follow"),
        })?;
        // The same angle next to the last one.
        let next = |axis: usize| {
            last[axis] + (angles[axis] - last[axis] + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
                - std::f64::consts::PI
        };
        last = [next(0), next(1), next(2)];
        coordinates.push([x, y, z, last[0], last[1], last[2]]);
    }
    Ok(coordinates)
}

/// Angles (rad) with `rotation = Rx(a) Ry(b) Rz(c)`.
fn hinges(rotation: &UnitQuaternion<f64>) -> Option<[f64; 3]> {
    let matrix = rotation.to_rotation_matrix();
    let entry = |row: usize, column: usize| matrix[(row, column)];
    let tilt = entry(0, 2).clamp(-1.0, 1.0).asin();
    let angles = [(-entry(1, 2)).atan2(entry(2, 2)), tilt, (-entry(0, 1)).atan2(entry(0, 0))];
    angles.iter().all(|angle| angle.is_finite()).then_some(angles)
}

fn bodies(start: &Isometry3<f64>, geoms: &str) -> String {
    let (position, quaternion) = position_and_quaternion(start);
    let [mass, damping] = CLOCK;
    let stiffness = INERTIA * FREQUENCY * FREQUENCY;
    let braking = 2.0 * INERTIA * FREQUENCY;
    let joint = |index: usize, kind: &str, axis: &str| {
        format!(
            "<joint name=\"reference/{}\" type=\"{kind}\" axis=\"{axis}\" stiffness=\"{stiffness}\" damping=\"{braking}\"/>",
            JOINTS[index]
        )
    };
    let axes = ["1 0 0", "0 1 0", "0 0 1"];
    let joints =
        |first: usize, kind: &str| (0..3).map(|axis| joint(first + axis, kind, axes[axis])).collect::<String>();
    format!(
        "    <body name=\"reference/clock\">\n      <inertial pos=\"0 0 0\" mass=\"{mass}\" diaginertia=\"1 1 1\"/>\n      \
         <joint name=\"reference/clock\" type=\"slide\" axis=\"1 0 0\" damping=\"{damping}\"/>\n    </body>\n    \
         <body name=\"{POSITION}\" pos=\"{}\">\n      <inertial pos=\"0 0 0\" mass=\"{INERTIA}\" diaginertia=\"1 1 1\"/>\n      {}\n      \
         <site name=\"{POSITION}\"/>\n      <body name=\"{POSE}\" quat=\"{}\">\n        <inertial pos=\"0 0 0\" mass=\"1e-3\" \
         diaginertia=\"{INERTIA} {INERTIA} {INERTIA}\"/>\n        {}\n        <site name=\"{POSE}\"/>\n{geoms}      </body>\n    </body>\n",
        numbers(position),
        joints(0, "slide"),
        numbers(quaternion),
        joints(3, "hinge"),
    )
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn hinges_in_a_row_make_the_rotation() {
        for [a, b, c] in [[0.3, -0.2, 0.5], [-2.0, 1.2, 3.0], [0.0, 0.0, 0.0]] {
            let [x, y, z] =
                [Vector3::x() * a, Vector3::y() * b, Vector3::z() * c].map(UnitQuaternion::from_scaled_axis);
            let found = hinges(&(x * y * z)).unwrap();
            assert!(found.iter().zip([a, b, c]).all(|(found, wanted)| (found - wanted).abs() < 1e-12), "{found:?}");
        }
    }

    #[test]
    fn ramps_join_the_knots() {
        let found = ramps(&[0.0, 1.0, 2.0, 2.0, 1.0], 0.5);
        assert_eq!(found, [Ramp { begin: 0.0, end: 1.0, change: 2.0 }, Ramp { begin: 1.5, end: 2.0, change: -1.0 }]);
    }
}

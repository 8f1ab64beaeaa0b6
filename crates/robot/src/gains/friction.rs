//! Wrenches and errors that joint friction can hold.

use nalgebra::{Matrix6, Vector6};

use crate::joint::{Jacobian, MOST_JOINTS};

/// The largest wrench of the controller that joint friction can hold while the arm rests.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionWrench {
    /// Largest force (N).
    pub force: f64,
    /// Largest torque (Nm).
    pub torque: f64,
}

/// The largest errors at which an arm may rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deadband {
    /// Error of the position (m).
    pub distance: f64,
    /// Error of the orientation (rad).
    pub angle: f64,
}

/// Part of the largest friction by which a joint may exceed its own: rounding.
const ROUNDING: f64 = 1e-9;

impl FrictionWrench {
    /// For a Jacobian and the largest friction torque of each joint (Nm, N for a prismatic joint; not negative), at most
    /// [`MOST_JOINTS`]. `None` where the arm is singular or has less than six joints: some wrench then moves no joint.
    ///
    /// The arm rests under every wrench of `|J' w| <= friction` (in each joint). Force and torque are convex in `w`, so
    /// they are largest at corners of this polytope, where six joints are at their limits: `w = B'^-1 (+-friction)` with
    /// the six columns `B` of `J`. An arm with six joints has 64 corners, `J'^-1` times all combinations of signs. With
    /// more joints, corners of every six that the other joints allow are tried: if the redundant motion is not controlled.
    pub fn new(jacobian: &Jacobian, friction: &[f64]) -> Option<Self> {
        let joints = friction.len().min(MOST_JOINTS);
        let allowed = ROUNDING * friction.iter().fold(0.0, |largest: f64, torque| largest.max(*torque));
        let rests = |wrench: &Vector6<f64>| {
            (0..joints).all(|joint| jacobian.column(joint).dot(wrench).abs() <= friction[joint] + allowed)
        };
        let mut largest: Option<Self> = None;
        for chosen in (0u32..1 << joints).filter(|chosen| chosen.count_ones() == 6) {
            let six: Vec<usize> = (0..joints).filter(|joint| chosen & (1 << joint) != 0).collect();
            let columns = Matrix6::from_fn(|row, column| jacobian[(row, six[column])]);
            let Some(inverse) = columns.transpose().try_inverse() else { continue };
            for signs in 0u32..64 {
                let torques =
                    Vector6::from_fn(
                        |row, _| if signs & (1 << row) == 0 { friction[six[row]] } else { -friction[six[row]] },
                    );
                let wrench = inverse * torques;
                if rests(&wrench) {
                    let known = largest.unwrap_or(Self { force: 0.0, torque: 0.0 });
                    largest = Some(Self {
                        force: known.force.max(wrench.fixed_rows::<3>(0).norm()),
                        torque: known.torque.max(wrench.fixed_rows::<3>(3).norm()),
                    });
                }
            }
        }
        largest.filter(|wrench| wrench.force.is_finite() && wrench.torque.is_finite())
    }

    /// The deadband with a translational (N/m) and a rotational stiffness (Nm/rad).
    pub fn deadband(&self, translational_stiffness: f64, rotational_stiffness: f64) -> Deadband {
        Deadband { distance: self.force / translational_stiffness, angle: self.torque / rotational_stiffness }
    }
}

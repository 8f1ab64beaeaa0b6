//! Limits of velocity, acceleration, contact force and wrench.

use crate::pose::POSE;
use crate::state::{State, TWIST, Wrench};

/// Largest absolute value of each component, infinite where there is no limit. The reference and every scenario satisfy
/// the limits at every step. As in robot controllers, limits are per axis: the speed along a diagonal may be larger by
/// a factor of up to `sqrt(3)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Velocity of the reference and of every scenario, in the world frame (m/s).
    pub translational_velocity: f64,
    /// Angular velocity of both, in the body frame (rad/s).
    pub rotational_velocity: f64,
    /// Change of the velocity per step, divided by the time step, of both (m/s^2).
    pub translational_acceleration: f64,
    /// Change of the angular velocity per step, divided by the time step, of both (rad/s^2).
    pub rotational_acceleration: f64,
    /// Normal force of every pair in every scenario (N).
    pub contact_force: f64,
    /// Force of the impedance controller in every scenario, in the world frame (N).
    pub force: f64,
    /// Torque of the impedance controller in every scenario, in the body frame (Nm).
    pub torque: f64,
}

/// Contact forces of rollouts are means over this time (s): how high an impact peaks is a matter of the time step, its
/// impulse is not.
pub const FORCE_WINDOW: f64 = 0.01;

impl Limits {
    /// No limits.
    pub const NONE: Self = Self {
        translational_velocity: f64::INFINITY,
        rotational_velocity: f64::INFINITY,
        translational_acceleration: f64::INFINITY,
        rotational_acceleration: f64::INFINITY,
        contact_force: f64::INFINITY,
        force: f64::INFINITY,
        torque: f64::INFINITY,
    };

    /// Whether the values `reached` satisfy these limits. Each limit may be exceeded by the fraction `slack` of itself.
    pub fn allow(&self, reached: &Self, slack: f64) -> bool {
        self.named().iter().zip(reached.named()).all(|((_, _, limit), (_, _, value))| value <= limit * (1.0 + slack))
    }

    /// The tightest limits that a motion satisfies, from its states at k = 0..N, the wrenches of its steps, and its
    /// largest contact force (N).
    pub fn kept_by(states: &[State], time_step: f64, wrenches: &[Wrench], contact_force: f64) -> Self {
        let velocity = |state: &State, axis: usize| state[POSE + axis];
        let velocities = states.iter().map(|state| std::array::from_fn(|axis| velocity(state, axis)));
        let accelerations = states
            .windows(2)
            .map(|pair| std::array::from_fn(|axis| (velocity(&pair[1], axis) - velocity(&pair[0], axis)) / time_step));
        let [translational_velocity, rotational_velocity] = largest(velocities);
        let [translational_acceleration, rotational_acceleration] = largest(accelerations);
        let [force, torque] = largest(wrenches.iter().map(|wrench| wrench.0));
        Self {
            translational_velocity,
            rotational_velocity,
            translational_acceleration,
            rotational_acceleration,
            contact_force,
            force,
            torque,
        }
    }

    /// Name in scene files, unit and value of every limit.
    pub fn named(&self) -> [(&'static str, &'static str, f64); 7] {
        [
            ("translational_velocity", "m/s", self.translational_velocity),
            ("rotational_velocity", "rad/s", self.rotational_velocity),
            ("translational_acceleration", "m/s^2", self.translational_acceleration),
            ("rotational_acceleration", "rad/s^2", self.rotational_acceleration),
            ("contact_force", "N", self.contact_force),
            ("force", "N", self.force),
            ("torque", "Nm", self.torque),
        ]
    }

    /// The larger value of each limit.
    pub fn max(&self, other: &Self) -> Self {
        Self {
            translational_velocity: self.translational_velocity.max(other.translational_velocity),
            rotational_velocity: self.rotational_velocity.max(other.rotational_velocity),
            translational_acceleration: self.translational_acceleration.max(other.translational_acceleration),
            rotational_acceleration: self.rotational_acceleration.max(other.rotational_acceleration),
            contact_force: self.contact_force.max(other.contact_force),
            force: self.force.max(other.force),
            torque: self.torque.max(other.torque),
        }
    }

    /// Index and limit of every velocity component that is limited.
    pub fn velocities(&self) -> Vec<(usize, f64)> {
        limited_axes(self.translational_velocity, self.rotational_velocity)
    }

    /// Index and limit of every acceleration component that is limited.
    pub fn accelerations(&self) -> Vec<(usize, f64)> {
        limited_axes(self.translational_acceleration, self.rotational_acceleration)
    }

    /// Index and limit of every wrench component that is limited.
    pub fn wrenches(&self) -> Vec<(usize, f64)> {
        limited_axes(self.force, self.torque)
    }
}

/// Index and limit of every limited component of a twist or wrench.
fn limited_axes(translational: f64, rotational: f64) -> Vec<(usize, f64)> {
    let limits = (0..TWIST).map(|axis| (axis, if axis < 3 { translational } else { rotational }));
    limits.filter(|(_, limit)| limit.is_finite()).collect()
}

/// Largest absolute translational component and largest absolute rotational component of all twists or wrenches.
fn largest(twists: impl Iterator<Item = [f64; TWIST]>) -> [f64; 2] {
    twists.fold([0.0; 2], |largest, twist| {
        std::array::from_fn(|part| twist[3 * part..][..3].iter().fold(largest[part], |value, c| value.max(c.abs())))
    })
}

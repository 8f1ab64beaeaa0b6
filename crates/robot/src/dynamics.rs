//! Dynamics of an arm at one configuration.
//!
//! Spatial vectors in the frame of the base, after Featherstone, *Rigid Body Dynamics Algorithms* (2008): mass matrix by
//! composite rigid bodies (his table 6.2), torques by the recursive Newton-Euler algorithm (his table 5.1).

use nalgebra::{Cholesky, Matrix6, Vector3, Vector6};

use crate::configured::ConfiguredArm;
use crate::joint::{JointMatrix, JointVector, MOST_JOINTS};
use crate::spatial::{Force, Motion, SpatialInertia};

/// Part of a direction's mobility that no other direction shares, below which the arm counts as singular.
const SINGULAR: f64 = 1e-12;

impl ConfiguredArm<'_> {
    /// Joint-space inertia (kg m^2; kg, kg m for prismatic joints), rotors and payload included. Symmetric and positive
    /// definite; beyond the last joint it is the identity.
    ///
    /// `M_ij = S_i . I S_j` for `i <= j`, with the axes `S` and the inertia `I` of all links from `j` on.
    pub fn mass_matrix(&self) -> JointMatrix {
        let mut mass = JointMatrix::identity();
        let mut composite = SpatialInertia::zero();
        for column in (0..self.arm.joints().len()).rev() {
            composite = composite.plus(&self.inertias[column]);
            let momentum = composite.times(&self.axes[column]);
            for row in 0..=column {
                let entry = self.axes[row].power(&momentum);
                mass[(row, column)] = entry;
                mass[(column, row)] = entry;
            }
            mass[(column, column)] += self.arm.joints()[column].rotor_inertia;
        }
        mass
    }

    /// Torques (Nm or N) of Coriolis and centrifugal forces at joint speeds `velocity` (rad/s or m/s), without gravity.
    pub fn bias(&self, velocity: &JointVector) -> JointVector {
        self.link_torque(velocity, &JointVector::zeros(), &Vector3::zeros())
    }

    /// Torques (Nm or N) that hold the arm at rest against the gravity `field` (m/s^2, world frame; mostly -9.81 along z).
    pub fn gravity(&self, field: &Vector3<f64>) -> JointVector {
        self.link_torque(&JointVector::zeros(), &JointVector::zeros(), field)
    }

    /// Torques (Nm or N) for a motion with joint speeds `velocity` (rad/s or m/s) and accelerations `acceleration`
    /// (rad/s^2 or m/s^2) under the gravity `field` (m/s^2, world frame), while the environment acts on the part with
    /// `wrench`: force (N, world frame) and torque about the part's origin (Nm, body frame).
    ///
    /// `M q_ddot + bias + gravity - J' wrench`.
    pub fn required_torque(
        &self,
        velocity: &JointVector,
        acceleration: &JointVector,
        field: &Vector3<f64>,
        wrench: &Vector6<f64>,
    ) -> JointVector {
        let mut torque = self.link_torque(velocity, acceleration, field) - self.jacobian().tr_mul(wrench);
        for (index, joint) in self.arm.joints().iter().enumerate() {
            torque[index] += joint.rotor_inertia * acceleration[index];
        }
        torque
    }

    /// Inertia that the part seems to have while the arm holds it: `(J M^-1 J')^-1`, in the order of [`crate::Jacobian`]
    /// (kg, kg m, kg m^2). Symmetric and positive definite. A redundant arm moves its other joints as it likes
    /// (Khatib, 1987). `None` where the arm is singular: it cannot move the part in some direction.
    pub fn apparent_inertia(&self) -> Option<Matrix6<f64>> {
        let factor = Cholesky::new(self.mass_matrix())?;
        // With M = L L', the mobility J M^-1 J' is Y' Y with Y = L^-1 J'.
        let spread = factor.l().solve_lower_triangular(&self.jacobian().transpose())?;
        let mobility = spread.tr_mul(&spread);
        let factor = Cholesky::new(mobility)?;
        // The square of a pivot is what of a direction's mobility is left while all directions before it are held.
        let is_singular = (0..6).any(|axis| factor.l_dirty()[(axis, axis)].powi(2) < SINGULAR * mobility[(axis, axis)]);
        let inertia = factor.inverse();
        (!is_singular).then(|| (inertia + inertia.transpose()) * 0.5)
    }

    /// Torques of the links without rotors. The base accelerates against gravity, which has the same effect.
    fn link_torque(&self, velocity: &JointVector, acceleration: &JointVector, field: &Vector3<f64>) -> JointVector {
        let count = self.arm.joints().len();
        let upward = -self.arm.base().rotation.inverse_transform_vector(field);
        let (mut motion, mut rate) = (Motion::zero(), Motion { angular: Vector3::zeros(), linear: upward });
        let mut forces = [Force::zero(); MOST_JOINTS];
        for index in 0..count {
            let step = self.axes[index].scaled(velocity[index]);
            rate = rate.plus(&motion.carry(&step)).plus(&self.axes[index].scaled(acceleration[index]));
            motion = motion.plus(&step);
            let inertia = &self.inertias[index];
            forces[index] = inertia.times(&rate).plus(&motion.carry_momentum(&inertia.times(&motion)));
        }
        let mut torque = JointVector::zeros();
        let mut transmitted = Force::zero();
        for index in (0..count).rev() {
            transmitted = transmitted.plus(&forces[index]);
            torque[index] = self.axes[index].power(&transmitted);
        }
        torque
    }
}

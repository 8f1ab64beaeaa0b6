//! Spatial vectors and inertias (Featherstone), all of them about the origin of the arm's base and along its axes. With
//! one common origin, they are simply added.

use nalgebra::{IsometryMatrix3, Matrix3, Vector3};

use crate::inertia::{RigidInertia, parallel_axes};

/// A velocity, an acceleration or a joint's axis: of the body-fixed point that passes the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Angular part (rad/s).
    pub angular: Vector3<f64>,
    /// Linear part (m/s).
    pub linear: Vector3<f64>,
}

/// A momentum or a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// Torque about the origin (Nm).
    pub torque: Vector3<f64>,
    /// Force (N).
    pub force: Vector3<f64>,
}

/// Inertia of a rigid body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialInertia {
    /// Mass (kg).
    mass: f64,
    /// Mass times centre of mass (kg m).
    moment: Vector3<f64>,
    /// About the origin (kg m^2).
    rotational: Matrix3<f64>,
}

impl Motion {
    pub fn zero() -> Self {
        Self { angular: Vector3::zeros(), linear: Vector3::zeros() }
    }

    pub fn scaled(&self, factor: f64) -> Self {
        Self { angular: self.angular * factor, linear: self.linear * factor }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self { angular: self.angular + other.angular, linear: self.linear + other.linear }
    }

    /// Rate of `axis` when it is carried along by this velocity.
    pub fn carry(&self, axis: &Self) -> Self {
        Self {
            angular: self.angular.cross(&axis.angular),
            linear: self.angular.cross(&axis.linear) + self.linear.cross(&axis.angular),
        }
    }

    /// Rate of `momentum` when it is carried along by this velocity.
    pub fn carry_momentum(&self, momentum: &Force) -> Force {
        Force {
            torque: self.angular.cross(&momentum.torque) + self.linear.cross(&momentum.force),
            force: self.angular.cross(&momentum.force),
        }
    }

    /// Velocity of the body-fixed point at a position.
    pub fn at(&self, position: &Vector3<f64>) -> Vector3<f64> {
        self.linear + self.angular.cross(position)
    }

    /// Power of a force along this velocity.
    pub fn power(&self, force: &Force) -> f64 {
        self.angular.dot(&force.torque) + self.linear.dot(&force.force)
    }
}

impl Force {
    pub fn zero() -> Self {
        Self { torque: Vector3::zeros(), force: Vector3::zeros() }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self { torque: self.torque + other.torque, force: self.force + other.force }
    }
}

impl SpatialInertia {
    pub fn zero() -> Self {
        Self { mass: 0.0, moment: Vector3::zeros(), rotational: Matrix3::zeros() }
    }

    /// From a body whose frame is at `frame`.
    pub fn placed(inertia: &RigidInertia, frame: &IsometryMatrix3<f64>) -> Self {
        let rotation = frame.rotation.matrix();
        let centre = rotation * inertia.centre + frame.translation.vector;
        let rotational = rotation * inertia.rotational * rotation.transpose();
        Self {
            mass: inertia.mass,
            moment: centre * inertia.mass,
            rotational: rotational + parallel_axes(&centre) * inertia.mass,
        }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            rotational: self.rotational + other.rotational,
        }
    }

    /// Momentum of the body at a velocity, or the force that accelerates it from rest.
    pub fn times(&self, motion: &Motion) -> Force {
        Force {
            torque: self.rotational * motion.angular + self.moment.cross(&motion.linear),
            force: motion.linear * self.mass + motion.angular.cross(&self.moment),
        }
    }
}

//! Differences from the plan besides the grasp, and both together.

use std::ops::RangeInclusive;

use task::{GraspError, Impedance, Inertia};

use crate::settings_error::{SettingsError, check};

/// How robot, controller and parts differ from their models. By default they do not.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Disturbance {
    /// Relative error of the inertia of the body or, with an arm, of its mass matrix; -0.9 to 10. Gravity stays compensated.
    pub inertia: f64,
    /// Relative error of both stiffnesses of the controller, -0.9 to 10; the damping stays. Of a robot that is commanded by
    /// position or force, of its contact stiffness.
    pub stiffness: f64,
    /// Delay of the controller (s) beyond that of the robot's model, 0 to 0.1. A free body has none.
    pub delay: f64,
    /// Relative error of the joint friction of the arm's model, -1 to 10. A free body has none.
    pub joint_friction: f64,
    /// Error of the measured force (N) and torque (Nm), of each component -1e3 to 1e3. Only robots that are commanded by position
    /// or force measure.
    pub bias: [f64; 6],
    /// Radius of edges (m), 0 to 0.01: faces that overlap by less slip past each other.
    pub edge_radius: f64,
}

impl Disturbance {
    /// Allowed relative errors of inertia and stiffness.
    pub const ERRORS: RangeInclusive<f64> = -0.9..=10.0;
    /// Allowed additional delays (s).
    pub const DELAYS: RangeInclusive<f64> = 0.0..=0.1;
    /// Allowed relative errors of joint friction.
    pub const JOINT_FRICTIONS: RangeInclusive<f64> = -1.0..=10.0;

    /// Allowed errors of a measured component (N, Nm).
    pub const BIASES: RangeInclusive<f64> = -1e3..=1e3;
    /// Allowed radii of edges (m).
    pub const EDGE_RADII: RangeInclusive<f64> = 0.0..=0.01;

    /// Whether every field lies in its range.
    ///
    /// # Errors
    /// The first field that does not, with its value and its range.
    pub fn validate(&self) -> Result<(), SettingsError> {
        check("inertia", self.inertia, &Self::ERRORS, "")?;
        check("stiffness", self.stiffness, &Self::ERRORS, "")?;
        check("delay", self.delay, &Self::DELAYS, "s")?;
        check("joint_friction", self.joint_friction, &Self::JOINT_FRICTIONS, "")?;
        self.bias.iter().try_for_each(|&bias| check("bias", bias, &Self::BIASES, ""))?;
        check("edge_radius", self.edge_radius, &Self::EDGE_RADII, "m")
    }

    /// The inertia that a body really has.
    pub(crate) fn inertia(&self, inertia: &Inertia) -> Inertia {
        Inertia::from_matrix(inertia.matrix() * (1.0 + self.inertia))
    }

    /// The impedance law that the controller really has.
    pub(crate) fn impedance(&self, impedance: Impedance) -> Impedance {
        Impedance {
            translational_stiffness: impedance.translational_stiffness * (1.0 + self.stiffness),
            rotational_stiffness: impedance.rotational_stiffness * (1.0 + self.stiffness),
            ..impedance
        }
    }
}

/// All errors that are injected into a rollout.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Injection {
    /// Of the part in the gripper.
    pub grasp: GraspError,
    /// Of robot, controller and parts.
    pub disturbance: Disturbance,
}

impl<G: Into<GraspError>> From<G> for Injection {
    fn from(grasp: G) -> Self {
        Self { grasp: grasp.into(), disturbance: Disturbance::default() }
    }
}

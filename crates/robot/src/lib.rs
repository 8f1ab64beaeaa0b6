//! Serial arms from URDF files: kinematics, dynamics, apparent inertia, and gains for execution.
//!
//! An [`Arm`] stands on a fixed base and holds a part in its tip. At joint positions it has a [`ConfiguredArm`], which answers
//! everything else. Poses, velocities and wrenches are those of the part, as in plans: positions, velocities and forces
//! in the world frame, angular velocities and torques in the body frame, torques about the part's origin.
//!
//! | question | answer | from |
//! |---|---|---|
//! | where is the part? | [`ConfiguredArm::pose`] | product of the joints' frames |
//! | how fast is it? | [`ConfiguredArm::jacobian`], [`ConfiguredArm::velocity_product`] | screws of the joints; Featherstone (2008), ch. 2 |
//! | what moves the arm? | [`ConfiguredArm::mass_matrix`], [`ConfiguredArm::bias`], [`ConfiguredArm::gravity`], [`ConfiguredArm::required_torque`] | composite rigid bodies and recursive Newton-Euler; Featherstone, ch. 5 and 6 |
//! | how heavy does the part seem? | [`ConfiguredArm::apparent_inertia`] | `(J M^-1 J')^-1`; Khatib (1987) |
//! | which joint positions? | [`Arm::inverse_kinematics`], [`Arm::follow`], [`Arm::follow_back`] | Levenberg-Marquardt; Sugihara (2011) |
//! | which gains? | [`gains`] | dynamic similarity, statics of joint friction |
//!
//! Everything at a configuration is computed without allocations, in arrays for up to [`MOST_JOINTS`] joints, and can be asked for
//! several hundred thousand times per second. Elasticity, damping and friction of joints are not modelled.

mod arm;
mod chain;
mod configured;
mod dynamics;
mod error;
mod follow;
pub mod gains;
mod inertia;
mod inverse;
mod joint;
mod spatial;
mod urdf;

pub use arm::{Arm, ArmError};
pub use chain::MovedLink;
pub use configured::{CHARACTERISTIC_LENGTH, ConfiguredArm};
pub use error::RobotError;
pub use follow::{FollowError, FollowReason, JointExtreme, JointPath};
pub use inertia::{InertiaError, RigidInertia};
pub use inverse::InverseError;
pub use joint::{Jacobian, Joint, JointKind, JointMatrix, JointVector, MOST_JOINTS};

//! Robots without a torque interface. Such a robot moves to commanded poses, with a lag and a delay, however hard it is pushed.
//! An admittance law makes it compliant: it measures the wrench at the flange and commands the motion
//!
//! `M a + D (v - v_r) + K (x - x_r) = F`
//!
//! of a virtual mass `M` with damping `D` and stiffness `K` around the reference `x_r`, under the measured contact wrench `F`.
//! A maker's force mode does the same with a gain `1 / D` of its own when it is commanded the wrench of the impedance law.
//!
//! [`Gains`] are chosen by [`ContactLoop`], the loop of law, servo, sensor and contact, so that it is stable against everything
//! that is no stiffer than the stated contact stiffness. [`Gains::planned`] is the motion that a plan assumes, lag included.
//! [`Controller`] and [`Servo`] are law and robot in discrete time, for rollouts.

mod contact_loop;
mod controller;
mod gains;
mod motion;
mod robot;
mod sensor;
mod servo;

pub use contact_loop::{ContactLoop, LARGEST_SENSITIVITY};
pub use controller::Controller;
pub use gains::Gains;
pub use motion::Motion;
pub use robot::{Feedback, ForceMode, Limits, PositionRobot, Sensor};
pub use sensor::Measurement;
pub use servo::Servo;

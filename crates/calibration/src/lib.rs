//! Calibration: what a scene says of its robot, fitted to logs of executed plans.
//!
//! A player of an export logs where the robot believed the part, the reference that it followed and the gains that were set.
//! Rollouts of crate `simulation` do the same with the inertia, friction, damping and delay that the scene has. What
//! differs tells how these are wrong.
//!
//! 1. [`Log`] reads logs and refuses those of other scenes.
//! 2. A run is a log on a regular grid. It is played as a whole, from the approach on: there the robot is at rest, as rollouts
//!    are at their start.
//! 3. Parameters ([`Parameter`]) are bounded, each with a scale. Logs with contacts also have the grasp error of their run,
//!    which begins with what the end of the log tells.
//! 4. Residuals are differences of believed poses over their noise, which follows from the residuals themselves: positions and
//!    orientations are weighted by what the model leaves of each.
//! 5. Levenberg and Marquardt's method finds the least sum of squares. Derivatives are differences with steps of 2 % of a
//!    scale, as contacts and dry friction are not smooth. Runs in free air are fitted first, then all runs together, with the
//!    contact friction of a few that does best.
//! 6. Standard errors are those of the jackknife over blocks of time: what changes when a part of the motion is left out. A
//!    parameter whose error is larger than what makes it worth knowing is held at what the scene says, and the rest is fitted
//!    again; errors of the rest then know that the held one may be wrong.
//! 7. [`Entries`] are what the scene should say instead: the values, and as `[robustness]` two standard errors of them.
//!
//! | module | what it holds |
//! |---|---|
//! | `log`, `run` | logs, and what rollouts need of them |
//! | `deviation`, `swing` | how far poses are from each other; robots that swing by themselves |
//! | `parameter`, `model` | parameters, and rollouts with them |
//! | `least_squares`, `statistics` | the fit and how well it is known; dense algebra is faer's |
//! | `calibration` | the search |
//! | `entries`, `record` | what is written |

mod calibration;
mod deviation;
mod entries;
mod least_squares;
mod log;
mod model;
mod parameter;
mod record;
mod run;
mod statistics;
mod swing;

pub use calibration::{Calibration, Covariance, Estimate, Misfit, Progress, RunResult, calibrate};
pub use entries::{Entries, Entry};
pub use log::Log;
pub use parameter::{Parameter, Quantity};
pub use record::{CalibrationRecord, CovarianceRecord, ParameterRecord, RunRecord};

//! Calibration: fits the robot of a scene to logs of executed plans.
//!
//! The player of an export logs the believed pose of the part, the reference and the gains that were set. Rollouts of crate
//! `simulation` repeat the motion with the inertia, friction, damping and delay of the scene. Their difference shows the
//! errors of these parameters.
//!
//! 1. [`Log`] reads logs and refuses those of other scenes.
//! 2. A run is a log on a regular grid. It is played as a whole, from the approach on: there the robot is at rest, as
//!    rollouts are at their start.
//! 3. Parameters ([`Parameter`]) are bounded, each with a scale. Logs with contacts also have the grasp error of their run,
//!    whose initial value comes from the end of the log.
//! 4. Residuals are differences of believed poses over their noise, which is estimated from the residuals themselves, apart
//!    for positions and orientations.
//! 5. The Levenberg-Marquardt method minimises the sum of squares. Derivatives are finite differences with steps of 2 % of a
//!    scale, as contacts and dry friction are not smooth. Runs in free air are fitted first, from the valley of the delay, then
//!    all runs together, with the best of several values of contact friction.
//! 6. Standard errors come from a jackknife over blocks of time. A parameter whose error exceeds its resolution is held at
//!    the value of the scene, and the others are fitted again; their errors include the uncertainty of the held one.
//! 7. [`Entries`] are the new entries of the scene: the values, and two standard errors of them as `[robustness]`.
//!
//! | module | content |
//! |---|---|
//! | `log`, `run` | logs, and their form for rollouts |
//! | `deviation`, `swing` | distances between poses; robots that oscillate by themselves |
//! | `parameter`, `model` | parameters, and rollouts with them |
//! | `commanded` | what is special to robots that are commanded by position or force |
//! | `least_squares`, `statistics` | the fit and its uncertainty; dense algebra by faer |
//! | `profile` | the valley of the delay |
//! | `calibration` | the search |
//! | `entries`, `record` | output |

mod calibration;
mod commanded;
mod deviation;
mod entries;
mod least_squares;
mod log;
mod model;
mod parameter;
mod profile;
mod record;
mod run;
mod statistics;
mod swing;

pub use calibration::{Calibration, Covariance, Estimate, Misfit, Progress, RunResult, calibrate};
pub use entries::{Entries, Entry};
pub use log::Log;
pub use parameter::{Parameter, Quantity};
pub use record::{CalibrationRecord, CovarianceRecord, ParameterRecord, RunRecord};

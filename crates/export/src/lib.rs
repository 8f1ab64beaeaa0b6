//! Exports of a plan for robots: the reference in their frames and at their rate, gains, limits, and players; and models of its
//! scene for simulators.
//!
//! A plan describes the part in the world. A robot moves its tool in the frame of its base: [`Frames`] transfers poses, twists,
//! wrenches and gains from the one to the other, [`SmoothReference`] makes velocities continuous, [`resample`] gives the
//! reference the rate of the robot, [`TrialRecord`] has its success in rollouts, [`FreeAir`] where nothing touches, and
//! [`write()`] puts all that into a folder with a README for exactly this plan and, if the [`Target`] has one, a player.
//!
//! | file | content | from |
//! |---|---|---|
//! | `trajectory.csv` | the reference of the tool | `trajectory` |
//! | `wrench.csv` | expected wrench of the controller at the tool point | `wrench` |
//! | `plan.json` | gains, guards, frames, the arm as a chain of joints, success rates | [`Document`] |
//! | `SHA256SUMS` | hashes of all files: players refuse changed ones | `folder` |
//! | `README.md` | how to check and run it | `readme`, `players/TARGET/README.md` |
//! | `plan.script` | a controller in URScript with the reference in it | `urscript` |
//! | `controllers.yaml` | parameters of the controllers of ros2_control | `ros2_control` |
//! | `*.py` | the player | `players/shared`, `players/topics` of ROS 2, `players/TARGET` |
//! | `plan.xml`, `plan.sdf`, `plan.usda` | a model for simulators | `model`, `models/TARGET.md` |
//!
//! Players are Python, as the libraries of the manufacturers are. They hold no numbers of a plan: they read `plan.json` and
//! `trajectory.csv`. The modules in `players/shared` are the same for all robots; a target adds the communication with its robot.
//! `scripts/test-players` lets them move an arm in MuJoCo.

mod arm_room;
mod document;
mod expectation;
mod folder;
mod frames;
mod free;
mod joints;
mod model;
mod readme;
mod ros2_control;
mod smooth;
mod target;
mod text;
mod trajectory;
mod trial;
mod urscript;
mod wrench;
mod write;

pub use arm_room::ArmStart;
pub use document::{ArmRecord, Document, JointRecord};
pub use expectation::{Expectation, Guards, PhaseGuards};
pub use folder::SUMS;
pub use frames::{Frames, ToolGains, ToolState};
pub use free::FreeAir;
pub use smooth::SmoothReference;
pub use target::Target;
pub use trajectory::{resample, trajectory_csv};
pub use trial::{RateRecord, TrialRecord};
pub use write::{DOCUMENT, PARAMETERS, README, Request, SCRIPT, TRAJECTORY, WRENCH, Written, write};

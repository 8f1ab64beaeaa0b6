//! What robots read of a plan: the reference in their frames and at their rate, gains, limits, and players.
//!
//! A plan describes the part in the world. A robot moves its tool in the frame of its base: [`Frames`] carries poses, twists,
//! wrenches and gains from the one to the other, [`SmoothReference`] makes velocities continuous, [`resample`] gives the
//! reference the rate of the robot, [`TrialRecord`] says how it does in rollouts, [`FreeAir`] where nothing touches, and
//! [`write()`] puts all that into a folder with a README for exactly this plan and, if the [`Target`] has one, a player.
//!
//! | file of a folder | what it is | from |
//! |---|---|---|
//! | `trajectory.csv` | the reference of the tool | `trajectory` |
//! | `wrench.csv` | what the controller is expected to do at the tool point | `wrench` |
//! | `plan.json` | gains, guards, frames, the arm as a chain of joints, how good the plan is | [`Document`] |
//! | `SHA256SUMS` | hashes of all files: what was changed is not played | `folder` |
//! | `README.md` | how to check and run it | `readme`, `players/TARGET/README.md` |
//! | `plan.script` | a controller in URScript with the reference in it | `urscript` |
//! | `*.py` | the player | `players/shared`, `players/TARGET` |
//!
//! Players are Python, as the libraries of the makers are. They hold no numbers of a plan: they read `plan.json` and
//! `trajectory.csv`. The modules in `players/shared` are the same for all robots; a target adds what talks to its robot.
//! `scripts/test-players` lets them move an arm in MuJoCo.

mod document;
mod expectation;
mod folder;
mod frames;
mod free;
mod joints;
mod readme;
mod smooth;
mod target;
mod text;
mod trajectory;
mod trial;
mod urscript;
mod wrench;
mod write;

pub use document::{ArmRecord, Document, JointRecord};
pub use expectation::{Expectation, Guards, PhaseGuards};
pub use folder::SUMS;
pub use frames::{Frames, ToolGains, ToolState};
pub use free::FreeAir;
pub use smooth::SmoothReference;
pub use target::Target;
pub use trajectory::{resample, trajectory_csv};
pub use trial::{RateRecord, TrialRecord};
pub use write::{DOCUMENT, README, Request, SCRIPT, TRAJECTORY, WRENCH, Written, write};

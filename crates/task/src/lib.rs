//! What is to be planned and what a plan is, in plain numbers: everything that scenes, the optimal control problem and
//! rollouts share. Needs neither Ipopt nor files.
//!
//! An [`AssemblyTask`] is one body, one environment, one start and goal and the offsets to be borne.
//! [`HomotopySettings`] say how it is solved. A [`Trajectory`] is the outcome: a reference and the motion of the body in
//! every scenario, with its [`Quality`] and the [`Limits`] that it keeps.
//!
//! | paper | here |
//! |---|---|
//! | `P_q^-1` (Sec. ocp:ocp) | [`pose::without_offset`] |
//! | `Eq. impedancewrench` | [`Impedance::wrench`] |
//! | Sec. ocp:cost, the weights | [`CostWeights`] |
//! | Sec. ocp:homotopy, the schedule | [`HomotopySettings::schedule`] |
//! | bounds on velocities, accelerations and forces (Sec. intro) | [`Limits`] |

pub mod algebra;
mod impedance;
mod inertia;
mod limits;
pub mod pose;
mod quality;
mod settings;
mod state;
mod task;
mod trajectory;

pub use impedance::Impedance;
pub use inertia::Inertia;
pub use limits::Limits;
pub use quality::{Contact, Peak, Quality};
pub use settings::{Complementarity, HessianKind, HomotopySettings, IpoptOption, IpoptValue, LinearSolver, Smoothing};
pub use state::{POSE, STATE, TWIST, at_rest, pose_of};
pub use task::{AssemblyTask, ContactPair, CostWeights, Horizon, TrajectoryCost};
pub use trajectory::{ScenarioTrajectory, Trajectory};

//! The planning task and the plan, as plain numbers. Scenes, the optimal control problem and rollouts share these
//! types. The crate needs neither Ipopt nor files.
//!
//! An [`AssemblyTask`] has one body, one environment, one start, one goal, and the position offsets that the plan must
//! tolerate. [`HomotopySettings`] say how the task is solved. The result is a [`Trajectory`]: a reference, and the
//! motion of the body in every scenario, with its [`Quality`] and the tightest [`Limits`] that it satisfies.
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

//! The planning task and the plan, as plain numbers. Scenes, the optimal control problem and rollouts share these
//! types. The crate needs neither Ipopt nor files.
//!
//! An [`AssemblyTask`] has one body, one environment, one start, one goal, and the grasp errors that the plan must
//! tolerate. [`HomotopySettings`] say how the task is solved. The result is a [`Trajectory`]: a reference, and the
//! motion of the body in every scenario, with its [`Quality`] and the tightest [`Limits`] that it satisfies.
//!
//! The paper is *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives*
//! by Dietz et al., numbers as in the preprint:
//!
//! | paper | label | here |
//! |---|---|---|
//! | Eq. (18), impedance law | `Eq. impedancewrench` | [`Impedance::wrench`] |
//! | `P_q^-1` of the start, Sec. V-B | `Sec. ocp:ocp` | [`GraspError::actual`] |
//! | weights of the cost, Sec. V-C | `Sec. ocp:cost` | [`CostWeights`] |
//! | schedule of the homotopy, Sec. V-D | `Sec. ocp:homotopy` | [`HomotopySettings::schedule`] |
//! | bounds on velocities, accelerations and forces, Sec. I | `Sec. intro` | [`Limits`] |

pub mod algebra;
mod coverage;
mod grasp_error;
mod impedance;
mod inertia;
mod limits;
mod penetration;
pub mod pose;
mod quality;
mod settings;
mod state;
mod straight;
mod task;
mod trajectory;

pub use coverage::Coverage;
pub use grasp_error::GraspError;
pub use impedance::Impedance;
pub use inertia::Inertia;
pub use limits::{FORCE_WINDOW, Limits};
pub use penetration::Penetration;
pub use pose::{POSE, Pose, PoseError};
pub use quality::{Contact, Peak, Quality};
pub use settings::{Complementarity, HessianKind, HomotopySettings, IpoptOption, IpoptValue, LinearSolver, Smoothing};
pub use state::{STATE, State, TWIST, Twist, Wrench};
pub use straight::{Departure, StraightMotion};
pub use task::{AssemblyTask, ContactPair, CostWeights, Horizon, Scenario, TrajectoryCost};
pub use trajectory::{ScenarioTrajectory, Trajectory};

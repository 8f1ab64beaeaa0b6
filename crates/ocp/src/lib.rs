//! Robust contact-implicit optimal control: one reference trajectory for many offsets (paper, Sec. diffphys and ocp).
//!
//! An [`AssemblyTask`] is transcribed into a sparse nonlinear program ([`Transcription`]) whose smoothing a
//! [`Homotopy`] tightens step by step; each step ends in a [`Trajectory`].
//!
//! The equations are recorded as tapes in `model` and evaluated at all stages and scenarios at once. Distances stay
//! off the tapes: the contact tape takes the contact information `W = (Phi_tau, n~_tau)` as an input, and the adjoint
//! of that input is the seed with which the collision kernel returns `<s, D2W>`.
//!
//! | paper | here |
//! |---|---|
//! | `Eq. ts1`, `Eq. ts` | `model::compliant_dynamics`, `model::contact` |
//! | `Eq. ts3` and Scholtes' relaxation or smoothing | `model::contact`, [`Complementarity`] |
//! | `Eq. impedancewrench` | `model::wrench` |
//! | `P_q^-1` (Sec. ocp:ocp) | [`pose::without_offset`] |
//! | `Eq. discretizedOCP` | [`Transcription`] |
//! | Sec. ocp:cost | `model::running_residuals`, `model::terminal_residuals` |
//! | bounds on velocities, accelerations and forces (Sec. intro) | [`Limits`] |
//! | Sec. ocp:homotopy | [`Homotopy`], [`HomotopySettings::schedule`] |

mod contacts;
mod cost;
mod distances;
mod function;
mod homotopy;
mod layout;
mod limit_rows;
mod limits;
mod model;
mod pattern;
pub mod pose;
mod quality;
mod settings;
mod stage_solver;
mod state;
mod task;
mod trajectory;
mod transcription;

pub use homotopy::{Event, Homotopy, StageResult, StageTiming};
pub use layout::Layout;
pub use limits::Limits;
pub use quality::{Contact, Peak, Quality};
pub use settings::{Complementarity, HessianKind, HomotopySettings, Smoothing};
pub use stage_solver::{STAGE, TranscriptionSolver};
pub use task::{AssemblyTask, ContactPair, CostWeights, Horizon, Impedance, Inertia, TrajectoryCost};
pub use trajectory::{ScenarioTrajectory, Trajectory};
pub use transcription::Transcription;

//! Robust contact-implicit optimal control: one reference trajectory for many offsets (paper, Sec. diffphys and ocp).
//!
//! A [`task::AssemblyTask`] is transcribed into a sparse nonlinear program ([`Transcription`]) whose smoothing a
//! [`Homotopy`] tightens step by step; each iteration ends in a [`task::Trajectory`].
//!
//! The equations are recorded as tapes in `model` and evaluated at all stages and scenarios at once. Distances stay
//! off the tapes: the contact tape takes the contact information `W = (Phi_tau, n~_tau)` as an input, and the adjoint
//! of that input is the seed with which the collision kernel returns `<s, D2W>`.
//!
//! | paper | here |
//! |---|---|
//! | `Eq. ts1`, `Eq. ts` | `model::compliant_dynamics`, `model::contact` |
//! | `Eq. ts3` and Scholtes' relaxation or smoothing | `model::contact`, [`task::Complementarity`] |
//! | `Eq. impedancewrench` | [`task::Impedance::wrench`] |
//! | `P_q^-1` (Sec. ocp:ocp) | [`task::pose::without_offset`] |
//! | `Eq. discretizedOCP` | [`Transcription`] |
//! | Sec. ocp:cost | `model::running_residuals`, `model::terminal_residuals` |
//! | bounds on velocities, accelerations and forces (Sec. intro) | [`task::Limits`], `limit_rows` |
//! | Sec. ocp:homotopy | [`Homotopy`], [`task::HomotopySettings::schedule`] |

mod contacts;
mod cost;
mod distances;
mod function;
mod homotopy;
mod layout;
mod limit_rows;
mod model;
mod motion;
mod pattern;
mod stage_solver;
mod transcription;

pub use homotopy::{Event, Homotopy, HomotopyIteration, IterationTiming, check_settings};
pub use layout::Layout;
pub use stage_solver::TranscriptionSolver;
pub use transcription::Transcription;

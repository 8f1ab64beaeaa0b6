//! Sparse nonlinear programs and their solution by Ipopt.
//!
//! A [`Problem`] provides values, sparse first and second derivatives and bounds. [`solve`] finds a local minimum from
//! a cold or a primal-dual [`Start`]. Options have Ipopt's own names, and all of them are checked. An observer sees
//! every iteration and can stop the solve, which then returns its last iterate. Panics in a problem or observer do not
//! unwind through C code: Ipopt is stopped, and the panic resumes after Ipopt has returned. [`check_derivatives`]
//! compares a problem's derivatives with central differences.
//!
//! The linear systems are solved by one of Ipopt's own solvers or by one that the caller provides: see
//! [`LinearSystemSolver`].
//!
//! Numerical failure is a [`SolveStatus`], not an error. The time that Ipopt's own linear solvers take is read from the
//! statistics that Ipopt writes to a temporary file.
//!
//! ```
//! use nlp::{Bounds, Control, EvaluationError, LinearSystemSolver, Options, Pattern, Problem, Start, solve};
//!
//! /// `min (x - 3)^2` for `x <= 2`
//! struct Parabola(f64);
//!
//! impl Problem for Parabola {
//!     fn variable_bounds(&self) -> Bounds {
//!         Bounds { lower: vec![f64::NEG_INFINITY], upper: vec![2.0] }
//!     }
//!     fn constraint_bounds(&self) -> Bounds {
//!         Bounds::default()
//!     }
//!     fn jacobian_pattern(&self) -> Pattern {
//!         Pattern::default()
//!     }
//!     fn hessian_pattern(&self) -> Pattern {
//!         Pattern { rows: vec![0], columns: vec![0] }
//!     }
//!     fn set_point(&mut self, x: &[f64]) -> Result<(), EvaluationError> {
//!         self.0 = x[0];
//!         Ok(())
//!     }
//!     fn objective(&mut self) -> Result<f64, EvaluationError> {
//!         Ok((self.0 - 3.0).powi(2))
//!     }
//!     fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
//!         gradient[0] = 2.0 * (self.0 - 3.0);
//!         Ok(())
//!     }
//!     fn constraints(&mut self, _values: &mut [f64]) -> Result<(), EvaluationError> {
//!         Ok(())
//!     }
//!     fn jacobian(&mut self, _values: &mut [f64]) -> Result<(), EvaluationError> {
//!         Ok(())
//!     }
//!     fn hessian(&mut self, factor: f64, _: &[f64], values: &mut [f64]) -> Result<(), EvaluationError> {
//!         values[0] = 2.0 * factor;
//!         Ok(())
//!     }
//! }
//!
//! let start = Start::Cold(vec![0.0]);
//! let solver = LinearSystemSolver::Named(nlp::MUMPS);
//! let solution = solve(&mut Parabola(0.0), &start, &Options::default(), solver, &mut |_| Control::Continue)?;
//! assert!(solution.status.is_success());
//! assert!((solution.iterate.x[0] - 2.0).abs() < 1e-6);
//! # Ok::<(), nlp::SolveError>(())
//! ```

mod callbacks;
mod derivative_check;
mod error;
mod handle;
mod kkt_solver;
mod linear_solver;
mod options;
mod problem;
mod slot;
mod solution;
mod solve;
mod statistics;
mod status;

pub use derivative_check::{DerivativeReport, Entry, Kind, check_derivatives};
pub use error::SolveError;
pub use kkt_solver::{AnalysisError, Factorisation, KktSolver, LinearSystemSolver};
pub use linear_solver::{MUMPS, takes_own_solver};
pub use options::{OptionValue, Options};
pub use problem::{Bounds, EvaluationError, Pattern, Problem};
pub use solution::{Control, Iterate, Progress, Solution, Start, Timing};
pub use solve::{check, solve};
pub use status::SolveStatus;

/// Version of the Ipopt that this program was built with.
pub const IPOPT_VERSION: &str = env!("IPOPT_VERSION");

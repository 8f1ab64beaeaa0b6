//! Expression tapes: a function is recorded once from ordinary Rust arithmetic, differentiated exactly, and evaluated
//! at many points together.
//!
//! The optimal control problem repeats a few functions at every stage and scenario: the time-stepping scheme, the
//! impedance law, the cost. C. Dietz et al., *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with
//! Exact Second-Order Derivatives* (Section IV-B of the preprint, `Sec. diffphys:dsctime`), differentiate them with
//! CasADi; this crate replaces it.
//!
//! | step | here |
//! |---|---|
//! | record | [`Tape::record`]: equal subexpressions are shared, constants folded, unused nodes dropped |
//! | differentiate | [`Tape::jacobian`], [`Tape::lagrangian_hessian`]: tapes of the structural nonzeros, in forward or reverse mode, whichever is cheaper |
//! | evaluate | [`Tape::evaluate`]: every instruction processes a block of points of a [`Batch`] in vector registers |
//!
//! A tape is recorded and differentiated once and evaluated often. Results are bit-identical to the recorded arithmetic
//! in every instruction set. Invalid operations, such as division by zero, give infinities and NaN.
//!
//! Quantities that are computed outside a tape, such as the contact information, are inputs like any other. Their
//! adjoint ([`LagrangianHessian::adjoint`]) is the seed for the second derivatives of the function that computes them.
//!
//! ```
//! use autodiff::{Batch, Tape, Workspace};
//!
//! let tape = Tape::record(2, |inputs| vec![inputs[0] * inputs[1] * inputs[1]]);
//! let jacobian = tape.jacobian(2);
//! let mut inputs = Batch::new(2, 3);
//! inputs.row_mut(0).copy_from_slice(&[1.0, 2.0, 3.0]);
//! inputs.row_mut(1).copy_from_slice(&[4.0, 5.0, 6.0]);
//! let mut values = Batch::new(jacobian.rows.len(), 3);
//! jacobian.tape().evaluate(&inputs, &mut values, &mut Workspace::default());
//! assert_eq!(jacobian.columns, [0, 1]);
//! assert_eq!(values.row(0), [16.0, 25.0, 36.0]);
//! assert_eq!(values.row(1), [8.0, 20.0, 36.0]);
//!
//! // One multiplier per output follows the inputs.
//! let hessian = tape.lagrangian_hessian(2);
//! assert_eq!((hessian.rows, hessian.columns), (vec![1, 1], vec![0, 1]));
//! ```

mod batch;
mod derivatives;
mod differentiate;
mod expression;
mod graph;
mod operation;
mod program;
mod registers;
mod tape;

pub use batch::Batch;
pub use derivatives::{Jacobian, LagrangianHessian};
pub use expression::Expression;
pub use program::{Instructions, Workspace};
pub use tape::Tape;

//! Expression tapes: a function is recorded once from ordinary Rust arithmetic, differentiated exactly, and evaluated
//! at many points at once.
//!
//! The optimal control problem repeats a few functions at every stage and scenario: the time-stepping scheme, the
//! impedance law, the cost. The paper differentiates them with CasADi (Sec. diffphys:dsctime: "First- and second-order
//! derivatives \[...\] will be derived by automatic differentiation"); this crate takes its place.
//!
//! | step | here |
//! |---|---|
//! | record | [`Tape::record`]: equal subexpressions are one, constants are folded, dead code is dropped |
//! | differentiate | [`Tape::jacobian`], [`Tape::lagrangian_hessian`]: tapes of exactly the structural nonzeros, in forward or reverse mode, whichever is cheaper |
//! | evaluate | [`Tape::evaluate`]: every instruction sweeps a block of points of a [`Batch`] in vector registers |
//!
//! Recording and differentiating happen once, evaluation often. Values are those of the recorded arithmetic, bit for
//! bit, in every instruction set. Division by zero and the like give infinities and NaN.
//!
//! What is computed outside a tape, the contact information, enters as an input like any other. Its adjoint
//! ([`LagrangianHessian::adjoint`]) is the seed for the second derivatives of what stands behind it.
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

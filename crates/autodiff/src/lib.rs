//! Expression tapes: a function is recorded once from ordinary Rust arithmetic, differentiated exactly, and evaluated
//! at many points at once.
//!
//! The optimal control problem repeats a few functions at every stage and scenario. A [`Tape`] holds one of them;
//! equal subexpressions are shared. [`Tape::jacobian`] and [`Tape::lagrangian_hessian`] differentiate it symbolically,
//! in reverse mode, into tapes of exactly the structural nonzeros. A [`Batch`] holds the inputs of all points as a
//! structure of arrays, which every instruction of the tape sweeps in vector registers.
//!
//! What is computed outside a tape (contact information) enters as an input like any other: the adjoint of that input
//! is the seed for the second derivatives of what stands behind it.
//!
//! This takes the place of the automatic differentiation of Sec. diffphys:dsctime.
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

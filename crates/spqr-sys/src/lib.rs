//! Rank-revealing sparse QR factorisation by SPQR of the installed SuiteSparse: bindings to its C interface, and
//! [`factorise`], a safe function over them.
//!
//! SPQR is licensed under the GPL, version 2 or later. A program that is linked with it may only be passed on under the
//! GPL, so that nothing depends on this crate by default.

mod bindings;
mod factorisation;

pub use factorisation::{FactorisationError, Triangle, factorise};

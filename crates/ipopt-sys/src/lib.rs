//! Bindings to the C interface of the installed Ipopt, and to the function by which the loaded Ipopt takes a linear solver
//! of the program ([`ma57`]), which no C header declares. Types follow the installed header: `Bool` is an integer up to
//! Ipopt 3.13 and a C99 `bool` after.

#![allow(unsafe_code, missing_docs, non_camel_case_types, non_snake_case, non_upper_case_globals)]
#![allow(clippy::all)]

pub mod ma57;

include!(concat!(env!("OUT_DIR"), "/bindings.rs"));

//! Bindings to the C interface of the installed Ipopt, and to its loader of HSL solvers where that is installed
//! (`HSLLoader.h`, Ipopt 3.11 to 3.13; the crate then passes `hsl_loader` to the build scripts of its dependents).
//! Types follow the installed header: `Bool` is an integer up to Ipopt 3.13 and a C99 `bool` after.

#![allow(unsafe_code, missing_docs, non_camel_case_types, non_snake_case, non_upper_case_globals)]
#![allow(clippy::all)]

include!(concat!(env!("OUT_DIR"), "/bindings.rs"));

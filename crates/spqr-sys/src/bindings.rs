//! Bindings to the C interface of SPQR and to what it needs of CHOLMOD.

#![allow(unsafe_code, missing_docs, non_camel_case_types, non_snake_case, non_upper_case_globals, dead_code)]
#![allow(clippy::all)]

include!(concat!(env!("OUT_DIR"), "/bindings.rs"));

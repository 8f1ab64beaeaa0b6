//! MUMPS by itself, with the settings that Ipopt uses: what tests and benchmarks compare other linear solvers with. Nothing that
//! is shipped depends on this crate.

#![allow(unsafe_code)]

use std::ffi::c_int;
use std::mem::MaybeUninit;
use std::sync::{Mutex, PoisonError};

use bindings::{DMUMPS_STRUC_C, dmumps_c};
use nlp::{AnalysisError, Factorisation, KktSolver};

/// The C interface of the MUMPS that the installed Ipopt uses.
#[allow(missing_docs, non_camel_case_types, non_snake_case, non_upper_case_globals)]
#[allow(clippy::all)]
mod bindings {
    include!(concat!(env!("OUT_DIR"), "/bindings.rs"));
}

/// Sequential MUMPS keeps global state: its calls must not overlap. Solves by Ipopt's own MUMPS do not know of this lock, so
/// that a process that compares runs none.
static CALLS: Mutex<()> = Mutex::new(());

/// Jobs of MUMPS.
const INITIALISE: c_int = -1;
const TERMINATE: c_int = -2;
const ANALYSE: c_int = 1;
const FACTORISE: c_int = 2;
const SOLVE: c_int = 3;

/// Fortran handle of the communicator of all processes.
const WORLD: c_int = -987_654;
/// Errors in `infog(1)`: too little memory, singular.
const TOO_SMALL: [c_int; 2] = [-8, -9];
const SINGULAR: c_int = -10;

/// Ipopt's default pivot tolerance.
const PIVOT_TOLERANCE: f64 = 1e-6;

/// The linear solver MUMPS.
pub struct Mumps {
    structure: Box<DMUMPS_STRUC_C>,
    rows: Vec<c_int>,
    columns: Vec<c_int>,
    values: Vec<f64>,
    analysed: bool,
}

impl Mumps {
    /// A solver without a matrix.
    pub fn new() -> Self {
        // SAFETY: the structure consists of numbers and pointers, for which zero is valid; MUMPS requires nothing more.
        let mut structure = unsafe { Box::new(MaybeUninit::<DMUMPS_STRUC_C>::zeroed().assume_init()) };
        (structure.sym, structure.par, structure.comm_fortran) = (2, 1, WORLD);
        let mut mumps = Self { structure, rows: Vec::new(), columns: Vec::new(), values: Vec::new(), analysed: false };
        mumps.run(INITIALISE);
        let control = &mut mumps.structure.icntl;
        // No output; automatic scaling and ordering; ten times the estimated memory.
        control[..3].fill(0);
        control[3] = 0;
        (control[5], control[6], control[7], control[9], control[12], control[13]) = (7, 7, 77, 0, 1, 1000);
        mumps.structure.cntl[0] = PIVOT_TOLERANCE;
        mumps
    }

    fn run(&mut self, job: c_int) -> c_int {
        let _guard = CALLS.lock().unwrap_or_else(PoisonError::into_inner);
        self.structure.job = job;
        // SAFETY: the pointers refer to arrays of this solver of the stated lengths, and no other thread runs MUMPS.
        unsafe { dmumps_c(&mut *self.structure) };
        self.structure.infog[0]
    }
}

impl Default for Mumps {
    fn default() -> Self {
        Self::new()
    }
}

impl Drop for Mumps {
    fn drop(&mut self) {
        self.run(TERMINATE);
    }
}

impl KktSolver for Mumps {
    fn name(&self) -> &str {
        nlp::MUMPS
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        let from_one = |indices: &[usize]| indices.iter().map(|&index| index as c_int + 1).collect();
        (self.rows, self.columns, self.values) = (from_one(rows), from_one(columns), vec![0.0; rows.len()]);
        self.structure.n = dimension as c_int;
        self.structure.nz = rows.len() as c_int;
        self.structure.irn = self.rows.as_mut_ptr();
        self.structure.jcn = self.columns.as_mut_ptr();
        self.structure.a = self.values.as_mut_ptr();
        self.analysed = false;
        Ok(())
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        self.values.copy_from_slice(values);
        // The analysis uses the values of the first matrix.
        if !self.analysed && self.run(ANALYSE) < 0 {
            return Factorisation::Failed;
        }
        self.analysed = true;
        let mut status = self.run(FACTORISE);
        while TOO_SMALL.contains(&status) && self.structure.icntl[13] < 1_000_000 {
            self.structure.icntl[13] *= 2;
            status = self.run(FACTORISE);
        }
        match status {
            SINGULAR => Factorisation::Singular,
            status if status < 0 => Factorisation::Failed,
            _ => Factorisation::Inertia { negative: self.structure.infog[11] as usize },
        }
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        self.structure.rhs = values.as_mut_ptr();
        let status = self.run(SOLVE);
        self.structure.rhs = std::ptr::null_mut();
        status >= 0
    }

    fn increase_quality(&mut self) {
        self.structure.cntl[0] = self.structure.cntl[0].powf(0.75).min(0.5);
    }
}

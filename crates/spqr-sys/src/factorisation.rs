//! A safe rank-revealing QR factorisation.

#![allow(unsafe_code)]

use std::ffi::c_int;
use std::mem::MaybeUninit;
use std::ptr;
use std::slice::{from_raw_parts, from_raw_parts_mut};

use crate::bindings as c;

/// The triangular factor of `A P = Q R`.
#[derive(Debug, Clone, PartialEq)]
pub struct Triangle {
    /// Numerical rank of `A`.
    pub rank: usize,
    /// `P`: the column of `A` that each column of `R` is.
    pub permutation: Vec<usize>,
    /// Columns of `R`: rows, ascending, with their values. `R` is a staircase: a column that is independent of those
    /// before it ends one row below them, with a value above the tolerance; any other ends no lower.
    pub columns: Vec<Vec<(usize, f64)>>,
}

/// Why a matrix cannot be factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FactorisationError {
    /// An entry has a row that the matrix does not have, does not follow the one before it, or is not finite.
    #[error("an entry of the matrix is outside of it, out of order or not finite")]
    Entry,
    /// Not enough memory, or too large for the integers of SPQR.
    #[error("not enough memory")]
    OutOfMemory,
    /// Any other failure, by CHOLMOD's code.
    #[error("SPQR failed with CHOLMOD's code {0}")]
    Other(i32),
}

/// Factorises a matrix of `rows` rows and the given columns, each with its rows, ascending, and values. A column whose part that is
/// orthogonal to those before it is not longer than `tolerance` counts as dependent on them.
///
/// # Errors
/// When an entry is wrong or memory ends.
pub fn factorise(rows: usize, columns: &[Vec<(usize, f64)>], tolerance: f64) -> Result<Triangle, FactorisationError> {
    let is_valid = |column: &Vec<(usize, f64)>| {
        let are_ascending = column.windows(2).all(|pair| pair[0].0 < pair[1].0);
        are_ascending && column.iter().all(|&(row, value)| row < rows && value.is_finite())
    };
    if !columns.iter().all(is_valid) {
        return Err(FactorisationError::Entry);
    }
    let mut common = Common::start();
    let mut matrix = common.sparse(rows, columns)?;
    let (mut factor, mut permutation) = (ptr::null_mut(), ptr::null_mut());
    // SAFETY: the matrix is valid, unused outputs may be null, and the others are released below.
    let rank = unsafe {
        c::SuiteSparseQR_C(
            c::SPQR_ORDERING_DEFAULT as c_int,
            tolerance.max(0.0),
            0,
            0,
            matrix,
            ptr::null_mut(),
            ptr::null_mut(),
            ptr::null_mut(),
            ptr::null_mut(),
            &mut factor,
            &mut permutation,
            ptr::null_mut(),
            ptr::null_mut(),
            ptr::null_mut(),
            &mut common.0,
        )
    };
    let triangle = match usize::try_from(rank) {
        // SAFETY: SPQR has succeeded, so that the factor is whole.
        Ok(rank) => Ok(unsafe { copied(rank, columns.len(), factor, permutation) }),
        Err(_) => Err(common.error()),
    };
    // SAFETY: all of it was allocated with these parameters and is not used again; null is ignored.
    unsafe {
        c::cholmod_l_free(columns.len(), size_of::<i64>(), permutation.cast(), &mut common.0);
        c::cholmod_l_free_sparse(&mut factor, &mut common.0);
        c::cholmod_l_free_sparse(&mut matrix, &mut common.0);
    }
    triangle
}

/// CHOLMOD's parameters and workspace.
struct Common(c::cholmod_common);

impl Common {
    fn start() -> Self {
        let mut common = MaybeUninit::<c::cholmod_common>::zeroed();
        // SAFETY: the function fills all of it, and zeros are a valid value.
        let mut common = unsafe {
            c::cholmod_l_start(common.as_mut_ptr());
            common.assume_init()
        };
        // Nothing is printed: errors are returned.
        common.print = 0;
        Self(common)
    }

    /// A copy of valid columns as a sparse matrix, which the caller releases.
    fn sparse(
        &mut self,
        rows: usize,
        columns: &[Vec<(usize, f64)>],
    ) -> Result<*mut c::cholmod_sparse, FactorisationError> {
        let count: usize = columns.iter().map(Vec::len).sum();
        // SAFETY: a sorted, packed, unsymmetric, real matrix.
        let matrix = unsafe {
            c::cholmod_l_allocate_sparse(rows, columns.len(), count, 1, 1, 0, c::CHOLMOD_REAL as c_int, &mut self.0)
        };
        if matrix.is_null() {
            return Err(self.error());
        }
        // SAFETY: the arrays were allocated with these lengths; `i` and `x` have at least one entry.
        let (starts, indices, values) = unsafe {
            (
                from_raw_parts_mut((*matrix).p.cast::<i64>(), columns.len() + 1),
                from_raw_parts_mut((*matrix).i.cast::<i64>(), count),
                from_raw_parts_mut((*matrix).x.cast::<f64>(), count),
            )
        };
        starts[0] = 0;
        for (column, entries) in columns.iter().enumerate() {
            starts[column + 1] = starts[column] + entries.len() as i64;
        }
        for (place, &(row, value)) in columns.iter().flatten().enumerate() {
            (indices[place], values[place]) = (row as i64, value);
        }
        Ok(matrix)
    }

    fn error(&self) -> FactorisationError {
        match self.0.status {
            c::CHOLMOD_OUT_OF_MEMORY => FactorisationError::OutOfMemory,
            code => FactorisationError::Other(code),
        }
    }
}

impl Drop for Common {
    fn drop(&mut self) {
        // SAFETY: it was started and is not used again.
        unsafe { c::cholmod_l_finish(&mut self.0) };
    }
}

/// A copy of what SPQR has found.
///
/// # Safety
/// `factor` is a packed sparse matrix of `count` columns, and `permutation` is null or has `count` entries.
unsafe fn copied(rank: usize, count: usize, factor: *const c::cholmod_sparse, permutation: *const i64) -> Triangle {
    // SAFETY: as the caller promises; a packed matrix has as many entries as its last start says.
    let (starts, indices, values) = unsafe {
        let starts = from_raw_parts((*factor).p.cast::<i64>(), count + 1);
        let entries = starts[count] as usize;
        (starts, from_raw_parts((*factor).i.cast::<i64>(), entries), from_raw_parts((*factor).x.cast::<f64>(), entries))
    };
    let permutation = match permutation.is_null() {
        true => (0..count).collect(),
        // SAFETY: as the caller promises.
        false => unsafe { from_raw_parts(permutation, count) }.iter().map(|&column| column as usize).collect(),
    };
    let column = |bounds: &[i64]| {
        let range = bounds[0] as usize..bounds[1] as usize;
        let mut entries: Vec<(usize, f64)> = range.map(|place| (indices[place] as usize, values[place])).collect();
        entries.sort_by_key(|&(row, _)| row);
        entries
    };
    Triangle { rank, permutation, columns: starts.windows(2).map(column).collect() }
}

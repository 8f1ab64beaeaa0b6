//! The general path: a stage's front as one dense block.

use pulp::{Arch, Simd, WithSimd};

use crate::front::assembly::{Place, Target};
use crate::front::bunch_kaufman::{PartialFactorisation, backward, forward};
use crate::kernel::padded;
use crate::pivot::{Breakdown, Pivots, apply_inverse};

/// A dense panel of `order` columns whose rows are the front and the separator.
#[derive(Debug, Clone, Copy)]
pub struct GeneralLayout {
    /// Rows of the front.
    pub order: usize,
    /// Rows of the separator.
    pub separator: usize,
}

impl GeneralLayout {
    /// Rows of the panel.
    pub fn stride(&self) -> usize {
        padded(self.order) + padded(self.separator)
    }

    /// Number of values that are kept for the solves.
    pub fn store(&self) -> usize {
        self.stride() * self.order
    }

    /// Place where a coupling is assembled.
    pub fn target(&self, row: Place, column: Place) -> Target {
        match (row, column) {
            (Place::Front(a), Place::Front(b)) => Target::store(a.max(b) + a.min(b) * self.stride()),
            (Place::Separator(a), Place::Front(b)) | (Place::Front(b), Place::Separator(a)) => {
                Target::store(padded(self.order) + a + b * self.stride())
            }
            (Place::Separator(a), Place::Separator(b)) => Target::schur(a.max(b) + a.min(b) * padded(self.separator)),
        }
    }

    /// Eliminates the assembled front; returns the number of negative pivots.
    pub fn factorise(&self, arch: Arch, numbers: FrontNumbers) -> Result<usize, Breakdown> {
        let (stride, first) = (self.stride(), padded(self.order));
        for (position, scale) in numbers.scale[..self.order].iter_mut().enumerate() {
            *scale += numbers.store[position * (stride + 1)].abs();
        }
        for (position, scale) in numbers.scale[first..first + self.separator].iter_mut().enumerate() {
            *scale += numbers.schur[position * (padded(self.separator) + 1)].abs();
        }
        arch.dispatch(PartialFactorisation {
            arch,
            panel: &mut numbers.store[..self.store()],
            stride,
            schur: numbers.schur,
            separator: self.separator,
            scale: &mut numbers.scale[..stride],
            work: numbers.work,
            pivots: numbers.pivots,
        })
    }
}

/// The values of a front while it is factorised.
pub struct FrontNumbers<'a> {
    /// Values that are kept for the solves.
    pub store: &'a mut [f64],
    /// Values that are passed to the previous stage.
    pub schur: &'a mut [f64],
    /// Sums of the absolute values of the terms of the diagonal entries: front, padded, and separator.
    pub scale: &'a mut [f64],
    pub work: &'a mut [f64],
    pub pivots: Pivots<'a>,
}

/// Factors of a front and its rows in the matrix.
#[derive(Clone, Copy)]
pub struct FrontFactors<'a> {
    pub store: &'a [f64],
    pub diagonal: &'a [f64],
    pub subdiagonal: &'a [f64],
    pub order: &'a [u32],
    /// Rows of the front.
    pub front: &'a [usize],
    /// Rows of the separator.
    pub separator: &'a [usize],
}

/// One sweep of a solve through a front.
pub struct SolveGeneral<'a> {
    pub layout: GeneralLayout,
    pub factors: FrontFactors<'a>,
    /// Right-hand side or solution, by row of the matrix. Between the two sweeps the front's rows hold the values of
    /// its pivots.
    pub values: &'a mut [f64],
    /// Scratch, at least as long as a column of the panel.
    pub work: &'a mut [f64],
    pub backward: bool,
}

impl WithSimd for SolveGeneral<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let (layout, factors, values) = (self.layout, self.factors, self.values);
        let (stride, order) = (layout.stride(), layout.order);
        let work = &mut self.work[..stride];
        work.fill(0.0);
        let separator = padded(order);
        if self.backward {
            for (value, &row) in work.iter_mut().zip(factors.front) {
                *value = values[row];
            }
            apply_inverse(factors.diagonal, factors.subdiagonal, &mut work[..order]);
            for (value, &row) in work[separator..].iter_mut().zip(factors.separator) {
                *value = values[row];
            }
            backward(simd, factors.store, stride, order, work);
            for (value, &position) in work.iter().zip(factors.order) {
                values[factors.front[position as usize]] = *value;
            }
        } else {
            for (value, &position) in work.iter_mut().zip(factors.order) {
                *value = values[factors.front[position as usize]];
            }
            forward(simd, factors.store, stride, order, work);
            for (value, &row) in work.iter().zip(factors.front) {
                values[row] = *value;
            }
            for (value, &row) in work[separator..].iter().zip(factors.separator) {
                values[row] += value;
            }
        }
    }
}

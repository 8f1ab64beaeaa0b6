//! Blocked Bunch-Kaufman factorisation of a dense front and the triangular solves.
//!
//! A front is a panel of columns, one per pivot. Its rows are the pivots, padded, and below them the separator, padded.
//! The elimination includes the separator's rows and updates their block `C`, so that one loop does the work of a
//! factorisation, a triangular solve and a Schur complement:
//!
//! ```text
//! [ A  B' ]   [ L    ] [ D   ] [ L' M' ]
//! [ B  C  ] = [ M  1 ] [   S ] [    1  ]
//! ```

use pulp::{Arch, Simd, WithSimd};

use crate::kernel::{SubtractProduct, dot, largest, pad_of, padded, subtract_columns};
use crate::pivot::{BUNCH_KAUFMAN, Breakdown, Pivot, Pivots, inverse};

/// Columns that are eliminated before the rest is updated with all of them.
const BLOCK: usize = 24;

/// One front to be factorised.
pub struct PartialFactorisation<'a> {
    pub arch: Arch,
    /// On entry the lower triangle of `A` above `B`; on return `L` without its diagonal above `M`.
    pub panel: &'a mut [f64],
    /// Rows of the panel, padded pivots and padded separator.
    pub stride: usize,
    /// On entry the lower triangle of `C`, on return of `S`.
    pub schur: &'a mut [f64],
    /// Order of the separator.
    pub separator: usize,
    /// Sums of the absolute values of the terms of every diagonal entry, by row of the panel.
    pub scale: &'a mut [f64],
    /// `L D` of the columns of a block.
    pub work: &'a mut [f64],
    pub pivots: Pivots<'a>,
}

/// Length of the scratch of a factorisation.
pub fn work_length(stride: usize) -> usize {
    stride * (BLOCK + 1)
}

impl WithSimd for PartialFactorisation<'_> {
    type Output = Result<usize, Breakdown>;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Self::Output {
        let order = self.order();
        for (index, slot) in self.pivots.order.iter_mut().enumerate() {
            *slot = index as u32;
        }
        let mut negative = 0;
        let mut first = 0;
        while first < order {
            let mut next = first;
            // A block keeps a column free for the second half of a 2x2 pivot.
            while next < order && next - first < BLOCK - 1 {
                let pivot = self.choose(simd, first, next);
                negative += self.eliminate(simd, first, next, pivot)?;
                next += pivot.size();
            }
            self.update(first, next);
            first = next;
        }
        Ok(negative)
    }
}

impl PartialFactorisation<'_> {
    /// Number of pivots.
    fn order(&self) -> usize {
        self.pivots.diagonal.len()
    }

    /// Moves a pivot to place `next` and writes its updated columns to the work block.
    #[inline(always)]
    fn choose<S: Simd>(&mut self, simd: S, first: usize, next: usize) -> Pivot {
        let (stride, order) = (self.stride, self.order());
        let slot = next - first;
        self.bring_column(simd, first, next, next, slot);
        let column = &self.work[slot * stride..][..stride];
        let diagonal = column[next];
        let (other, below) = largest(simd, column, next + 1..order);
        if below == 0.0 || diagonal.abs() >= BUNCH_KAUFMAN * below {
            return Pivot::One(diagonal);
        }
        self.bring_column(simd, first, next, other, slot + 1);
        let candidate = &self.work[(slot + 1) * stride..][..stride];
        let beside = largest(simd, candidate, next..other).1.max(largest(simd, candidate, other + 1..order).1);
        if diagonal.abs() * beside >= BUNCH_KAUFMAN * below * below {
            return Pivot::One(diagonal);
        }
        if candidate[other].abs() >= BUNCH_KAUFMAN * beside {
            self.work.copy_within((slot + 1) * stride..(slot + 2) * stride, slot * stride);
            self.exchange(next, next, other, slot);
            return Pivot::One(self.work[slot * stride + next]);
        }
        self.exchange(next, next + 1, other, slot + 1);
        let (column, candidate) = self.work[slot * stride..].split_at(stride);
        Pivot::Two(column[next], column[next + 1], candidate[next + 1])
    }

    /// Writes the updated column of row `index` to the work block: the panel's values minus the eliminated columns of
    /// the block.
    #[inline(always)]
    fn bring_column<S: Simd>(&mut self, simd: S, first: usize, next: usize, index: usize, slot: usize) {
        let stride = self.stride;
        let (done, column) = self.work.split_at_mut(slot * stride);
        let column = &mut column[..stride];
        for j in next..index {
            column[j] = self.panel[index + j * stride];
        }
        // For a column in its own place the rows above it in its pad are copied too; they are never read.
        let from = if index == next { pad_of(index) } else { index };
        column[from..].copy_from_slice(&self.panel[index * stride..][from..stride]);
        let start = pad_of(next);
        let eliminated = next - first;
        let mut factors = [0.0; BLOCK];
        for (factor, done) in factors[..eliminated].iter_mut().zip(done.chunks_exact(stride)) {
            *factor = done[index];
        }
        let columns = &self.panel[first * stride + start..];
        subtract_columns(simd, &mut column[start..], columns, stride, &factors[..eliminated]);
    }

    /// Exchanges rows and columns `place` and `other` of the remaining matrix, and the rows of all columns before
    /// `next`. Columns of the work block up to `slot` are current.
    #[inline(always)]
    fn exchange(&mut self, next: usize, place: usize, other: usize, slot: usize) {
        if place == other {
            return;
        }
        let (stride, order) = (self.stride, self.order());
        let panel = &mut *self.panel;
        panel[other + other * stride] = panel[place + place * stride];
        for j in place + 1..other {
            panel[other + j * stride] = panel[j + place * stride];
        }
        panel.copy_within(place * stride + other + 1..place * stride + order, other * stride + other + 1);
        let separator = padded(order);
        panel.copy_within(place * stride + separator..(place + 1) * stride, other * stride + separator);
        for column in panel[..next * stride].chunks_exact_mut(stride) {
            column.swap(place, other);
        }
        for column in self.work[..(slot + 1) * stride].chunks_exact_mut(stride) {
            column.swap(place, other);
        }
        self.pivots.order.swap(place, other);
        self.scale.swap(place, other);
    }

    /// Writes the columns of `L` of a pivot.
    #[inline(always)]
    fn eliminate<S: Simd>(&mut self, simd: S, first: usize, next: usize, pivot: Pivot) -> Result<usize, Breakdown> {
        let (stride, slot) = (self.stride, next - first);
        let scale = [self.scale[next], self.scale.get(next + 1).copied().unwrap_or(0.0)];
        let negative = pivot.negative(scale)?;
        let start = pad_of(next);
        let work = &self.work[slot * stride..];
        let (scales, _) = S::as_mut_simd_f64s(&mut self.scale[start..stride]);
        let (first_column, second_column) = self.panel[next * stride..].split_at_mut(stride);
        let (lower, _) = S::as_mut_simd_f64s(&mut first_column[start..]);
        let (scaled, _) = S::as_simd_f64s(&work[start..stride]);
        match pivot {
            Pivot::One(d) => {
                (self.pivots.diagonal[next], self.pivots.subdiagonal[next]) = (1.0 / d, 0.0);
                let inverse = simd.splat_f64s(1.0 / d);
                for ((lower, scaled), scale) in lower.iter_mut().zip(scaled).zip(scales) {
                    *lower = simd.mul_f64s(*scaled, inverse);
                    *scale = simd.add_f64s(*scale, simd.abs_f64s(simd.mul_f64s(*lower, *scaled)));
                }
                first_column[start..=next].fill(0.0);
            }
            Pivot::Two(a, b, c) => {
                let (a, b, c) = inverse(a, b, c);
                (self.pivots.diagonal[next], self.pivots.subdiagonal[next]) = (a, b);
                (self.pivots.diagonal[next + 1], self.pivots.subdiagonal[next + 1]) = (c, 0.0);
                let (a, b, c) = (simd.splat_f64s(a), simd.splat_f64s(b), simd.splat_f64s(c));
                let (other, _) = S::as_mut_simd_f64s(&mut second_column[start..stride]);
                let (second, _) = S::as_simd_f64s(&work[stride + start..2 * stride]);
                let columns = lower.iter_mut().zip(other).zip(scaled).zip(second);
                for ((((lower, other), u), v), scale) in columns.zip(scales) {
                    *lower = simd.mul_add_e_f64s(*u, a, simd.mul_f64s(*v, b));
                    *other = simd.mul_add_e_f64s(*u, b, simd.mul_f64s(*v, c));
                    let terms = simd.abs_f64s(simd.mul_f64s(*lower, *u));
                    let terms = simd.add_f64s(terms, simd.abs_f64s(simd.mul_f64s(*other, *v)));
                    *scale = simd.add_f64s(*scale, terms);
                }
                first_column[start..next + 2].fill(0.0);
                second_column[start..next + 2].fill(0.0);
            }
        }
        Ok(negative)
    }

    /// Subtracts the eliminated columns `first..next` from the remaining matrix.
    #[inline(always)]
    fn update(&mut self, first: usize, next: usize) {
        let (stride, order, depth) = (self.stride, self.order(), next - first);
        let (done, rest) = self.panel.split_at_mut(next * stride);
        let left = &done[first * stride..];
        if next < order {
            SubtractProduct {
                target: rest,
                target_stride: stride,
                left,
                left_stride: stride,
                right: self.work,
                right_stride: stride,
                rows: stride,
                depth,
                columns: next..order,
                lower: true,
            }
            .run(self.arch);
        }
        if self.separator > 0 {
            let (separator, rows) = (padded(order), padded(self.separator));
            SubtractProduct {
                target: self.schur,
                target_stride: rows,
                left: &left[separator..],
                left_stride: stride,
                right: &self.work[separator..],
                right_stride: stride,
                rows,
                depth,
                columns: 0..self.separator,
                lower: true,
            }
            .run(self.arch);
        }
    }
}

/// Solves with `L` and subtracts `M` times the result from the separator's rows: `values` are the panel's rows in the
/// order of the pivots.
#[inline(always)]
pub fn forward<S: Simd>(simd: S, panel: &[f64], stride: usize, order: usize, values: &mut [f64]) {
    for (j, column) in panel.chunks_exact(stride).take(order).enumerate() {
        let start = pad_of(j + 1);
        let value = [values[j]];
        subtract_columns(simd, &mut values[start..stride], &column[start..], stride, &value);
    }
}

/// Solves with `[L' M']` for the pivots, given the separator.
#[inline(always)]
pub fn backward<S: Simd>(simd: S, panel: &[f64], stride: usize, order: usize, values: &mut [f64]) {
    for (j, column) in panel.chunks_exact(stride).take(order).enumerate().rev() {
        let start = pad_of(j + 1);
        values[j] -= dot(simd, &column[start..], &values[start..stride]);
    }
}

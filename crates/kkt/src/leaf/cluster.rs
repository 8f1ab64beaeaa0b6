//! Elimination of one cluster of a leaf: a small symmetric block with the rows that couple it to the boundary.

use pulp::Simd;

use crate::pivot::{BUNCH_KAUFMAN, Breakdown, Pivot, inverse};

/// A cluster's values. Block and rows hold those of the matrix at first; later the block holds `L` and the rows are
/// `Y = L^{-1} P B`.
pub struct ClusterValues<'a> {
    /// Square, column-major, full.
    pub block: &'a mut [f64],
    /// Rows of the boundary, in the order of the matrix.
    pub rows: &'a mut [f64],
    pub width: usize,
    /// Whether a row has nonzeros.
    pub filled: &'a mut [bool],
    /// The row at each place.
    pub order: &'a mut [u32],
    /// Diagonal of `D^{-1}`.
    pub diagonal: &'a mut [f64],
    /// Subdiagonal of `D^{-1}`: nonzero in the first row of every 2x2 pivot.
    pub subdiagonal: &'a mut [f64],
    /// Sums of the absolute values of the terms of every diagonal entry.
    pub scale: &'a mut [f64],
}

impl ClusterValues<'_> {
    /// Eliminates all rows; returns the number of negative pivots.
    #[inline(always)]
    pub fn eliminate<S: Simd>(&mut self, simd: S) -> Result<usize, Breakdown> {
        let count = self.order.len();
        for place in 0..count {
            self.order[place] = place as u32;
            self.scale[place] = self.block[place + place * count].abs();
        }
        let mut negative = 0;
        let mut next = 0;
        while next < count {
            let pivot = self.choose(next);
            let second = if next + 1 < count { self.scale[next + 1] } else { 0.0 };
            negative += pivot.negative([self.scale[next], second])?;
            match pivot {
                Pivot::One(d) => self.eliminate_one(simd, next, d),
                Pivot::Two(a, b, c) => self.eliminate_two(simd, next, [a, b, c]),
            }
            next += pivot.size();
        }
        Ok(negative)
    }

    /// The largest off-diagonal entry of a column in the rows from `next` on.
    #[inline(always)]
    fn largest(&self, column: usize, next: usize) -> (usize, f64) {
        let count = self.order.len();
        let mut best = (column, 0.0);
        for row in next..count {
            let value = self.block[row + column * count].abs();
            if row != column && value > best.1 {
                best = (row, value);
            }
        }
        best
    }

    /// Moves the next pivot to its place.
    #[inline(always)]
    fn choose(&mut self, next: usize) -> Pivot {
        let count = self.order.len();
        let diagonal = self.block[next + next * count];
        let (other, below) = self.largest(next, next);
        if below == 0.0 || diagonal.abs() >= BUNCH_KAUFMAN * below {
            return Pivot::One(diagonal);
        }
        let beside = self.largest(other, next).1;
        if diagonal.abs() * beside >= BUNCH_KAUFMAN * below * below {
            return Pivot::One(diagonal);
        }
        if self.block[other + other * count].abs() >= BUNCH_KAUFMAN * beside {
            self.exchange(next, other);
            return Pivot::One(self.block[next + next * count]);
        }
        self.exchange(next + 1, other);
        let start = next + next * count;
        Pivot::Two(self.block[start], self.block[start + 1], self.block[start + 1 + count])
    }

    #[inline(always)]
    fn exchange(&mut self, place: usize, other: usize) {
        if place == other {
            return;
        }
        let count = self.order.len();
        for index in 0..count {
            self.block.swap(place + index * count, other + index * count);
        }
        for index in 0..count {
            self.block.swap(index + place * count, index + other * count);
        }
        self.order.swap(place, other);
        self.scale.swap(place, other);
    }

    #[inline(always)]
    fn eliminate_one<S: Simd>(&mut self, simd: S, next: usize, d: f64) {
        let count = self.order.len();
        (self.diagonal[next], self.subdiagonal[next]) = (1.0 / d, 0.0);
        for row in next + 1..count {
            let entry = self.block[row + next * count];
            if entry == 0.0 {
                continue;
            }
            let factor = entry / d;
            for column in next + 1..count {
                self.block[row + column * count] -= factor * self.block[next + column * count];
            }
            // The pivot's row is left unchanged, so that its column can be overwritten by `L` right away.
            self.block[row + next * count] = factor;
            self.scale[row] += (factor * entry).abs();
            self.subtract_row(simd, row, next, factor);
        }
    }

    #[inline(always)]
    fn eliminate_two<S: Simd>(&mut self, simd: S, next: usize, [a, b, c]: [f64; 3]) {
        let count = self.order.len();
        let (a, b, c) = inverse(a, b, c);
        (self.diagonal[next], self.subdiagonal[next]) = (a, b);
        (self.diagonal[next + 1], self.subdiagonal[next + 1]) = (c, 0.0);
        let columns = [next * count, (next + 1) * count];
        self.block[next + 1 + columns[0]] = 0.0;
        for row in next + 2..count {
            let (u, v) = (self.block[row + columns[0]], self.block[row + columns[1]]);
            if u == 0.0 && v == 0.0 {
                continue;
            }
            let (first, second) = (a * u + b * v, b * u + c * v);
            for column in next + 2..count {
                let start = column * count;
                self.block[row + start] -= first * self.block[next + start] + second * self.block[next + 1 + start];
            }
            (self.block[row + columns[0]], self.block[row + columns[1]]) = (first, second);
            self.scale[row] += (first * u).abs() + (second * v).abs();
            self.subtract_row(simd, row, next, first);
            self.subtract_row(simd, row, next + 1, second);
        }
    }

    /// Subtracts a pivot's row of the boundary from another one.
    #[inline(always)]
    fn subtract_row<S: Simd>(&mut self, simd: S, place: usize, pivot: usize, factor: f64) {
        let (row, pivot) = (self.order[place] as usize, self.order[pivot] as usize);
        if !self.filled[pivot] || factor == 0.0 {
            return;
        }
        self.filled[row] = true;
        let (low, high) = self.rows.split_at_mut(row.max(pivot) * self.width);
        let near = &mut low[row.min(pivot) * self.width..][..self.width];
        let far = &mut high[..self.width];
        let (target, source) = if row < pivot { (near, far) } else { (far, near) };
        let factor = simd.splat_f64s(factor);
        for (target, source) in S::as_mut_simd_f64s(target).0.iter_mut().zip(S::as_simd_f64s(source).0) {
            *target = simd.negate_mul_add_e_f64s(factor, *source, *target);
        }
    }
}

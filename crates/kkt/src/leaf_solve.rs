//! Solves with the factors of a leaf.

use pulp::{Simd, WithSimd};

use crate::kernel::{dot, subtract_columns};
use crate::leaf::{Cell, Leaf};
use crate::leaf_store::{LeafStore, NONE};
use crate::pivot::apply_inverse;

/// Solves with a leaf's `L` and takes its part off the boundary, or the other way round with `L'`.
pub struct SolveLeaf<'a> {
    pub leaf: &'a Leaf,
    pub store: &'a LeafStore,
    /// Right-hand side or solution, by the rows of the matrix. Between the two sweeps the leaf's rows hold those of
    /// its pivots.
    pub values: &'a mut [f64],
    /// As long as the boundary and the largest cell.
    pub work: &'a mut [f64],
    pub backward: bool,
}

/// Factors of one cell.
struct CellFactors<'a> {
    rows: &'a [usize],
    block: &'a [f64],
    order: &'a [u32],
    panel_row: &'a [u32],
    diagonal: &'a [f64],
    subdiagonal: &'a [f64],
}

impl WithSimd for SolveLeaf<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let (leaf, values) = (self.leaf, self.values);
        let (boundary, local) = self.work.split_at_mut(leaf.width);
        boundary.fill(0.0);
        let panel = &self.store.panel[leaf.offset.panel..][..leaf.panel()];
        if self.backward {
            for (value, &row) in boundary.iter_mut().zip(&leaf.boundary) {
                *value = values[row];
            }
            for cell in &leaf.cells {
                let factors = self.store.cell(leaf, cell);
                factors.backward(simd, panel, boundary, values, &mut local[..cell.order]);
            }
        } else {
            for cell in &leaf.cells {
                let factors = self.store.cell(leaf, cell);
                factors.forward(simd, panel, boundary, values, &mut local[..cell.order]);
            }
            for (value, &row) in boundary.iter().zip(&leaf.boundary) {
                values[row] += value;
            }
        }
    }
}

impl LeafStore {
    #[inline(always)]
    fn cell<'a>(&'a self, leaf: &'a Leaf, cell: &Cell) -> CellFactors<'a> {
        let stored = leaf.offset.rows + cell.first..leaf.offset.rows + cell.first + cell.order;
        CellFactors {
            rows: &leaf.rows[cell.first..cell.first + cell.order],
            block: &self.blocks[leaf.offset.blocks + cell.block..][..cell.order * cell.order],
            order: &self.order[stored.clone()],
            panel_row: &self.panel_row[stored.clone()],
            diagonal: &self.diagonal[stored.clone()],
            subdiagonal: &self.subdiagonal[stored],
        }
    }
}

impl CellFactors<'_> {
    #[inline(always)]
    fn forward<S: Simd>(&self, simd: S, panel: &[f64], boundary: &mut [f64], values: &mut [f64], local: &mut [f64]) {
        let (count, width) = (local.len(), boundary.len());
        for (value, &row) in local.iter_mut().zip(self.order) {
            *value = values[self.rows[row as usize]];
        }
        for column in 0..count {
            for row in column + 1..count {
                local[row] -= self.block[row + column * count] * local[column];
            }
        }
        for (value, &row) in local.iter().zip(self.rows) {
            values[row] = *value;
        }
        apply_inverse(self.diagonal, self.subdiagonal, local);
        for (value, &row) in local.iter().zip(self.panel_row) {
            if row != NONE {
                subtract_columns(simd, boundary, &panel[row as usize * width..], width, &[*value]);
            }
        }
    }

    #[inline(always)]
    fn backward<S: Simd>(&self, simd: S, panel: &[f64], boundary: &[f64], values: &mut [f64], local: &mut [f64]) {
        let (count, width) = (local.len(), boundary.len());
        for ((value, &row), &panel_row) in local.iter_mut().zip(self.rows).zip(self.panel_row) {
            *value = values[row];
            if panel_row != NONE {
                *value -= dot(simd, &panel[panel_row as usize * width..][..width], boundary);
            }
        }
        apply_inverse(self.diagonal, self.subdiagonal, local);
        for column in (0..count).rev() {
            for row in column + 1..count {
                local[column] -= self.block[row + column * count] * local[row];
            }
        }
        for (value, &row) in local.iter().zip(self.order) {
            values[self.rows[row as usize]] = *value;
        }
    }
}

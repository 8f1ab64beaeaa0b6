//! Solves with the factors of a leaf.

use pulp::{Simd, WithSimd};

use crate::kernel::{dot, subtract_columns};
use crate::leaf::store::LeafStore;
use crate::leaf::{Cluster, Leaf};
use crate::pivot::apply_inverse;

/// One sweep of a solve through a leaf: forward with `L`, which updates the boundary, or backward with `L'`.
pub struct SolveLeaf<'a> {
    pub leaf: &'a Leaf,
    pub store: &'a LeafStore,
    /// Right-hand side or solution, by row of the matrix. Between the two sweeps the leaf's rows hold the values of its
    /// pivots.
    pub values: &'a mut [f64],
    /// See [`work_length`].
    pub work: &'a mut [f64],
    pub backward: bool,
}

/// Length of the scratch of a solve: boundary, pivots, rows of the panel.
pub fn work_length(leaf: &Leaf) -> usize {
    leaf.width + 2 * leaf.rows.len()
}

impl WithSimd for SolveLeaf<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { leaf, store, values, work, backward } = self;
        let count = leaf.rows.len();
        let pivots = leaf.offset.rows..leaf.offset.rows + count;
        let (boundary, work) = work.split_at_mut(leaf.width);
        let (local, coefficients) = work.split_at_mut(count);
        let panel_pivot = &store.panel_pivot[pivots.clone()][..store.panel_rows[pivots.start] as usize];
        let coefficients = &mut coefficients[..panel_pivot.len()];
        let panel = &store.panel[leaf.offset.panel..];
        let rows = &store.rows[pivots.clone()];
        let (diagonal, subdiagonal) = (&store.diagonal[pivots.clone()], &store.subdiagonal[pivots]);
        for (value, &row) in local.iter_mut().zip(rows) {
            *value = values[row as usize];
        }
        boundary.fill(0.0);
        if backward {
            for (value, &row) in boundary.iter_mut().zip(&leaf.boundary) {
                *value = values[row];
            }
            for (row, &pivot) in panel.chunks_exact(leaf.width).zip(panel_pivot) {
                local[pivot as usize] -= dot(simd, row, boundary);
            }
            apply_inverse(diagonal, subdiagonal, local);
            for cluster in &leaf.clusters {
                store.solve_transposed(leaf, cluster, local);
            }
        } else {
            for cluster in &leaf.clusters {
                store.solve_lower(leaf, cluster, local);
            }
        }
        for (value, &row) in local.iter().zip(rows) {
            values[row as usize] = *value;
        }
        if !backward {
            apply_inverse(diagonal, subdiagonal, local);
            for (coefficient, &pivot) in coefficients.iter_mut().zip(panel_pivot) {
                *coefficient = local[pivot as usize];
            }
            subtract_columns(simd, boundary, panel, leaf.width, coefficients);
            for (value, &row) in boundary.iter().zip(&leaf.boundary) {
                values[row] += value;
            }
        }
    }
}

impl LeafStore {
    fn block(&self, leaf: &Leaf, cluster: &Cluster) -> &[f64] {
        &self.blocks[leaf.offset.blocks + cluster.block..][..cluster.order * cluster.order]
    }

    /// Solves with `L` of a cluster.
    #[inline(always)]
    fn solve_lower(&self, leaf: &Leaf, cluster: &Cluster, local: &mut [f64]) {
        let (block, count) = (self.block(leaf, cluster), cluster.order);
        let local = &mut local[cluster.first..cluster.first + count];
        for column in 0..count {
            for row in column + 1..count {
                local[row] -= block[row + column * count] * local[column];
            }
        }
    }

    /// Solves with `L'` of a cluster.
    #[inline(always)]
    fn solve_transposed(&self, leaf: &Leaf, cluster: &Cluster, local: &mut [f64]) {
        let (block, count) = (self.block(leaf, cluster), cluster.order);
        let local = &mut local[cluster.first..cluster.first + count];
        for column in (0..count).rev() {
            for row in column + 1..count {
                local[column] -= block[row + column * count] * local[row];
            }
        }
    }
}

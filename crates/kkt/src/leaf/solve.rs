//! Solves with the factors of a leaf.

use pulp::{Simd, WithSimd};

use crate::kernel::{Aligned, dot, subtract_columns};
use crate::leaf::factors::LeafFactors;
use crate::leaf::{Cluster, Leaf};
use crate::pivot::apply_inverse;

/// Part of a solution that belongs to a leaf.
#[derive(Debug)]
pub struct LeafSolution {
    /// In the order of the pivots. Between the two sweeps it holds the values after the sweep with `L`.
    pub pivots: Vec<f64>,
    /// Contribution of the forward sweep to the boundary, or the solution there.
    pub boundary: Aligned,
    /// Factors of the panel's rows.
    coefficients: Vec<f64>,
}

impl LeafSolution {
    /// Makes room for a leaf.
    pub fn new(leaf: &Leaf) -> Self {
        let rows = leaf.rows.len();
        Self { pivots: vec![0.0; rows], boundary: Aligned::new(leaf.width), coefficients: Vec::with_capacity(rows) }
    }
}

/// One sweep of a solve through a leaf: forward with `L`, or backward with `L'`.
pub struct SolveLeaf<'a> {
    pub leaf: &'a Leaf,
    pub factors: &'a LeafFactors,
    /// By row of the matrix: the right-hand side, or the solution of the fronts.
    pub values: &'a [f64],
    pub solution: &'a mut LeafSolution,
    pub backward: bool,
}

impl WithSimd for SolveLeaf<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { leaf, factors, values, solution, backward } = self;
        let LeafSolution { pivots, boundary, coefficients } = solution;
        let boundary: &mut [f64] = boundary;
        if backward {
            boundary.fill(0.0);
            for (value, &row) in boundary.iter_mut().zip(&leaf.boundary) {
                *value = values[row];
            }
            for (row, &pivot) in factors.panel.chunks_exact(leaf.width).zip(&factors.panel_pivot) {
                pivots[pivot as usize] -= dot(simd, row, boundary);
            }
            apply_inverse(&factors.diagonal, &factors.subdiagonal, pivots);
            for cluster in &leaf.clusters {
                factors.solve_transposed(cluster, pivots);
            }
            return;
        }
        for (value, &row) in pivots.iter_mut().zip(&factors.rows) {
            *value = values[row as usize];
        }
        for cluster in &leaf.clusters {
            factors.solve_lower(cluster, pivots);
        }
        coefficients.clear();
        coefficients.extend_from_slice(pivots);
        apply_inverse(&factors.diagonal, &factors.subdiagonal, coefficients);
        for (index, &pivot) in factors.panel_pivot.iter().enumerate() {
            // Pivots of the panel's rows ascend, so that none is overwritten before it is read.
            coefficients[index] = coefficients[pivot as usize];
        }
        boundary.fill(0.0);
        let used = factors.panel_pivot.len();
        subtract_columns(simd, boundary, &factors.panel, leaf.width, &coefficients[..used]);
    }
}

impl LeafFactors {
    fn block(&self, cluster: &Cluster) -> &[f64] {
        &self.blocks[cluster.block..][..cluster.order * cluster.order]
    }

    /// Solves with `L` of a cluster.
    #[inline(always)]
    fn solve_lower(&self, cluster: &Cluster, local: &mut [f64]) {
        let (block, count) = (self.block(cluster), cluster.order);
        let local = &mut local[cluster.first..cluster.first + count];
        for column in 0..count {
            for row in column + 1..count {
                local[row] -= block[row + column * count] * local[column];
            }
        }
    }

    /// Solves with `L'` of a cluster.
    #[inline(always)]
    fn solve_transposed(&self, cluster: &Cluster, local: &mut [f64]) {
        let (block, count) = (self.block(cluster), cluster.order);
        let local = &mut local[cluster.first..cluster.first + count];
        for column in (0..count).rev() {
            for row in column + 1..count {
                local[column] -= block[row + column * count] * local[row];
            }
        }
    }
}

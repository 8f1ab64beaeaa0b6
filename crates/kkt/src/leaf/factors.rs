//! Factors of a leaf: elimination of all its clusters and the update of its boundary.

use pulp::{Arch, Simd, WithSimd};

use crate::kernel::{Aligned, SubtractProduct};
use crate::leaf::Leaf;
use crate::leaf::cluster::ClusterValues;
use crate::pivot::Breakdown;

/// Factors of a leaf.
#[derive(Debug)]
pub struct LeafFactors {
    /// Columns of `L`, cluster by cluster.
    pub blocks: Aligned,
    /// Rows of `Y` that have nonzeros.
    pub panel: Aligned,
    /// `D^{-1}`
    pub diagonal: Vec<f64>,
    pub subdiagonal: Vec<f64>,
    /// Row of the matrix of every pivot.
    pub rows: Vec<u32>,
    /// Pivot of every row of the panel.
    pub panel_pivot: Vec<u32>,
}

impl LeafFactors {
    /// Makes room for the factors of a leaf.
    pub fn new(leaf: &Leaf) -> Self {
        let rows = leaf.rows.len();
        Self {
            blocks: Aligned::new(leaf.blocks),
            panel: Aligned::new(leaf.panel()),
            diagonal: vec![0.0; rows],
            subdiagonal: vec![0.0; rows],
            rows: vec![0; rows],
            panel_pivot: Vec::with_capacity(rows),
        }
    }
}

/// Contribution of the elimination of a leaf to its boundary.
#[derive(Debug, Default)]
pub struct LeafUpdate {
    /// Lower triangle, with the stride of the leaf's width.
    pub schur: Aligned,
    /// Sums of the absolute values of the terms of its diagonal.
    pub scale: Aligned,
}

/// Scratch of one leaf.
#[derive(Debug, Default)]
pub struct LeafWork {
    /// Blocks of all clusters, then rows of the boundary.
    numbers: Aligned,
    /// `D^{-1} Y`
    scaled: Aligned,
    filled: Vec<bool>,
    row_scale: Vec<f64>,
    /// Order of the pivots in every cluster.
    order: Vec<u32>,
}

impl LeafWork {
    /// Makes room for a leaf.
    fn reserve(&mut self, leaf: &Leaf) {
        self.numbers.reserve(leaf.blocks + leaf.panel());
        self.scaled.reserve(leaf.panel());
        let rows = self.filled.len().max(leaf.rows.len());
        self.filled.resize(rows, false);
        self.row_scale.resize(rows, 0.0);
        self.order.resize(rows, 0);
    }
}

/// Eliminates a leaf; returns its number of negative pivots.
pub struct FactoriseLeaf<'a> {
    pub arch: Arch,
    pub leaf: &'a Leaf,
    pub values: &'a [f64],
    pub factors: &'a mut LeafFactors,
    pub update: &'a mut LeafUpdate,
    pub work: &'a mut LeafWork,
}

impl WithSimd for FactoriseLeaf<'_> {
    type Output = Result<usize, Breakdown>;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Self::Output {
        let leaf = self.leaf;
        self.work.reserve(leaf);
        self.assemble();
        self.factors.panel_pivot.clear();
        let mut negative = 0;
        for cluster in &leaf.clusters {
            let rows = cluster.first..cluster.first + cluster.order;
            let (blocks, panel) = self.work.numbers.split_at_mut(leaf.blocks);
            let mut numbers = ClusterValues {
                block: &mut blocks[cluster.block..cluster.block + cluster.order * cluster.order],
                rows: &mut panel[rows.start * leaf.width..rows.end * leaf.width],
                width: leaf.width,
                filled: &mut self.work.filled[rows.clone()],
                order: &mut self.work.order[rows.clone()],
                diagonal: &mut self.factors.diagonal[rows.clone()],
                subdiagonal: &mut self.factors.subdiagonal[rows.clone()],
                scale: &mut self.work.row_scale[rows.clone()],
            };
            negative += numbers.eliminate(simd)?;
            self.factors.blocks[cluster.block..][..numbers.block.len()].copy_from_slice(numbers.block);
            self.collect_rows(simd, rows);
        }
        self.update(simd);
        Ok(negative)
    }
}

impl FactoriseLeaf<'_> {
    fn assemble(&mut self) {
        let (leaf, work) = (self.leaf, &mut *self.work);
        let numbers = &mut work.numbers[..leaf.blocks + leaf.panel()];
        numbers.fill(0.0);
        work.filled[..leaf.rows.len()].copy_from_slice(&leaf.filled);
        for &(target, source) in &leaf.entries {
            numbers[target as usize] += self.values[source as usize];
        }
    }

    /// Moves the rows of `Y` of a cluster that have nonzeros to the panel, and `D^{-1} Y` to the scratch.
    #[inline(always)]
    fn collect_rows<S: Simd>(&mut self, simd: S, rows: std::ops::Range<usize>) {
        let (leaf, width) = (self.leaf, self.leaf.width);
        let (factors, work) = (&mut *self.factors, &mut *self.work);
        let numbers = &work.numbers[leaf.blocks + rows.start * width..];
        let order = &work.order[rows.clone()];
        for (row, &position) in factors.rows[rows.start..].iter_mut().zip(order) {
            *row = leaf.rows[rows.start + position as usize] as u32;
        }
        let mut next = 0;
        while next < rows.len() {
            let (place, here) = (next, rows.start + next);
            let size = if factors.subdiagonal[here] != 0.0 { 2 } else { 1 };
            next += size;
            if !order[place..next].iter().any(|&row| work.filled[rows.start + row as usize]) {
                continue;
            }
            let used = factors.panel_pivot.len();
            let panel = &mut factors.panel[used * width..][..size * width];
            let scaled = &mut work.scaled[used * width..][..size * width];
            for (half, panel) in panel.chunks_exact_mut(width).enumerate() {
                let source = order[place + half] as usize * width;
                panel.copy_from_slice(&numbers[source..source + width]);
                factors.panel_pivot.push((here + half) as u32);
            }
            if size == 2 {
                let (first, second) = panel.split_at(width);
                let (scaled_first, scaled_second) = scaled.split_at_mut(width);
                let (a, b, c) = (factors.diagonal[here], factors.subdiagonal[here], factors.diagonal[here + 1]);
                combine(simd, scaled_first, first, a, second, b);
                combine(simd, scaled_second, first, b, second, c);
            } else {
                combine(simd, scaled, panel, factors.diagonal[here], panel, 0.0);
            }
        }
    }

    /// The update `-Y' D^{-1} Y` of the boundary.
    #[inline(always)]
    fn update<S: Simd>(&mut self, simd: S) {
        let (leaf, update) = (self.leaf, &mut *self.update);
        let (width, used) = (leaf.width, self.factors.panel_pivot.len());
        update.schur.reserve(width * width);
        update.scale.reserve(width);
        update.schur[..width * width].fill(0.0);
        let (scale, _) = S::as_mut_simd_f64s(&mut update.scale[..width]);
        scale.fill(simd.splat_f64s(0.0));
        if used == 0 {
            return;
        }
        let panel = &self.factors.panel[..used * width];
        let scaled = &self.work.scaled[..used * width];
        for (left, right) in panel.chunks_exact(width).zip(scaled.chunks_exact(width)) {
            for ((scale, a), b) in scale.iter_mut().zip(S::as_simd_f64s(left).0).zip(S::as_simd_f64s(right).0) {
                *scale = simd.add_f64s(*scale, simd.abs_f64s(simd.mul_f64s(*a, *b)));
            }
        }
        SubtractProduct {
            target: &mut update.schur[..width * width],
            target_stride: width,
            left: panel,
            left_stride: width,
            right: scaled,
            right_stride: width,
            rows: width,
            depth: used,
            columns: 0..leaf.boundary.len(),
            lower: true,
        }
        .run(self.arch);
    }
}

/// `target = a * first + b * second`
#[inline(always)]
fn combine<S: Simd>(simd: S, target: &mut [f64], first: &[f64], a: f64, second: &[f64], b: f64) {
    let (a, b) = (simd.splat_f64s(a), simd.splat_f64s(b));
    let sources = S::as_simd_f64s(first).0.iter().zip(S::as_simd_f64s(second).0);
    for (target, (first, second)) in S::as_mut_simd_f64s(target).0.iter_mut().zip(sources) {
        *target = simd.mul_add_e_f64s(a, *first, simd.mul_f64s(b, *second));
    }
}

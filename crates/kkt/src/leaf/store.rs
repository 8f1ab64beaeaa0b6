//! Values of the leaves: elimination of all their clusters and the update of the boundary.

use pulp::{Arch, Simd, WithSimd};

use crate::kernel::{Aligned, SubtractProduct};
use crate::leaf::cluster::ClusterValues;
use crate::leaf::{Leaf, Offset};
use crate::pivot::Breakdown;

/// Factors of all leaves.
#[derive(Debug)]
pub struct LeafStore {
    /// Columns of `L`, cluster by cluster.
    pub blocks: Aligned,
    /// Rows of `Y` that have nonzeros, consecutive for every leaf.
    pub panel: Aligned,
    /// `D^{-1}`
    pub diagonal: Vec<f64>,
    pub subdiagonal: Vec<f64>,
    /// Row of the matrix of every pivot.
    pub rows: Vec<u32>,
    /// Pivot of every row of a leaf's panel.
    pub panel_pivot: Vec<u32>,
    /// Number of rows of a leaf's panel, stored at the start of the leaf.
    pub panel_rows: Vec<u32>,
}

impl LeafStore {
    /// Allocates the factors of all leaves.
    pub fn new(end: Offset) -> Self {
        Self {
            blocks: Aligned::new(end.blocks),
            panel: Aligned::new(end.panel),
            diagonal: vec![0.0; end.rows],
            subdiagonal: vec![0.0; end.rows],
            rows: vec![0; end.rows],
            panel_pivot: vec![0; end.rows],
            panel_rows: vec![0; end.rows],
        }
    }
}

/// Scratch of one leaf.
#[derive(Debug, Default)]
pub struct LeafWork {
    /// Blocks of all clusters, then rows of the boundary.
    numbers: Aligned,
    /// `D^{-1} Y`
    scaled: Aligned,
    /// Lower triangle of the update of the boundary, with the stride of the leaf's width.
    pub schur: Aligned,
    /// Sums of the absolute values of the terms of the update's diagonal.
    pub scale: Aligned,
    filled: Vec<bool>,
    row_scale: Vec<f64>,
    /// Order of the pivots in every cluster.
    order: Vec<u32>,
}

impl LeafWork {
    /// Makes room for a leaf.
    pub fn reserve(&mut self, leaf: &Leaf) {
        self.numbers.reserve(leaf.blocks + leaf.panel());
        self.scaled.reserve(leaf.panel());
        self.schur.reserve(leaf.width * leaf.width);
        self.scale.reserve(leaf.width);
        let rows = self.filled.len().max(leaf.rows.len());
        self.filled.resize(rows, false);
        self.row_scale.resize(rows, 0.0);
        self.order.resize(rows, 0);
    }
}

/// Eliminates a leaf; returns its number of negative pivots and leaves the update of the boundary in the scratch.
pub struct FactoriseLeaf<'a> {
    pub arch: Arch,
    pub leaf: &'a Leaf,
    pub values: &'a [f64],
    pub store: &'a mut LeafStore,
    pub work: &'a mut LeafWork,
}

impl WithSimd for FactoriseLeaf<'_> {
    type Output = Result<usize, Breakdown>;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Self::Output {
        let leaf = self.leaf;
        self.assemble();
        let mut negative = 0;
        let mut used = 0;
        for cluster in &leaf.clusters {
            let rows = cluster.first..cluster.first + cluster.order;
            let stored = leaf.offset.rows + rows.start..leaf.offset.rows + rows.end;
            let (blocks, panel) = self.work.numbers.split_at_mut(leaf.blocks);
            let mut numbers = ClusterValues {
                block: &mut blocks[cluster.block..cluster.block + cluster.order * cluster.order],
                rows: &mut panel[rows.start * leaf.width..rows.end * leaf.width],
                width: leaf.width,
                filled: &mut self.work.filled[rows.clone()],
                order: &mut self.work.order[rows.clone()],
                diagonal: &mut self.store.diagonal[stored.clone()],
                subdiagonal: &mut self.store.subdiagonal[stored],
                scale: &mut self.work.row_scale[rows.clone()],
            };
            negative += numbers.eliminate(simd)?;
            let stored = leaf.offset.blocks + cluster.block;
            self.store.blocks[stored..stored + numbers.block.len()].copy_from_slice(numbers.block);
            used = self.collect_rows(simd, rows, used);
        }
        self.store.panel_rows[leaf.offset.rows] = used as u32;
        self.update(simd, used);
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

    /// Moves the rows of `Y` of a cluster that have nonzeros to the store, and `D^{-1} Y` to the scratch.
    #[inline(always)]
    fn collect_rows<S: Simd>(&mut self, simd: S, rows: std::ops::Range<usize>, mut used: usize) -> usize {
        let (leaf, width) = (self.leaf, self.leaf.width);
        let base = leaf.offset.rows + rows.start;
        let (store, work) = (&mut *self.store, &mut *self.work);
        let numbers = &work.numbers[leaf.blocks + rows.start * width..];
        let order = &work.order[rows.clone()];
        for (row, &position) in store.rows[base..].iter_mut().zip(order) {
            *row = leaf.rows[rows.start + position as usize] as u32;
        }
        let mut next = 0;
        while next < rows.len() {
            let (place, here) = (next, base + next);
            let size = if store.subdiagonal[here] != 0.0 { 2 } else { 1 };
            next += size;
            if !order[place..next].iter().any(|&row| work.filled[rows.start + row as usize]) {
                continue;
            }
            let panel = &mut store.panel[leaf.offset.panel + used * width..][..size * width];
            let scaled = &mut work.scaled[used * width..][..size * width];
            for (half, panel) in panel.chunks_exact_mut(width).enumerate() {
                let source = order[place + half] as usize * width;
                panel.copy_from_slice(&numbers[source..source + width]);
                store.panel_pivot[leaf.offset.rows + used + half] = (rows.start + place + half) as u32;
            }
            if size == 2 {
                let (first, second) = panel.split_at(width);
                let (scaled_first, scaled_second) = scaled.split_at_mut(width);
                let (a, b, c) = (store.diagonal[here], store.subdiagonal[here], store.diagonal[here + 1]);
                combine(simd, scaled_first, first, a, second, b);
                combine(simd, scaled_second, first, b, second, c);
            } else {
                combine(simd, scaled, panel, store.diagonal[here], panel, 0.0);
            }
            used += size;
        }
        used
    }

    /// The update `-Y' D^{-1} Y` of the boundary.
    #[inline(always)]
    fn update<S: Simd>(&mut self, simd: S, used: usize) {
        let (leaf, work) = (self.leaf, &mut *self.work);
        let width = leaf.width;
        work.schur[..width * width].fill(0.0);
        let (scale, _) = S::as_mut_simd_f64s(&mut work.scale[..width]);
        scale.fill(simd.splat_f64s(0.0));
        if used == 0 {
            return;
        }
        let panel = &self.store.panel[leaf.offset.panel..][..used * width];
        let scaled = &work.scaled[..used * width];
        for (left, right) in panel.chunks_exact(width).zip(scaled.chunks_exact(width)) {
            for ((scale, a), b) in scale.iter_mut().zip(S::as_simd_f64s(left).0).zip(S::as_simd_f64s(right).0) {
                *scale = simd.add_f64s(*scale, simd.abs_f64s(simd.mul_f64s(*a, *b)));
            }
        }
        SubtractProduct {
            target: &mut work.schur[..width * width],
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

//! Leaves: contact forces, slacks and their multipliers of one stage and scenario, eliminated before the front.
//!
//! A leaf consists of independent clusters, one or two for each pair. A cluster is eliminated with pivots from within itself
//! (Bunch-Kaufman, so that a force and its multiplier become a 2x2 pivot where smoothing leaves them without diagonal),
//! and leaves a symmetric update of the states at its boundary. The rows `Y` of all clusters are collected, so that a leaf
//! needs one product `Y' D^{-1} Y`.

pub mod cluster;
pub mod factors;
pub mod solve;

use crate::grouping::{Group, Grouping, Role};
use crate::kernel::padded;
use crate::label::Label;

/// Rows of a leaf that are coupled with each other.
#[derive(Debug)]
pub struct Cluster {
    /// Its first row in the leaf.
    pub first: usize,
    /// Number of rows.
    pub order: usize,
    /// Start of its square block.
    pub block: usize,
}

/// The pattern of a leaf.
#[derive(Debug)]
pub struct Leaf {
    /// Rows of the matrix, cluster by cluster.
    pub rows: Vec<usize>,
    pub clusters: Vec<Cluster>,
    /// Rows of fronts that it is coupled with.
    pub boundary: Vec<usize>,
    /// Padded length of the boundary, and so of a row of `Y`.
    pub width: usize,
    /// Padded number of values of all blocks.
    pub blocks: usize,
    /// Entries of the matrix: target in the blocks and, behind them, the rows of the boundary; source.
    pub entries: Vec<(u32, u32)>,
    /// Whether a row is coupled with the boundary.
    pub filled: Vec<bool>,
    /// Number of multipliers.
    pub multipliers: usize,
}

impl Leaf {
    /// Finds the clusters of a leaf. `local` has a place for every row of the matrix.
    pub fn new(group: &Group, grouping: &Grouping, labels: &[Label], local: &mut [usize]) -> Self {
        let (rows, clusters) = split_into_clusters(group, grouping);
        let width = padded(group.boundary.len());
        let blocks = padded(clusters.iter().map(|cluster| cluster.order * cluster.order).sum());
        let mut cluster_of = vec![0; rows.len()];
        for (index, cluster) in clusters.iter().enumerate() {
            for row in cluster.first..cluster.first + cluster.order {
                local[rows[row]] = row;
                cluster_of[row] = index;
            }
        }
        for (index, &row) in group.boundary.iter().enumerate() {
            local[row] = index;
        }
        let mut filled = vec![false; rows.len()];
        let mut entries = Vec::with_capacity(2 * group.entries.len());
        for entry in &group.entries {
            let (row, other) = (local[entry.row], local[entry.column]);
            let mut add = |target: usize| entries.push((target as u32, entry.source as u32));
            if let Role::Front(_) = grouping.role[entry.column] {
                add(blocks + row * width + other);
                filled[row] = true;
                continue;
            }
            let cluster = &clusters[cluster_of[row]];
            add(cluster.block + row - cluster.first + (other - cluster.first) * cluster.order);
            if row != other {
                add(cluster.block + other - cluster.first + (row - cluster.first) * cluster.order);
            }
        }
        let multipliers = rows.iter().filter(|&&row| labels[row].class.is_multiplier()).count();
        let boundary = group.boundary.clone();
        Self { rows, clusters, boundary, width, blocks, entries, filled, multipliers }
    }

    /// Number of values of the rows of `Y`.
    pub fn panel(&self) -> usize {
        self.rows.len() * self.width
    }
}

/// Connected components of the entries of a leaf, their rows side by side in the order of the leaf.
fn split_into_clusters(group: &Group, grouping: &Grouping) -> (Vec<usize>, Vec<Cluster>) {
    let count = group.rows.len();
    let mut parent: Vec<usize> = (0..count).collect();
    for entry in &group.entries {
        if let (Role::Leaf(_, row), Role::Leaf(_, column)) = (grouping.role[entry.row], grouping.role[entry.column]) {
            let (first, second) = (root(&mut parent, row), root(&mut parent, column));
            // The earliest row represents the cluster, so that clusters keep the order of their first rows.
            parent[first.max(second)] = first.min(second);
        }
    }
    let mut order: Vec<(usize, usize)> = (0..count).map(|index| (root(&mut parent, index), index)).collect();
    order.sort_unstable();
    let mut clusters: Vec<Cluster> = Vec::new();
    let mut block = 0;
    for members in order.chunk_by(|a, b| a.0 == b.0) {
        let first = clusters.last().map_or(0, |cluster| cluster.first + cluster.order);
        clusters.push(Cluster { first, order: members.len(), block });
        block += members.len() * members.len();
    }
    (order.iter().map(|&(_, index)| group.rows[index]).collect(), clusters)
}

/// Representative of a component.
fn root(parent: &mut [usize], mut index: usize) -> usize {
    while parent[index] != index {
        parent[index] = parent[parent[index]];
        index = parent[index];
    }
    index
}

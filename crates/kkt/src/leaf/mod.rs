//! Leaves: contact forces, slacks and their multipliers of one stage and scenario, eliminated before the front.
//!
//! A leaf consists of independent cells, one or two for each pair. A cell is eliminated with pivots from within itself
//! (Bunch-Kaufman, so that a force and its multiplier become a 2x2 pivot where smoothing leaves them without diagonal),
//! and leaves a symmetric update of the states at its boundary. The rows `Y` of all cells are collected, so that a leaf
//! needs one product `Y' D^{-1} Y`.

pub mod cell;
pub mod solve;
pub mod store;

use crate::grouping::{Group, Grouping, Role};
use crate::kernel::padded;
use crate::label::Label;

/// Rows of a leaf that are coupled with each other.
#[derive(Debug)]
pub struct Cell {
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
    /// Rows of the matrix, cell by cell.
    pub rows: Vec<usize>,
    pub cells: Vec<Cell>,
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
    /// Start of its values in the stores.
    pub offset: Offset,
}

/// Start of a leaf's values in the stores of all leaves.
#[derive(Debug, Clone, Copy, Default)]
pub struct Offset {
    /// In the stores with one value per row.
    pub rows: usize,
    /// In the store of the blocks.
    pub blocks: usize,
    /// In the store of the rows of `Y`.
    pub panel: usize,
}

impl Leaf {
    /// Finds the cells of a leaf. `local` has a place for every row of the matrix.
    pub fn new(group: &Group, grouping: &Grouping, labels: &[Label], local: &mut [usize], offset: Offset) -> Self {
        let (rows, cells) = split_into_cells(group, grouping);
        let width = padded(group.boundary.len());
        let blocks = padded(cells.iter().map(|cell| cell.order * cell.order).sum());
        let mut cell_of = vec![0; rows.len()];
        for (index, cell) in cells.iter().enumerate() {
            for row in cell.first..cell.first + cell.order {
                local[rows[row]] = row;
                cell_of[row] = index;
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
            let cell = &cells[cell_of[row]];
            add(cell.block + row - cell.first + (other - cell.first) * cell.order);
            if row != other {
                add(cell.block + other - cell.first + (row - cell.first) * cell.order);
            }
        }
        let multipliers = rows.iter().filter(|&&row| labels[row].class.is_multiplier()).count();
        let boundary = group.boundary.clone();
        Self { rows, cells, boundary, width, blocks, entries, filled, multipliers, offset }
    }

    /// Number of values of the rows of `Y`.
    pub fn panel(&self) -> usize {
        self.rows.len() * self.width
    }

    /// Where the next leaf starts.
    pub fn end(&self) -> Offset {
        Offset {
            rows: self.offset.rows + self.rows.len(),
            blocks: self.offset.blocks + self.blocks,
            panel: self.offset.panel + self.panel(),
        }
    }
}

/// Connected components of the entries of a leaf, their rows side by side in the order of the leaf.
fn split_into_cells(group: &Group, grouping: &Grouping) -> (Vec<usize>, Vec<Cell>) {
    let count = group.rows.len();
    let mut parent: Vec<usize> = (0..count).collect();
    for entry in &group.entries {
        if let (Role::Leaf(_, row), Role::Leaf(_, column)) = (grouping.role[entry.row], grouping.role[entry.column]) {
            let (first, second) = (root(&mut parent, row), root(&mut parent, column));
            // The earliest row represents the cell, so that cells keep the order of their first rows.
            parent[first.max(second)] = first.min(second);
        }
    }
    let mut order: Vec<(usize, usize)> = (0..count).map(|index| (root(&mut parent, index), index)).collect();
    order.sort_unstable();
    let mut cells: Vec<Cell> = Vec::new();
    let mut block = 0;
    for members in order.chunk_by(|a, b| a.0 == b.0) {
        let first = cells.last().map_or(0, |cell| cell.first + cell.order);
        cells.push(Cell { first, order: members.len(), block });
        block += members.len() * members.len();
    }
    (order.iter().map(|&(_, index)| group.rows[index]).collect(), cells)
}

/// Representative of a component.
fn root(parent: &mut [usize], mut index: usize) -> usize {
    while parent[index] != index {
        parent[index] = parent[parent[index]];
        index = parent[index];
    }
    index
}

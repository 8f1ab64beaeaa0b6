//! Numbers of many points as a structure of arrays.

/// Points that are evaluated together; rows are padded to a multiple of it. Two vector registers of the widest
/// instruction set, so that the overhead of an instruction is shared and a tape's registers stay in the first cache.
pub(crate) const BLOCK: usize = 64;

/// A row of numbers per quantity, a column per point.
#[derive(Debug, Clone)]
pub struct Batch {
    rows: usize,
    points: usize,
    values: Vec<[f64; BLOCK]>,
}

impl Batch {
    /// Zeros.
    pub fn new(rows: usize, points: usize) -> Self {
        Self { rows, points, values: vec![[0.0; BLOCK]; rows * points.div_ceil(BLOCK)] }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points
    }

    /// The values of a quantity, one per point.
    pub fn row(&self, row: usize) -> &[f64] {
        let blocks = self.blocks();
        &self.values[row * blocks..(row + 1) * blocks].as_flattened()[..self.points]
    }

    /// The values of a quantity, one per point.
    pub fn row_mut(&mut self, row: usize) -> &mut [f64] {
        let blocks = self.blocks();
        &mut self.values[row * blocks..(row + 1) * blocks].as_flattened_mut()[..self.points]
    }

    /// Number of blocks of points.
    pub(crate) fn blocks(&self) -> usize {
        self.points.div_ceil(BLOCK)
    }

    /// Number of points of a block that are not padding.
    pub(crate) fn points_of_block(&self, block: usize) -> usize {
        (self.points - block * BLOCK).min(BLOCK)
    }

    #[inline(always)]
    pub(crate) fn block(&self, row: usize, block: usize) -> &[f64; BLOCK] {
        &self.values[row * self.blocks() + block]
    }

    #[inline(always)]
    pub(crate) fn block_mut(&mut self, row: usize, block: usize) -> &mut [f64; BLOCK] {
        let index = row * self.blocks() + block;
        &mut self.values[index]
    }
}

/// Equal at every point; the padding does not count.
impl PartialEq for Batch {
    fn eq(&self, other: &Self) -> bool {
        (self.rows, self.points) == (other.rows, other.points)
            && (0..self.rows).all(|row| self.row(row) == other.row(row))
    }
}

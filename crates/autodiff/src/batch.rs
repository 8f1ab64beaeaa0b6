//! Values at many points as a structure of arrays.

/// Points that are evaluated together; rows are padded to a multiple of it. The choice was measured: with fewer points,
/// decoding instructions costs more than arithmetic; with more, the registers of a tape exceed the first two caches.
pub(crate) const BLOCK: usize = 64;

/// Values per cache line.
const CACHE_LINE: usize = 8;

/// A row of values per quantity, a column per point.
#[derive(Debug)]
pub struct Batch {
    rows: usize,
    points: usize,
    /// Start of the rows in `values`, chosen so that no vector crosses a cache line.
    start: usize,
    values: Vec<f64>,
}

impl Batch {
    /// Zeros.
    pub fn new(rows: usize, points: usize) -> Self {
        let values = vec![0.0; rows * points.div_ceil(BLOCK) * BLOCK + CACHE_LINE];
        let start = values.as_ptr().align_offset(CACHE_LINE * size_of::<f64>()).min(CACHE_LINE);
        Self { rows, points, start, values }
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
        assert!(row < self.rows, "row {row} of {}", self.rows);
        let first = self.start + row * self.blocks() * BLOCK;
        &self.values[first..first + self.points]
    }

    /// The values of a quantity, one per point.
    pub fn row_mut(&mut self, row: usize) -> &mut [f64] {
        assert!(row < self.rows, "row {row} of {}", self.rows);
        let first = self.start + row * self.blocks() * BLOCK;
        &mut self.values[first..first + self.points]
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
        let index = row * self.blocks() + block;
        &self.values[self.start..].as_chunks().0[index]
    }

    #[inline(always)]
    pub(crate) fn block_mut(&mut self, row: usize, block: usize) -> &mut [f64; BLOCK] {
        let index = row * self.blocks() + block;
        &mut self.values[self.start..].as_chunks_mut().0[index]
    }
}

/// Copies row by row, because the alignment of a copy may differ.
impl Clone for Batch {
    fn clone(&self) -> Self {
        let mut copy = Self::new(self.rows, self.points);
        for row in 0..self.rows {
            copy.row_mut(row).copy_from_slice(self.row(row));
        }
        copy
    }
}

/// Compares the values at all points, not the padding.
impl PartialEq for Batch {
    fn eq(&self, other: &Self) -> bool {
        (self.rows, self.points) == (other.rows, other.points)
            && (0..self.rows).all(|row| self.row(row) == other.row(row))
    }
}

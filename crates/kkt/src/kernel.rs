//! Dense kernels on column-major blocks, in whole vector registers.
//!
//! Every stride and every start of a column is a multiple of [`PAD`] values, so that no kernel needs a masked load in
//! any instruction set. Row ranges are rounded outwards to whole pads: entries above a diagonal may be overwritten and
//! are never read, and padding rows hold zeros.

use pulp::{Arch, Simd, WithSimd};

/// Rows per pad: one cache line, the width of the widest vector register.
pub const PAD: usize = 8;

/// Rounds up to a multiple of [`PAD`].
pub const fn padded(count: usize) -> usize {
    count.next_multiple_of(PAD)
}

/// Rounds down to a multiple of [`PAD`].
pub const fn pad_of(index: usize) -> usize {
    index / PAD * PAD
}

/// `target -= left * right'`: rows `0..rows` (a multiple of [`PAD`]) of `target` and `left`, and row `j` of `right`
/// for column `j` of `target`.
pub struct SubtractProduct<'a> {
    pub target: &'a mut [f64],
    pub target_stride: usize,
    pub left: &'a [f64],
    pub left_stride: usize,
    pub right: &'a [f64],
    pub right_stride: usize,
    pub rows: usize,
    pub depth: usize,
    /// Columns of the whole matrix; the target starts at the first of them.
    pub columns: std::ops::Range<usize>,
    /// Skip pads of rows that lie entirely above the diagonal.
    pub lower: bool,
}

impl SubtractProduct<'_> {
    /// Runs with the widest available registers.
    pub fn run(self, arch: Arch) {
        arch.dispatch(self);
    }

    /// One tile of `VECTORS` registers by `COLUMNS` columns whose corner is at a given row and column.
    #[inline(always)]
    fn tile<S: Simd, const VECTORS: usize, const COLUMNS: usize>(&mut self, simd: S, row: usize, column: usize) {
        let height = VECTORS * S::F64_LANES;
        let mut sums = [[simd.splat_f64s(0.0); VECTORS]; COLUMNS];
        let left = self.left[row..].chunks(self.left_stride);
        let right = self.right[column..].chunks(self.right_stride);
        for (left, right) in left.zip(right).take(self.depth) {
            let (left, _) = S::as_simd_f64s(&left[..height]);
            let right = &right[..COLUMNS];
            for j in 0..COLUMNS {
                let factor = simd.splat_f64s(right[j]);
                for i in 0..VECTORS {
                    sums[j][i] = simd.mul_add_e_f64s(left[i], factor, sums[j][i]);
                }
            }
        }
        for j in 0..COLUMNS {
            let start = (column - self.columns.start + j) * self.target_stride + row;
            let (target, _) = S::as_mut_simd_f64s(&mut self.target[start..start + height]);
            for i in 0..VECTORS {
                target[i] = simd.sub_f64s(target[i], sums[j][i]);
            }
        }
    }

    /// All rows of `COLUMNS` columns.
    #[inline(always)]
    fn stripe<S: Simd, const COLUMNS: usize>(&mut self, simd: S, column: usize) {
        let mut row = if self.lower { pad_of(column) } else { 0 };
        while row + 3 * S::F64_LANES <= self.rows {
            self.tile::<S, 3, COLUMNS>(simd, row, column);
            row += 3 * S::F64_LANES;
        }
        if row + 2 * S::F64_LANES <= self.rows {
            self.tile::<S, 2, COLUMNS>(simd, row, column);
            row += 2 * S::F64_LANES;
        }
        if row + S::F64_LANES <= self.rows {
            self.tile::<S, 1, COLUMNS>(simd, row, column);
        }
    }
}

impl WithSimd for SubtractProduct<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        let mut column = self.columns.start;
        while column < self.columns.end {
            // Stripes end at a pad, so that all columns of a stripe start at one.
            let width = (PAD - column % PAD).min(self.columns.end - column);
            // Eight columns of three registers fill the 32 registers of AVX-512, four the 16 of AVX2.
            let width = if S::F64_LANES < PAD { width.min(4) } else { width };
            column += match width {
                8 => {
                    self.stripe::<S, 8>(simd, column);
                    8
                }
                4.. => {
                    self.stripe::<S, 4>(simd, column);
                    4
                }
                2.. => {
                    self.stripe::<S, 2>(simd, column);
                    2
                }
                _ => {
                    self.stripe::<S, 1>(simd, column);
                    1
                }
            };
        }
    }
}

/// `target -= sum_p factors[p] * columns[p]` over whole registers, four columns at a time.
#[inline(always)]
pub fn subtract_columns<S: Simd>(simd: S, target: &mut [f64], columns: &[f64], stride: usize, factors: &[f64]) {
    let rows = target.len();
    let (target, _) = S::as_mut_simd_f64s(target);
    let mut fours = factors.chunks_exact(4);
    let mut start = 0;
    for factors in &mut fours {
        let column = |index: usize| S::as_simd_f64s(&columns[start + index * stride..][..rows]).0;
        let (a, b, c, d) = (column(0), column(1), column(2), column(3));
        let (e, f) = (simd.splat_f64s(factors[0]), simd.splat_f64s(factors[1]));
        let (g, h) = (simd.splat_f64s(factors[2]), simd.splat_f64s(factors[3]));
        for ((((target, a), b), c), d) in target.iter_mut().zip(a).zip(b).zip(c).zip(d) {
            let first = simd.negate_mul_add_e_f64s(*b, f, simd.negate_mul_add_e_f64s(*a, e, *target));
            *target = simd.negate_mul_add_e_f64s(*d, h, simd.negate_mul_add_e_f64s(*c, g, first));
        }
        start += 4 * stride;
    }
    for &factor in fours.remainder() {
        let (column, _) = S::as_simd_f64s(&columns[start..start + rows]);
        let factor = simd.splat_f64s(factor);
        for (target, column) in target.iter_mut().zip(column) {
            *target = simd.negate_mul_add_e_f64s(*column, factor, *target);
        }
        start += stride;
    }
}

/// The scalar product of two slices of equal length, a multiple of [`PAD`].
#[inline(always)]
pub fn dot<S: Simd>(simd: S, left: &[f64], right: &[f64]) -> f64 {
    let (left, right) = (S::as_simd_f64s(left).0, S::as_simd_f64s(right).0);
    let zero = simd.splat_f64s(0.0);
    let mut sums = [zero; 2];
    for (a, b) in left.chunks_exact(2).zip(right.chunks_exact(2)) {
        sums[0] = simd.mul_add_e_f64s(a[0], b[0], sums[0]);
        sums[1] = simd.mul_add_e_f64s(a[1], b[1], sums[1]);
    }
    if left.len() % 2 == 1 {
        let last = left.len() - 1;
        sums[0] = simd.mul_add_e_f64s(left[last], right[last], sums[0]);
    }
    simd.reduce_sum_f64s(simd.add_f64s(sums[0], sums[1]))
}

/// Index and absolute value of the largest entry of `values[range]` in absolute value; zero for an empty range.
#[inline(always)]
pub fn largest<S: Simd>(simd: S, values: &[f64], range: std::ops::Range<usize>) -> (usize, f64) {
    let first = padded(range.start).min(range.end);
    let last = pad_of(range.end).max(first);
    let mut best = (range.start, 0.0);
    for index in (range.start..first).chain(last..range.end) {
        if values[index].abs() > best.1 {
            best = (index, values[index].abs());
        }
    }
    let mut peak = simd.splat_f64s(0.0);
    for value in S::as_simd_f64s(&values[first..last]).0 {
        peak = simd.max_f64s(peak, simd.abs_f64s(*value));
    }
    let peak = simd.reduce_max_f64s(peak);
    if peak > best.1 {
        let position = values[first..last].iter().position(|value| value.abs() == peak);
        best = (first + position.unwrap_or(0), peak);
    }
    best
}

/// Values that start at a cache line.
#[derive(Debug, Default)]
pub struct Aligned {
    numbers: Vec<f64>,
    length: usize,
}

impl Aligned {
    /// Zeros.
    pub fn new(length: usize) -> Self {
        Self { numbers: vec![0.0; length + PAD], length }
    }

    /// Makes room for at least `length` values, all of them zero if the store has to grow.
    pub fn reserve(&mut self, length: usize) {
        if length > self.length {
            *self = Self::new(length);
        }
    }

    fn start(&self) -> usize {
        // In values, not bytes. Alignment only affects speed, so an unknown offset does no harm.
        self.numbers.as_ptr().align_offset(PAD * size_of::<f64>()).min(self.numbers.len() - self.length)
    }
}

impl std::ops::Deref for Aligned {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        let start = self.start();
        &self.numbers[start..start + self.length]
    }
}

impl std::ops::DerefMut for Aligned {
    fn deref_mut(&mut self) -> &mut [f64] {
        let start = self.start();
        &mut self.numbers[start..start + self.length]
    }
}

//! Vector lanes: several values in one register, one per pose.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use pulp::Simd;

/// An array by index: `array!(|index| entry)`. Unlike `std::array::from_fn` it is always inlined. Vector operations
/// that are not inlined into the dispatched function pass their operands through memory and take ten times as long.
macro_rules! array {
    (|$index:ident| $entry:expr) => {
        $crate::lane::by_index(
            #[inline(always)]
            |$index| $entry,
        )
    };
}
pub(crate) use array;

#[inline(always)]
pub fn by_index<T: Copy, const N: usize>(entry: impl Fn(usize) -> T) -> [T; N] {
    let mut entries = [entry(0); N];
    for (index, slot) in entries.iter_mut().enumerate().skip(1) {
        *slot = entry(index);
    }
    entries
}

/// As many values as a register of the instruction set holds. Operations are the same IEEE operations in every
/// instruction set, so that results do not depend on it.
#[derive(Clone, Copy)]
pub struct Lane<S: Simd> {
    simd: S,
    value: S::f64s,
}

/// A truth value per lane.
#[derive(Clone, Copy)]
pub struct Mask<S: Simd>(S::m64s);

/// Number of lanes of the widest register of all instruction sets.
pub const MAX_LANES: usize = 8;

impl<S: Simd> Lane<S> {
    /// The same value in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f64) -> Self {
        Self { simd, value: simd.splat_f64s(value) }
    }

    /// The values of a register.
    #[inline(always)]
    pub fn new(simd: S, value: S::f64s) -> Self {
        Self { simd, value }
    }

    /// The values as a register.
    #[inline(always)]
    pub fn register(self) -> S::f64s {
        self.value
    }

    /// The same value in every lane, with the instruction set of `self`.
    #[inline(always)]
    pub fn constant(self, value: f64) -> Self {
        Self::splat(self.simd, value)
    }

    /// The first values of an array, one per lane.
    #[inline(always)]
    fn load(simd: S, values: &[f64; MAX_LANES]) -> Self {
        let (registers, _) = S::as_simd_f64s(&values[..S::F64_LANES]);
        Self { simd, value: registers[0] }
    }

    /// The values as an array; entries beyond the register are zero.
    #[inline(always)]
    pub fn to_array(self) -> [f64; MAX_LANES] {
        let mut values = [0.0; MAX_LANES];
        let (registers, _) = S::as_mut_simd_f64s(&mut values[..S::F64_LANES]);
        registers[0] = self.value;
        values
    }

    /// `self factor + term`, rounded once.
    #[inline(always)]
    pub fn mul_add(self, factor: Self, term: Self) -> Self {
        Self { value: self.simd.mul_add_f64s(self.value, factor.value, term.value), ..self }
    }

    /// `term - self factor`, rounded once.
    #[inline(always)]
    pub fn mul_sub_from(self, factor: Self, term: Self) -> Self {
        Self { value: self.simd.negate_mul_add_f64s(self.value, factor.value, term.value), ..self }
    }

    /// The smaller value.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { value: self.simd.min_f64s(self.value, other.value), ..self }
    }

    /// The larger value.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { value: self.simd.max_f64s(self.value, other.value), ..self }
    }

    /// Absolute value.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { value: self.simd.abs_f64s(self.value), ..self }
    }

    /// Reciprocal.
    #[inline(always)]
    pub fn recip(self) -> Self {
        Self { value: self.simd.div_f64s(self.simd.splat_f64s(1.0), self.value), ..self }
    }

    /// Square root.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { value: self.simd.sqrt_f64s(self.value), ..self }
    }

    /// The lanes in which this value is smaller.
    #[inline(always)]
    pub fn less_than(self, other: Self) -> Mask<S> {
        Mask(self.simd.less_than_f64s(self.value, other.value))
    }

    /// This value where the mask holds, the other one elsewhere.
    #[inline(always)]
    pub fn select(self, mask: Mask<S>, other: Self) -> Self {
        Self { value: self.simd.select_f64s(mask.0, self.value, other.value), ..self }
    }

    /// Whether the mask holds in every lane.
    #[inline(always)]
    pub fn all(self, mask: Mask<S>) -> bool {
        let holds = self.constant(1.0).select(mask, self.constant(0.0));
        self.simd.reduce_min_f64s(holds.value) > 0.0
    }
}

impl<S: Simd> Add for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.simd.add_f64s(self.value, other.value), ..self }
    }
}

impl<S: Simd> Sub for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.simd.sub_f64s(self.value, other.value), ..self }
    }
}

impl<S: Simd> Mul for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { value: self.simd.mul_f64s(self.value, other.value), ..self }
    }
}

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: self.simd.neg_f64s(self.value), ..self }
    }
}

impl<S: Simd> AddAssign for Lane<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Simd> SubAssign for Lane<S> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// One record per lane; the last one is repeated when there are fewer records than lanes.
#[inline(always)]
pub fn gather<S: Simd, const N: usize>(simd: S, records: &[[f64; N]]) -> [Lane<S>; N] {
    let mut columns = [[0.0; MAX_LANES]; N];
    let last = records.len() - 1;
    for lane in 0..S::F64_LANES {
        let record = &records[lane.min(last)];
        for index in 0..N {
            columns[index][lane] = record[index];
        }
    }
    array!(|index| Lane::load(simd, &columns[index]))
}

/// Writes one record per lane, as far as there are records.
#[inline(always)]
pub fn scatter<'records, S: Simd, const N: usize>(
    values: &[Lane<S>; N],
    records: impl Iterator<Item = &'records mut [f64; N]>,
) {
    let columns: [[f64; MAX_LANES]; N] = array!(|index| values[index].to_array());
    for (lane, record) in records.take(S::F64_LANES).enumerate() {
        for index in 0..N {
            record[index] = columns[index][lane];
        }
    }
}

/// A vector in R^3 per lane.
pub type Vector<S> = [Lane<S>; 3];

/// `a b`
#[inline(always)]
pub fn dot<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> Lane<S> {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// `a x b`
#[inline(always)]
pub fn cross<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> Vector<S> {
    [a[1].mul_add(b[2], -(a[2] * b[1])), a[2].mul_add(b[0], -(a[0] * b[2])), a[0].mul_add(b[1], -(a[1] * b[0]))]
}

/// Matrix times vector.
#[inline(always)]
pub fn rotate<S: Simd>(matrix: &[Vector<S>; 3], vector: &Vector<S>) -> Vector<S> {
    [dot(&matrix[0], vector), dot(&matrix[1], vector), dot(&matrix[2], vector)]
}

/// A column of a matrix of three rows.
#[inline(always)]
pub fn column<S: Simd, const N: usize>(matrix: &[[Lane<S>; N]; 3], index: usize) -> Vector<S> {
    [matrix[0][index], matrix[1][index], matrix[2][index]]
}

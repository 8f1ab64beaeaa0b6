//! The 4 x 4 Newton matrices of the distance problem.

use pulp::Simd;

use crate::lane::{Lane, Vector, array};

/// Symmetric 4 x 4 matrix `sum weight a a'` with `a = (normal, -1)`, as its ten distinct entries xx, xy, xz, yy, yz,
/// zz, xa, ya, za, aa.
#[derive(Clone, Copy)]
pub struct Moments<S: Simd>(pub [Lane<S>; 10]);

/// Index of the entry (row, column) in [`Moments`].
const PLACES: [[usize; 4]; 4] = [[0, 1, 2, 6], [1, 3, 4, 7], [2, 4, 5, 8], [6, 7, 8, 9]];

impl<S: Simd> Moments<S> {
    /// All zero.
    #[inline(always)]
    pub fn zero(simd: S) -> Self {
        Self([Lane::splat(simd, 0.0); 10])
    }

    /// Adds `weight a a'`.
    #[inline(always)]
    pub fn add(&mut self, weight: Lane<S>, normal: &Vector<S>) {
        let m = &mut self.0;
        let [x, y, z] = *normal;
        let (wx, wy, wz) = (weight * x, weight * y, weight * z);
        m[0] = wx.mul_add(x, m[0]);
        m[1] = wx.mul_add(y, m[1]);
        m[2] = wx.mul_add(z, m[2]);
        m[3] = wy.mul_add(y, m[3]);
        m[4] = wy.mul_add(z, m[4]);
        m[5] = wz.mul_add(z, m[5]);
        m[6] -= wx;
        m[7] -= wy;
        m[8] -= wz;
        m[9] += weight;
    }

    /// The sum of two matrices.
    #[inline(always)]
    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = *self;
        for (entry, term) in sum.0.iter_mut().zip(&other.0) {
            *entry += *term;
        }
        sum
    }

    /// An entry.
    #[inline(always)]
    pub fn at(&self, row: usize, column: usize) -> Lane<S> {
        self.0[PLACES[row][column]]
    }

    /// Product with a vector in R^4.
    #[inline(always)]
    pub fn times(&self, vector: &[Lane<S>; 4]) -> [Lane<S>; 4] {
        array!(|row| {
            let head = self.at(row, 0).mul_add(vector[0], self.at(row, 1) * vector[1]);
            self.at(row, 2).mul_add(vector[2], self.at(row, 3).mul_add(vector[3], head))
        })
    }

    /// Product with a vector in R^3, extended by a zero.
    #[inline(always)]
    pub fn times_point(&self, vector: &Vector<S>) -> [Lane<S>; 4] {
        array!(|row| {
            self.at(row, 0).mul_add(vector[0], self.at(row, 1).mul_add(vector[1], self.at(row, 2) * vector[2]))
        })
    }

    /// The factors of `L D L'`, without pivoting because the matrix is positive definite.
    #[inline(always)]
    pub fn factorise(&self) -> Factors<S> {
        let m = &self.0;
        let d0 = m[0].recip();
        let (l10, l20, l30) = (m[1] * d0, m[2] * d0, m[6] * d0);
        let a11 = l10.mul_sub_from(m[1], m[3]);
        let a21 = l10.mul_sub_from(m[2], m[4]);
        let a31 = l10.mul_sub_from(m[6], m[7]);
        let a22 = l20.mul_sub_from(m[2], m[5]);
        let a32 = l20.mul_sub_from(m[6], m[8]);
        let a33 = l30.mul_sub_from(m[6], m[9]);
        let d1 = a11.recip();
        let (l21, l31) = (a21 * d1, a31 * d1);
        let b22 = l21.mul_sub_from(a21, a22);
        let b32 = l21.mul_sub_from(a31, a32);
        let b33 = l31.mul_sub_from(a31, a33);
        let d2 = b22.recip();
        let l32 = b32 * d2;
        let d3 = l32.mul_sub_from(b32, b33).recip();
        Factors { l10, l20, l30, l21, l31, l32, inverse_pivots: [d0, d1, d2, d3] }
    }
}

/// The factors of `L D L'` of [`Moments`].
pub struct Factors<S: Simd> {
    l10: Lane<S>,
    l20: Lane<S>,
    l30: Lane<S>,
    l21: Lane<S>,
    l31: Lane<S>,
    l32: Lane<S>,
    inverse_pivots: [Lane<S>; 4],
}

impl<S: Simd> Factors<S> {
    /// Solves for one right-hand side.
    #[inline(always)]
    pub fn solve(&self, b: [Lane<S>; 4]) -> [Lane<S>; 4] {
        let y0 = b[0];
        let y1 = self.l10.mul_sub_from(y0, b[1]);
        let y2 = self.l21.mul_sub_from(y1, self.l20.mul_sub_from(y0, b[2]));
        let y3 = self.l32.mul_sub_from(y2, self.l31.mul_sub_from(y1, self.l30.mul_sub_from(y0, b[3])));
        let [d0, d1, d2, d3] = self.inverse_pivots;
        let x3 = y3 * d3;
        let x2 = self.l32.mul_sub_from(x3, y2 * d2);
        let x1 = self.l21.mul_sub_from(x2, self.l31.mul_sub_from(x3, y1 * d1));
        let x0 = self.l10.mul_sub_from(x1, self.l20.mul_sub_from(x2, self.l30.mul_sub_from(x3, y0 * d0)));
        [x0, x1, x2, x3]
    }
}

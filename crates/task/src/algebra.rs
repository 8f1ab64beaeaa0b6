//! Small linear algebra that is generic over the number type, so that each equation is written once.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::SMatrix;

/// The number type of an equation: `f64`, or an expression that is recorded for its derivatives.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self> + Neg<Output = Self>
{
}

impl<T> Number for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Mul<f64, Output = T> + Neg<Output = T>
{
}

/// Euclidean length of a vector.
pub fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|component| component * component).sum::<f64>().sqrt()
}

/// A square matrix times a vector.
pub fn apply<T: Number, const N: usize>(matrix: &SMatrix<f64, N, N>, vector: &[T]) -> [T; N] {
    std::array::from_fn(|row| {
        (1..N).fold(vector[0] * matrix[(row, 0)], |sum, column| sum + vector[column] * matrix[(row, column)])
    })
}

/// Inner product of two vectors of the same length, at least one.
pub fn dot<T: Number>(left: &[T], right: &[T]) -> T {
    left.iter().zip(right).skip(1).fold(left[0] * right[0], |sum, (&a, &b)| sum + a * b)
}

/// Cross product of two vectors of three components.
pub fn cross<T: Number>(left: &[T], right: &[T]) -> [T; 3] {
    let minor = |one: usize, other: usize| left[one] * right[other] - left[other] * right[one];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The matrix `R(xi)` of a quaternion (w x y z) of any norm: `|xi|^2` times a rotation matrix.
pub fn rotation<T: Number>(quaternion: &[T]) -> [[T; 3]; 3] {
    let [w, x, y, z] = [quaternion[0], quaternion[1], quaternion[2], quaternion[3]];
    let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
    [
        [ww + xx - yy - zz, (x * y - w * z) * 2.0, (x * z + w * y) * 2.0],
        [(x * y + w * z) * 2.0, ww - xx + yy - zz, (y * z - w * x) * 2.0],
        [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, ww - xx - yy + zz],
    ]
}

/// Hamilton product of two quaternions (w x y z).
pub fn product<T: Number>(left: &[T], right: &[T]) -> [T; 4] {
    let ([a, b, c, d], [e, f, g, h]) = ([left[0], left[1], left[2], left[3]], [right[0], right[1], right[2], right[3]]);
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// Conjugate of a quaternion (w x y z): the inverse of one of unit norm.
pub fn conjugate<T: Number>(quaternion: &[T]) -> [T; 4] {
    [quaternion[0], -quaternion[1], -quaternion[2], -quaternion[3]]
}

//! One semi-implicit Euler step of a rigid body under the impedance law, for numbers and for tape expressions.

use autodiff::Expression;

/// Previous state, state and reference state, each (position, quaternion, velocity, angular velocity).
pub const INPUTS: usize = 39;
/// Defects of position, quaternion, velocity and angular velocity.
pub const OUTPUTS: usize = 13;
pub const TIME_STEP: f64 = 0.04;
/// Offset of the compliant frame, in m.
pub const OFFSET: [f64; 3] = [0.01, -0.02, 0.005];
/// Translational stiffness and damping for 1 kg.
pub const STIFFNESS: f64 = 50.0;
pub const DAMPING: f64 = 14.0;
/// Twice the rotational stiffness, and rotational damping, both over 0.1 kg m^2.
pub const ROTATIONAL_STIFFNESS: f64 = 100.0;
pub const ROTATIONAL_DAMPING: f64 = 14.0;

/// Scalars that the step can be computed with.
pub trait Scalar:
    Copy
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Mul<f64, Output = Self>
{
}
impl Scalar for f64 {}
impl Scalar for Expression<'_> {}

pub fn step<T: Scalar>(x: &[T]) -> [T; OUTPUTS] {
    let (last, now, reference) = (&x[..13], &x[13..26], &x[26..39]);
    let [w, i, j, k] = [now[3], now[4], now[5], now[6]];
    let [a, b, c, d] = [reference[3], reference[4], reference[5], reference[6]];
    let [p, q, r] = [now[10], now[11], now[12]];
    let rates = [(i * p + j * q + k * r) * -1.0, w * p + j * r - k * q, w * q + k * p - i * r, w * r + i * q - j * p];
    let [o, m, n] = OFFSET;
    let (ww, ii, jj, kk) = (w * w, i * i, j * j, k * k);
    let arm = [
        (ww + ii - jj - kk) * o + (i * j - w * k) * (2.0 * m) + (i * k + w * j) * (2.0 * n),
        (i * j + w * k) * (2.0 * o) + (ww - ii + jj - kk) * m + (j * k - w * i) * (2.0 * n),
        (i * k - w * j) * (2.0 * o) + (j * k + w * i) * (2.0 * m) + (ww - ii - jj + kk) * n,
    ];
    let scalar = w * a + i * b + j * c + k * d;
    let vector = [w * b - i * a - j * d + k * c, w * c + i * d - j * a - k * b, w * d - i * c + j * b - k * a];
    std::array::from_fn(|row| match row {
        0..3 => now[row] - last[row] - now[7 + row] * TIME_STEP,
        3..7 => now[row] - last[row] - rates[row - 3] * (0.5 * TIME_STEP),
        7..10 => {
            let axis = row - 7;
            let force = (reference[axis] - now[axis] - arm[axis]) * STIFFNESS + (reference[row] - now[row]) * DAMPING;
            now[row] - last[row] - force * TIME_STEP
        }
        _ => {
            let torque =
                scalar * vector[row - 10] * ROTATIONAL_STIFFNESS + (reference[row] - now[row]) * ROTATIONAL_DAMPING;
            now[row] - last[row] - torque * TIME_STEP
        }
    })
}

/// Inputs and multipliers of a point.
pub fn sample(point: usize) -> [f64; INPUTS + OUTPUTS] {
    std::array::from_fn(|row| ((row * 7 + point * 3) as f64 * 0.618).fract() - 0.5)
}

//! Numbers with as many digits as a page can show: they are most of its size.

/// Decimals of positions (m) and distances: a micrometre.
pub const LENGTH: i32 = 6;
/// Decimals of quaternions, unit vectors and angles (rad).
pub const ANGLE: i32 = 5;
/// Decimals of forces (N) and torques (Nm).
pub const FORCE: i32 = 3;

/// A number with `decimals` decimals.
pub fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10_f64.powi(decimals);
    // Without negative zeros.
    (value * scale).round() / scale + 0.0
}

/// Several numbers, each rounded.
pub fn all<const N: usize>(values: [f64; N], decimals: i32) -> [f64; N] {
    values.map(|value| rounded(value, decimals))
}

/// Position and quaternion.
pub fn pose(pose: &[f64]) -> impl Iterator<Item = f64> + '_ {
    pose.iter().enumerate().map(|(index, &value)| rounded(value, if index < 3 { LENGTH } else { ANGLE }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_what_is_visible() {
        assert_eq!(rounded(0.123_456_789, LENGTH), 0.123_457);
        assert_eq!(rounded(-1e-9, LENGTH).to_bits(), 0.0_f64.to_bits());
        assert!(rounded(f64::NAN, FORCE).is_nan());
    }
}

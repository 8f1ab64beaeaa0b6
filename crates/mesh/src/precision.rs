//! How precise the coordinates of a file are.

use crate::geometry::{Vector, bounds};

/// Files with fewer digits than this, relative to the size of the part, have round numbers rather than rounded ones.
const COARSEST: f64 = 1e-5;
/// Finer digits drown in the arithmetic.
const FINEST: f64 = 1e-10;

/// Largest error of coordinates in single precision.
pub fn single(vertices: &[[f64; 3]]) -> f64 {
    let largest = vertices.as_flattened().iter().fold(0.0, |largest: f64, coordinate| largest.max(coordinate.abs()));
    0.5 * f64::from(f32::EPSILON) * largest
}

/// Half of the last digit of the coordinates in lines that begin with a keyword.
pub fn of_text(bytes: &[u8], keyword: &str) -> f64 {
    let text = String::from_utf8_lossy(bytes);
    let mut decimals: Option<i32> = None;
    let mut exponential: Option<(i32, i32)> = None;
    for line in text.lines() {
        let mut words = line.split_whitespace();
        if words.next() != Some(keyword) {
            continue;
        }
        for word in words.take(3) {
            let (mantissa, exponent) = word.split_once(['e', 'E']).unwrap_or((word, ""));
            let digits = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len().min(99) as i32);
            match exponent.parse::<i32>() {
                Ok(exponent) => {
                    let (largest, longest) = exponential.unwrap_or((exponent, digits));
                    exponential = Some((largest.max(exponent.clamp(-99, 99)), longest.max(digits)));
                }
                Err(_) => decimals = Some(decimals.unwrap_or(0).max(digits)),
            }
        }
    }
    let fixed = decimals.map_or(0.0, |digits| 10f64.powi(-digits));
    let floating = exponential.map_or(0.0, |(exponent, digits)| 10f64.powi(exponent - digits));
    // Of a mixture, the fixed ones are those for which that was precise enough.
    0.5 * if exponential.is_some() { floating } else { fixed }
}

/// A rounding (m) within what makes sense for the size of the part.
pub fn reasonable(rounding: f64, vertices: &[Vector]) -> f64 {
    let [low, high] = bounds(vertices);
    let size = (high - low).amax();
    let largest = low.amax().max(high.amax());
    let rounding = if rounding.is_finite() { rounding } else { 0.0 };
    rounding.min(COARSEST * size).max(f64::EPSILON * largest).max(FINEST * size)
}

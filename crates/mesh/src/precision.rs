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

/// The digits of the coordinates in a text.
#[derive(Debug, Default)]
pub struct Digits {
    /// Most digits after the point of numbers without exponents.
    decimals: Option<i32>,
    /// Largest exponent, and most digits after the point of numbers with exponents.
    exponential: Option<(i32, i32)>,
}

impl Digits {
    /// Notes those of a number.
    pub fn note(&mut self, word: &[u8]) {
        let exponent = word.iter().position(|byte| matches!(byte, b'e' | b'E'));
        let (mantissa, exponent) = word.split_at(exponent.unwrap_or(word.len()));
        let point = mantissa.iter().position(|byte| *byte == b'.');
        let digits = point.map_or(0, |point| (mantissa.len() - point - 1).min(99) as i32);
        let exponent = exponent.get(1..).and_then(|exponent| str::from_utf8(exponent).ok()?.parse::<i32>().ok());
        match exponent {
            Some(exponent) => {
                let (largest, longest) = self.exponential.unwrap_or((exponent, digits));
                self.exponential = Some((largest.max(exponent.clamp(-99, 99)), longest.max(digits)));
            }
            None => self.decimals = Some(self.decimals.unwrap_or(0).max(digits)),
        }
    }

    /// Half of the last digit. Of a mixture, the fixed ones are those for which that was precise enough.
    pub fn rounding(&self) -> f64 {
        let fixed = self.decimals.map_or(0.0, |digits| 10f64.powi(-digits));
        0.5 * self.exponential.map_or(fixed, |(exponent, digits)| 10f64.powi(exponent - digits))
    }
}

/// The coarsest rounding (m) that makes sense for the size of the part.
pub fn coarsest(vertices: &[Vector]) -> f64 {
    let [low, high] = bounds(vertices);
    COARSEST * (high - low).amax()
}

/// A rounding (m) within what makes sense for the size of the part.
pub fn reasonable(rounding: f64, vertices: &[Vector]) -> f64 {
    let [low, high] = bounds(vertices);
    let size = (high - low).amax();
    let largest = low.amax().max(high.amax());
    let rounding = if rounding.is_finite() { rounding } else { 0.0 };
    rounding.min(COARSEST * size).max(f64::EPSILON * largest).max(FINEST * size)
}

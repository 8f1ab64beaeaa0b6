//! Positions, orientations and numbers with a range.

use std::fmt::Display;

use toml::Spanned;

use crate::error::{SceneError, Source};

/// How far the norm of a quaternion or direction may be from 1: files are written with few digits.
const NORM_TOLERANCE: f64 = 1e-3;

/// A finite position (m).
pub fn position(source: Source, position: &Spanned<[f64; 3]>) -> Result<[f64; 3], SceneError> {
    let value = *position.get_ref();
    if value.iter().any(|coordinate| !coordinate.is_finite()) {
        return Err(source.error(position.span(), "a position has three finite numbers (m)"));
    }
    Ok(value)
}

/// A unit quaternion (w x y z), scaled to exact norm.
pub fn orientation(source: Source, orientation: &Spanned<[f64; 4]>) -> Result<[f64; 4], SceneError> {
    let value = *orientation.get_ref();
    let norm = norm(&value);
    if !is_unit(norm) {
        let message = format!("an orientation is a unit quaternion [w, x, y, z]; this one has norm {norm:.4}");
        return Err(source.error(orientation.span(), message));
    }
    Ok(value.map(|component| component / norm))
}

/// A unit direction, or zero for the nominal scenario; kept as written.
pub fn direction(source: Source, direction: &Spanned<[f64; 3]>) -> Result<[f64; 3], SceneError> {
    let value = *direction.get_ref();
    let norm = norm(&value);
    if norm != 0.0 && !is_unit(norm) {
        let message = format!("an offset direction has norm 1, or is [0, 0, 0]; this one has norm {norm:.4}");
        return Err(source.error(direction.span(), message));
    }
    Ok(value)
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|component| component * component).sum::<f64>().sqrt()
}

fn is_unit(norm: f64) -> bool {
    (norm - 1.0).abs() <= NORM_TOLERANCE
}

/// A value that satisfies a condition, said in words.
pub fn within<T: Copy + Display>(
    source: Source,
    key: &str,
    value: &Spanned<T>,
    condition: impl Fn(T) -> bool,
    words: &str,
) -> Result<T, SceneError> {
    let number = *value.get_ref();
    if condition(number) {
        return Ok(number);
    }
    Err(source.error(value.span(), format!("{key} = {number}: {words}")))
}

/// A finite number above zero.
pub fn positive(source: Source, key: &str, value: &Spanned<f64>) -> Result<f64, SceneError> {
    within(source, key, value, |number| number > 0.0 && number.is_finite(), "must be positive")
}

/// A finite number that is not negative.
pub fn not_negative(source: Source, key: &str, value: &Spanned<f64>) -> Result<f64, SceneError> {
    within(source, key, value, |number| number >= 0.0 && number.is_finite(), "must not be negative")
}

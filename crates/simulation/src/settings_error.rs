//! Values outside of their range.

use std::ops::RangeInclusive;

/// A value with which a rollout cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{field} = {}: must lie in {}", quantity(plain(*value), unit), quantity(interval(range), unit))]
pub struct SettingsError {
    /// Name of the field.
    pub field: &'static str,
    /// Its value.
    pub value: f64,
    /// Smallest and largest value allowed.
    pub range: [f64; 2],
    /// Unit of all three, empty where there is none.
    pub unit: &'static str,
}

/// Refuses a value outside of a range; NaN is outside of every range.
pub fn check(
    field: &'static str,
    value: f64,
    range: &RangeInclusive<f64>,
    unit: &'static str,
) -> Result<(), SettingsError> {
    if range.contains(&value) {
        return Ok(());
    }
    Err(SettingsError { field, value, range: [*range.start(), *range.end()], unit })
}

/// A value without trailing zeros: `600`, `1e-6`, `1e300`.
fn plain(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

fn interval([least, most]: &[f64; 2]) -> String {
    format!("[{}, {}]", plain(*least), plain(*most))
}

fn quantity(value: String, unit: &str) -> String {
    if unit.is_empty() { value } else { format!("{value} {unit}") }
}

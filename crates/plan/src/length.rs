//! Lengths as people read them.

use std::fmt;

/// A length (m) as a number of millimetres: with one decimal, and from 1 mm down with at least two digits. The width of a
/// format is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Millimetres(pub f64);

/// Shorter lengths (m) are rounding.
const NOTHING: f64 = 5e-10;

/// Decimals of a length (m) in millimetres.
pub fn decimals(length: f64) -> usize {
    match length.abs() {
        size if !(NOTHING..1e-3).contains(&size) => 1,
        size if size >= 1e-4 => 2,
        size if size >= 1e-5 => 3,
        _ => 4,
    }
}

impl fmt::Display for Millimetres {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let (width, decimals) = (formatter.width().unwrap_or_default(), decimals(self.0));
        // Without negative zeros.
        let length = if self.0.abs() < NOTHING { 0.0 } else { 1e3 * self.0 };
        write!(formatter, "{length:width$.decimals$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_below_a_millimetre_keep_their_digits() {
        for (length, text) in [
            (0.02, "20.0"),
            (0.0012, "1.2"),
            (8e-4, "0.80"),
            (1.6e-4, "0.16"),
            (4e-5, "0.040"),
            (2.5e-6, "0.0025"),
            (0.0, "0.0"),
            (-0.0, "0.0"),
            (-1.6e-4, "-0.16"),
            (1e-13, "0.0"),
        ] {
            assert_eq!(Millimetres(length).to_string(), text);
        }
        assert_eq!(format!("{:>7}|{:5}", Millimetres(8e-4), Millimetres(0.02)), "   0.80| 20.0");
    }
}

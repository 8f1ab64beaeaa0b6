//! Clearances by the names of fits.

/// A fit of a hole and a shaft of one nominal diameter, such as `H7/h6`, by ISO 286-2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Smallest clearance (m).
    pub least: f64,
    /// Largest clearance (m).
    pub most: f64,
}

/// Why a fit has no clearance that is known.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// Not of the form `H7/h6`.
    #[error("`{0}` is not a fit such as H7/g6: a hole D to H, a shaft d to h, each with a grade from 4 to 12")]
    Form(String),
    /// A diameter that the tables do not have.
    #[error("a diameter of {0} mm is not between 1 and 500 mm, for which ISO 286 has clearance fits here")]
    Diameter(f64),
}

/// Largest diameter of each step (mm).
const STEPS: [f64; 13] = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];
/// Standard tolerances of the grades 4 to 12 (micrometres) for each step.
const GRADES: [[u16; 13]; 9] = [
    [3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20],
    [4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27],
    [6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40],
    [10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63],
    [14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97],
    [25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155],
    [40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250],
    [60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400],
    [100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630],
];
/// Distance of the tolerance zones d to h, and D to H, from the nominal diameter (micrometres).
const DEVIATIONS: [(char, [u16; 13]); 5] = [
    ('d', [20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230]),
    ('e', [14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135]),
    ('f', [6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68]),
    ('g', [2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20]),
    ('h', [0; 13]),
];

impl Fit {
    /// A clearance fit by its name and nominal diameter (m).
    ///
    /// # Errors
    /// When the name is not that of a clearance fit, or the diameter is out of range.
    pub fn new(name: &str, diameter: f64) -> Result<Self, FitError> {
        let form = || FitError::Form(name.to_owned());
        let (hole, shaft) = name.trim().split_once('/').ok_or_else(form)?;
        let millimetres = 1e3 * diameter;
        if !(1.0..=500.0).contains(&millimetres) {
            return Err(FitError::Diameter(millimetres));
        }
        let step = STEPS.iter().position(|&most| millimetres <= most).ok_or(FitError::Diameter(millimetres))?;
        let hole = Zone::new(hole, char::is_ascii_uppercase, step).ok_or_else(form)?;
        let shaft = Zone::new(shaft, char::is_ascii_lowercase, step).ok_or_else(form)?;
        let least = hole.deviation + shaft.deviation;
        Ok(Self { least: 1e-6 * f64::from(least), most: 1e-6 * f64::from(least + hole.tolerance + shaft.tolerance) })
    }
}

/// A tolerance zone (micrometres).
struct Zone {
    deviation: u16,
    tolerance: u16,
}

impl Zone {
    fn new(name: &str, is_of_kind: fn(&char) -> bool, step: usize) -> Option<Self> {
        let letter = name.chars().next().filter(is_of_kind)?;
        let (_, deviations) = DEVIATIONS.iter().find(|(known, _)| *known == letter.to_ascii_lowercase())?;
        let grade: usize = name[1..].parse().ok()?;
        let tolerances = GRADES.get(grade.checked_sub(4)?)?;
        Some(Self { deviation: deviations[step], tolerance: tolerances[step] })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fits_are_those_of_the_standard() {
        let micrometres = |name: &str, diameter: f64| {
            let Fit { least, most } = Fit::new(name, diameter).unwrap();
            [least, most].map(|clearance| (1e6 * clearance).round())
        };
        assert_eq!(micrometres("H7/h6", 0.010), [0.0, 24.0]);
        assert_eq!(micrometres("H7/g6", 0.025), [7.0, 41.0]);
        assert_eq!(micrometres("H8/f7", 0.050), [25.0, 89.0]);
        assert_eq!(micrometres("G7/h6", 0.012), [6.0, 35.0]);
        assert_eq!(micrometres("H11/d9", 0.100), [120.0, 427.0]);
    }

    #[test]
    fn other_names_and_diameters_are_refused() {
        for name in ["H7", "h7/H6", "H7/p6", "H7/h", "H3/h6", "H99/h6", "", "/", "Ä7/h6", "H7/é6"] {
            assert!(matches!(Fit::new(name, 0.01), Err(FitError::Form(_))), "{name}");
        }
        for diameter in [0.0, 0.6, f64::NAN, -0.01] {
            assert!(matches!(Fit::new("H7/h6", diameter), Err(FitError::Diameter(_))), "{diameter}");
        }
    }
}

//! Directions in words.

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];
/// Components of a direction that are smaller than this share of the largest are not named.
const MINOR: f64 = 0.5;

/// A direction in words, such as `-z` or `+x and -z`; `None` for a vector without length.
pub fn direction(vector: &[f64; 3]) -> Option<String> {
    let largest = vector.iter().fold(0.0, |largest: f64, component| largest.max(component.abs()));
    let is_named = |component: f64| component.abs() > MINOR * largest;
    let named = (0..3).filter(|&axis| is_named(vector[axis]));
    let names = named.map(|axis| format!("{}{}", if vector[axis] < 0.0 { "-" } else { "+" }, AXES[axis]));
    let names: Vec<String> = names.collect();
    (largest > 0.0 && largest.is_finite()).then(|| names.join(" and "))
}

/// An axis in words: the axis of the world along a unit vector, else the vector.
pub fn axis_name(direction: &[f64; 3]) -> String {
    /// Cosine of the largest angle to an axis of the world that gives a direction its name.
    const ALONG: f64 = 0.9999;
    match (0..3).find(|&axis| direction[axis].abs() > ALONG) {
        Some(axis) => AXES[axis].to_owned(),
        None => format!("({})", direction.map(|component| format!("{component:.2}")).join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_name_the_axes_that_matter() {
        assert_eq!(direction(&[0.0, 0.1, -1.0]).unwrap(), "-z");
        assert_eq!(direction(&[0.7, 0.0, -0.7]).unwrap(), "+x and -z");
        assert_eq!(direction(&[0.0; 3]), None);
        assert_eq!(direction(&[f64::NAN; 3]), None);
        assert_eq!(axis_name(&[0.0, -1.0, 0.001]), "y");
        assert_eq!(axis_name(&[0.6, -0.8, 0.0]), "(0.60, -0.80, 0.00)");
    }
}

//! Time that Ipopt spent in its linear solver, from the statistics it writes at the end of a solve.

use std::path::Path;

use crate::solution::Timing;

/// Adds the wall times of factorisations and solves that stand in Ipopt's output file.
pub fn read(file: &Path, timing: &mut Timing) {
    let Ok(text) = std::fs::read_to_string(file) else { return };
    let seconds = |label: &str| text.lines().find_map(|line| wall_seconds(line, label)).unwrap_or(0.0);
    timing.factorization = seconds("LinearSystemFactorization");
    timing.back_substitution = seconds("LinearSystemBackSolve");
}

/// Reads lines such as `label....:  1.0 (sys:  0.0 wall:  2.0)`.
fn wall_seconds(line: &str, label: &str) -> Option<f64> {
    let rest = line.trim_start().strip_prefix(label)?;
    let wall = rest.split("wall:").nth(1)?;
    wall.trim().trim_end_matches(')').trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wall_time_is_read_from_a_line_of_statistics() {
        let line = " LinearSystemFactorization..........:      0.412 (sys:      0.003 wall:      0.420)";
        assert_eq!(wall_seconds(line, "LinearSystemFactorization"), Some(0.42));
        assert_eq!(wall_seconds(line, "LinearSystemBackSolve"), None);
    }
}

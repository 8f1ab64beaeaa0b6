//! The time that Ipopt spent in its linear solver, from the statistics that it writes at the end of a solve.

use std::path::Path;

/// Ipopt's label of the time in factorisations and solves of the KKT system.
const LABEL: &str = "StdAugSystemSolverMultiSolve";

/// Wall seconds in factorisations and solves according to Ipopt's output file; 0 when they are not in it.
pub fn linear_solver_seconds(file: &Path) -> f64 {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    text.lines().find_map(|line| wall_seconds(line, LABEL)).unwrap_or(0.0)
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
        let line = " StdAugSystemSolverMultiSolve.......:      0.412 (sys:      0.003 wall:      0.420)";
        assert_eq!(wall_seconds(line, LABEL), Some(0.42));
        assert_eq!(wall_seconds(line, "OverallAlgorithm"), None);
    }
}

//! Parts that are size on size.

use plan::Problem;

/// Largest clearance from side to side (m) that counts as zero.
const ZERO: f64 = 1e-7;

/// Whether a clearance (m) from side to side counts as zero.
pub fn is_size_on_size(clearance: f64) -> bool {
    clearance.abs() <= ZERO
}

/// A warning about parts without clearance. Those that penetrate at the goal have one of their own.
pub fn warning(problem: &Problem) -> Option<String> {
    problem.engagement().clearance_m.filter(|&clearance| is_size_on_size(clearance)).map(|_| {
        "the parts have no clearance where the environment guides the body, so that no offset can be tolerated: where CAD is size on \
         size, state the fit by `clearance` of a mesh"
            .to_owned()
    })
}

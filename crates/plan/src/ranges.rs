//! Ranges of choices, from any source.

use crate::error::PlannerError;

/// Largest friction coefficient that means anything.
const LARGEST_FRICTION: f64 = 10.0;
/// More frictions than anyone needs.
const MOST_FRICTIONS: usize = 20;
/// More threads than any machine has.
const MOST_THREADS: usize = 1024;

/// Checks friction coefficients: at least one, finite, each once.
pub fn require_frictions(frictions: &[f64]) -> Result<(), PlannerError> {
    require(
        (1..=MOST_FRICTIONS).contains(&frictions.len()),
        "number of frictions",
        frictions.len(),
        "must be 1 to 20",
    )?;
    for (index, friction) in frictions.iter().enumerate() {
        require((0.0..=LARGEST_FRICTION).contains(friction), "friction", friction, "must lie between 0 and 10")?;
        require(!frictions[..index].contains(friction), "friction", friction, "is given twice")?;
    }
    Ok(())
}

/// Checks a rotation error of the part in the gripper.
pub fn require_rotation_error(rotation_error: f64) -> Result<(), PlannerError> {
    require((0.0..=1.57).contains(&rotation_error), "rotation_error", rotation_error, "must lie between 0 and 1.57 rad")
}

/// Checks a number of threads.
pub fn require_threads(threads: usize) -> Result<(), PlannerError> {
    require((1..=MOST_THREADS).contains(&threads), "threads", threads, "must lie between 1 and 1024")
}

/// An error about a value unless a rule holds.
pub fn require(holds: bool, name: &'static str, value: impl ToString, rule: &str) -> Result<(), PlannerError> {
    if holds { Ok(()) } else { Err(PlannerError::value(name, value, rule)) }
}

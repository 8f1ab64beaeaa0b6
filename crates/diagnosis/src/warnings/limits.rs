//! Whether a plan keeps its limits, in words.

use task::Limits;

/// By how much the solver may exceed a limit without a warning, in units of the limit.
const ABSOLUTE_TOLERANCE: f64 = 1e-4;
/// The same as a fraction of the limit; both are added.
const RELATIVE_TOLERANCE: f64 = 1e-3;

/// Limits that a plan does not keep.
pub fn warnings(limits: &Limits, reached: &Limits) -> Vec<String> {
    let both = limits.named().into_iter().zip(reached.named());
    both.map(|((name, unit, limit), (_, _, value))| (name, unit, limit, value))
        .filter(|&(_, _, limit, value)| value > limit * (1.0 + RELATIVE_TOLERANCE) + ABSOLUTE_TOLERANCE)
        .map(|(name, unit, limit, value)| {
            format!(
                "limits.{name} = {limit} is not kept: the plan reaches {value:.4} {unit}; allow more, or give [horizon] \
                 more steps"
            )
        })
        .collect()
}

//! Whether a plan keeps its limits, in words.

use task::Limits;

/// What the solver may exceed a limit by without being told of (in units of the limit, and as a part of it).
const TOLERANCE: (f64, f64) = (1e-4, 1e-3);

/// How much of every limit a plan uses; `None` when there are no limits.
pub fn summary(limits: &Limits, reached: &Limits) -> Option<String> {
    let used = pairs(limits, reached).map(|(name, unit, limit, value)| format!("{name} {value:.4} of {limit} {unit}"));
    let used: Vec<String> = used.collect();
    (!used.is_empty()).then(|| format!("  limits: {}", used.join(", ")))
}

/// Limits that a plan does not keep.
pub fn warnings(limits: &Limits, reached: &Limits) -> Vec<String> {
    let (absolute, relative) = TOLERANCE;
    pairs(limits, reached)
        .filter(|&(_, _, limit, value)| value > limit * (1.0 + relative) + absolute)
        .map(|(name, unit, limit, value)| {
            format!(
                "limits.{name} = {limit} is not kept: the plan reaches {value:.4} {unit}; allow more, or give [horizon] \
                 more steps"
            )
        })
        .collect()
}

/// Name, unit, limit and value reached of everything that is limited.
fn pairs(limits: &Limits, reached: &Limits) -> impl Iterator<Item = (&'static str, &'static str, f64, f64)> {
    let both = limits.named().into_iter().zip(reached.named());
    both.map(|((name, unit, limit), (_, _, value))| (name, unit, limit, value)).filter(|pair| pair.2.is_finite())
}

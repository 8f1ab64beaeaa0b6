//! The best of several references, found with few rollouts.

use simulation::{Evaluator, Reference, Trial, TrialResult};

/// Trials in which all references are played at first. Half of them are then dropped, and the others are played in twice
/// as many (successive halving).
const FIRST: usize = 6;

/// How the best reference did.
pub struct Winner {
    /// Its index.
    pub index: usize,
    /// Its results, in the order of the trials.
    pub results: Vec<TrialResult>,
    /// Rollouts that the race took.
    pub rollouts: usize,
}

/// The reference that passes most trials; of equals the later one. `None` without references, or when `stop` returns true
/// before the end. The first trials speak for all.
pub fn race(
    evaluator: &Evaluator,
    references: &[Reference],
    trials: &[Trial],
    threads: usize,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<Winner> {
    let mut running: Vec<(usize, Vec<TrialResult>)> = (0..references.len()).map(|index| (index, Vec::new())).collect();
    let (mut played, mut rollouts) = (0, 0);
    while running.len() > 1 || played < trials.len() {
        let wanted = if running.len() > 1 { (2 * played).max(FIRST).min(trials.len()) } else { trials.len() };
        for (index, results) in &mut running {
            results.extend(evaluator.evaluate_all(&references[*index], &trials[played..wanted], threads, stop)?);
            rollouts += wanted - played;
        }
        played = wanted;
        let failures = |results: &[TrialResult]| results.iter().filter(|result| !result.passed).count();
        running.sort_by_key(|(index, results)| (failures(results), std::cmp::Reverse(*index)));
        let kept = if played < trials.len() { running.len().div_ceil(2) } else { 1 };
        running.truncate(kept);
    }
    let (index, results) = running.pop()?;
    Some(Winner { index, results, rollouts })
}

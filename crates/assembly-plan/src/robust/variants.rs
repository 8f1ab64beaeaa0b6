//! What is planned, round by round: the scene as it is, then problems whose plans are known to have more margin.

use ocp::AssemblyTask;
use simulation::offsets;

/// A planning problem and what makes it differ from the scene's own.
pub struct Variant {
    pub task: AssemblyTask,
    /// In words.
    pub name: &'static str,
}

/// Failing offsets that a round takes over as scenarios.
const ADDED_FAILURES: usize = 3;

/// Number of variants.
pub const VARIANTS: usize = 4;

/// The variant of a round, counted from 0. `failing` are offsets (m) at which the best plan so far fails.
pub fn variant(task: &AssemblyTask, round: usize, failing: &[[f64; 3]]) -> Variant {
    let mut task = task.clone();
    let name = match round {
        0 => "the scene as it is",
        1 => {
            task.offsets.extend(spread(failing, ADDED_FAILURES));
            "failing offsets as scenarios"
        }
        2 => {
            let half = task.offsets.iter().map(|offset| offset.map(|component| 0.5 * component)).collect::<Vec<_>>();
            task.offsets.push([0.0; 3]);
            task.offsets.extend(half);
            "no offset and half offsets as scenarios"
        }
        _ => {
            task.horizon.steps *= 2;
            "twice the time"
        }
    };
    task.offsets = offsets::distinct(&task.offsets);
    Variant { task, name }
}

/// Some of the offsets, each as far from those before it as possible.
fn spread(offsets: &[[f64; 3]], count: usize) -> Vec<[f64; 3]> {
    let distance = |one: &[f64; 3], other: &[f64; 3]| (0..3).map(|axis| (one[axis] - other[axis]).powi(2)).sum::<f64>();
    let mut chosen: Vec<[f64; 3]> = offsets.first().copied().into_iter().collect();
    while chosen.len() < count.min(offsets.len()) {
        let nearest =
            |offset: &[f64; 3]| chosen.iter().map(|other| distance(offset, other)).fold(f64::INFINITY, f64::min);
        chosen.extend(offsets.iter().copied().max_by(|one, other| nearest(one).total_cmp(&nearest(other))));
    }
    offsets::distinct(&chosen)
}

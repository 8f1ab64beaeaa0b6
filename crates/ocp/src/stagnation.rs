//! Warm starts that stagnate.
//!
//! A warm start may lie so close to its bounds that they cut every step short, for hundreds of iterations. With a
//! larger barrier parameter, the same start is free to leave them.

use nlp::Progress;

/// Consecutive short steps that count as stagnation.
const STEPS: usize = 40;
/// Primal steps are short below this fraction of the full one.
const SHORT: f64 = 0.1;
/// Factor of the barrier parameter after stagnation.
pub const WIDER: f64 = 30.0;

/// Watches the steps of one solve.
#[derive(Debug, Default)]
pub struct Stagnation {
    short_steps: usize,
}

impl Stagnation {
    /// Records an iteration.
    pub fn see(&mut self, progress: &Progress) {
        if self.is_found() {
            return;
        }
        let is_short = progress.iteration > 0 && progress.alpha_primal < SHORT && !progress.restoration;
        self.short_steps = if is_short { self.short_steps + 1 } else { 0 };
    }

    /// Whether the solve stagnates.
    pub fn is_found(&self) -> bool {
        self.short_steps >= STEPS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_short_steps_in_a_row_are_stagnation() {
        let step = |iteration: usize, alpha_primal: f64| Progress {
            iteration,
            objective: 1.0,
            primal_infeasibility: 1e-2,
            dual_infeasibility: 1.0,
            mu: 1e-3,
            step_norm: 1.0,
            regularization: 0.0,
            alpha_dual: 1.0,
            alpha_primal,
            line_search_trials: 1,
            restoration: false,
        };
        let sees = |longer: Option<usize>| {
            let mut stagnation = Stagnation::default();
            // Ipopt reports no step before the first.
            (0..=STEPS).for_each(|index| stagnation.see(&step(index, if Some(index) == longer { 1.0 } else { 1e-3 })));
            stagnation.is_found()
        };
        assert!(sees(None) && !sees(Some(STEPS / 2)) && !sees(Some(STEPS)) && sees(Some(0)));
    }
}

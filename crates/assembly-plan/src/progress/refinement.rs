//! Progress of `solve --robust`.

use std::sync::{Mutex, PoisonError};

use planner::Event;

/// A refinement according to its events.
#[derive(Default)]
pub struct Refinement {
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    /// The present plan or variant, in words.
    planned: Option<String>,
    /// Success rate of the best plan.
    best: Option<f64>,
}

impl Refinement {
    /// Records an event.
    pub fn note(&self, event: &Event) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        match event {
            Event::Evaluated { rate } | Event::Refined { rate } => {
                state.best = Some(state.best.map_or(*rate, |best| best.max(*rate)));
            }
            Event::Refining { planned } => state.planned = Some((*planned).to_owned()),
            Event::Variant { name, .. } => state.planned = Some((*name).to_owned()),
            _ => {}
        }
    }

    /// Attempts and results so far, a line each; none before the first plan is evaluated.
    pub fn lines(&self) -> Vec<String> {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let trying = state.planned.as_ref().map(|planned| format!("trying: {planned}"));
        let best = state.best.map(|best| format!("best so far: {:.1} % of rollouts succeed", 100.0 * best));
        trying.into_iter().chain(best).collect()
    }
}

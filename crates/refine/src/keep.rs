//! Storage of the best plan so far, in memory and in the folder of the session.

use plan::{PlannerError, Round};
use task::Trajectory;

use crate::candidate::Evaluated;
use crate::resume::checkpoint;
use crate::search::Search;

/// Stores a plan if it is better than the best so far; its `round` is not finished.
pub fn keep_if_best(search: &mut Search, evaluated: Evaluated, round: &Round) -> Result<(), PlannerError> {
    if search.found.best.as_ref().is_some_and(|best| !evaluated.is_better_than(best)) {
        return Ok(());
    }
    let rounds = search.found.rounds.iter().chain([round]).cloned().collect();
    keep(search, evaluated, rounds)
}

/// Stores a plan as the best, with the rounds so far.
pub fn keep(search: &mut Search, evaluated: Evaluated, rounds: Vec<Round>) -> Result<(), PlannerError> {
    if let Some(folder) = search.setting.session.folder {
        let are_kept = search.found.best.as_ref().is_some_and(|best| best.round == evaluated.round);
        let solved = &evaluated.solved;
        if solved.origin.has_homotopy_of_scene() {
            search.found.tables.clear();
        } else if !are_kept {
            let motions: Vec<&Trajectory> = solved.iterations.iter().map(|iteration| &iteration.trajectory).collect();
            let tables = folder.keep_refined(evaluated.round, &motions, &solved.variant.task)?;
            search.found.tables = tables.into_iter().collect();
        }
        checkpoint(search, &evaluated, rounds).save(folder)?;
    }
    search.found.best = Some(evaluated);
    Ok(())
}

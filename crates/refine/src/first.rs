//! The first reference, before any change.

use plan::{Event, PlannerError, Round};
use simulation::Reference;

use crate::candidate::{Evaluated, round};
use crate::keep::keep_if_best;
use crate::origin::Solved;
use crate::search::Search;

/// Evaluates a reference that was not refined, and keeps it.
pub fn judge_first(search: &mut Search, solved: Solved, reference: Reference) -> Result<(), PlannerError> {
    let judgement = search.judge(&reference, search.schedule.end());
    let rate = judgement.rates.overall();
    if judgement.rates.rollouts() > 0 {
        search.setting.session.tell(Event::Evaluated { rate });
    }
    search.found.before = judgement.rates.clone();
    let round = Round { rate: Some(rate), ..round(&solved, &[]) };
    let evaluated = Evaluated::new(solved, reference, &judgement, 1, 0);
    search.found.remember(evaluated.clone(), search.setting.target.parameters.comparison.latest);
    keep_if_best(search, evaluated, &round)?;
    search.found.rounds.push(round);
    Ok(())
}

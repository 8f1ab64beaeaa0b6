//! The first reference, before any change.

use plan::{Event, PlannerError, Round};
use simulation::{Reference, TestCase, TestResult};

use crate::candidate::{Evaluated, round};
use crate::keep::keep_if_best;
use crate::origin::Solved;
use crate::search::Search;

/// Evaluates a reference that was not refined, and keeps it if it is the best. Returns the test cases that it fails.
pub fn judge_first(
    search: &mut Search,
    solved: Solved,
    reference: Reference,
) -> Result<Vec<(TestCase, TestResult)>, PlannerError> {
    let judgement = search.judge(&reference, search.schedule.end());
    let rate = judgement.rates.overall();
    if judgement.rates.rollouts() > 0 {
        search.setting.session.tell(Event::Evaluated { rate });
    }
    // Of several references, the best is what refinement begins with.
    if rate >= search.found.before.overall() {
        search.found.before = judgement.rates.clone();
    }
    let round = Round { rate: Some(rate), ..round(&solved, &[]) };
    let evaluated = Evaluated::new(solved, reference, &judgement, search.found.rounds.len() + 1, 0);
    search.found.remember(evaluated.clone(), search.setting.target.parameters.comparison.latest);
    keep_if_best(search, evaluated, &round)?;
    search.found.rounds.push(round);
    Ok(judgement.failures)
}

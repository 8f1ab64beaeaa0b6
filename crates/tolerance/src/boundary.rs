//! The largest value of a quantity that a plan tolerates.

use std::fmt;

use plan::{Event, PlannerError, Session};
use serde::{Deserialize, Serialize};
use simulation::wilson_interval;

use crate::conditions::Conditions;
use crate::quantity::Quantity;
use crate::trials::{Case, Player, Trials};

/// Distances between tried values: this many lead from the easiest to the hardest.
const LEVELS: usize = 64;
/// Cases that find the hardest value.
const SCOUTS: usize = 16;
/// The first values of offsets and errors of the hole that are tried (m), and of rotations (rad).
const FIRST_LENGTH: f64 = 1e-3;
const FIRST_ANGLE: f64 = 0.02;
/// The easiest clearance, in clearances of the scene.
const WIDEST: f64 = 2.0;
/// The first number of cases, by which it is known which levels matter, and the second; that is doubled until the interval is
/// narrow.
const FIRST_CASES: usize = 64;
const SECOND_CASES: usize = 500;
/// Levels beyond the first one at which the rate does not hold that still matter.
const BEYOND: usize = 4;
/// An interval is narrow that is at most this share of the value.
const NARROW: f64 = 0.1;
/// Cases between two looks at the session.
const CHUNK: usize = 64;

/// The largest value of a quantity (for those of parts: the smallest) at which the wanted share of rollouts succeeds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Boundary {
    /// Which quantity.
    pub quantity: Quantity,
    /// Its value (m, rad, or 1); `None` where even the easiest tested value is too hard.
    pub value: Option<f64>,
    /// Confidence interval of 95 %: the share is exceeded at the first value and missed at the second one. `None` beyond
    /// the tested values.
    pub interval: [Option<f64>; 2],
    /// Rollouts that succeed at the value, of those that were played there.
    pub successes: usize,
    /// Rollouts that were played there.
    pub rollouts: usize,
    /// Whether the hardest tested value succeeds, too: the boundary may lie beyond it.
    pub is_open: bool,
}

/// In words, such as `offset up to 3.12 mm (2.97 mm to 3.44 mm), where 994 of 1000 succeed`.
impl fmt::Display for Boundary {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let Boundary { quantity, value, interval, successes, rollouts, is_open } = self;
        let [bound, hardest] =
            if quantity.is_hard_when_small() { ["down to", "the smallest"] } else { ["up to", "the largest"] };
        let Some(value) = value else {
            return write!(formatter, "{}: not tolerated at any tested value", quantity.name());
        };
        let [surely, surely_not] = interval.map(|end| end.map(|end| quantity.in_words(end)));
        let surely = surely.unwrap_or_else(|| "unknown".to_owned());
        let range = match (surely_not, quantity.is_hard_when_small()) {
            (Some(surely_not), true) => format!("{surely_not} to {surely}"),
            (Some(surely_not), false) => format!("{surely} to {surely_not}"),
            (None, true) => format!("at most {surely}"),
            (None, false) => format!("at least {surely}"),
        };
        let open = if *is_open { format!(", {hardest} tested value") } else { String::new() };
        write!(
            formatter,
            "{} {bound} {} ({range}){open}, where {successes} of {rollouts} succeed",
            quantity.name(),
            quantity.in_words(*value)
        )
    }
}

/// Finds the boundary of a quantity under conditions that fix all others. `None` when the session is interrupted.
///
/// Every case is tried at a few values, by bisection, which finds the hardest that it passes: cases fail beyond some value. The
/// boundary is a quantile of these, its interval that of the share of cases which pass. Once some cases have shown which values
/// matter, others are not tried. All cases are then played at the boundary itself, and it is moved to an easier value until
/// enough of them succeed.
///
/// # Errors
/// When a value of the quantity is not possible.
pub fn boundary(
    trials: &Trials,
    base: &Conditions,
    quantity: Quantity,
    session: &Session,
) -> Result<Option<Boundary>, PlannerError> {
    let Some([easiest, hardest]) = range(trials, base, quantity, session)? else { return Ok(None) };
    let value = |level: usize| easiest + (hardest - easiest) * level as f64 / LEVELS as f64;
    let mut players: Vec<Player> = Vec::with_capacity(LEVELS + 1);
    for level in 0..=LEVELS {
        let player = trials.player(base.with(quantity, value(level)), players.last())?;
        players.push(player);
    }
    let (most, mut passed, mut ceiling) = (trials.request.cases, Vec::new(), LEVELS);
    loop {
        let count = match passed.len() {
            0 => FIRST_CASES,
            known => (2 * known).max(SECOND_CASES),
        };
        let play = |case: &Case| levels_passed(trials, &players[..=ceiling], case);
        let Some(more) = played(trials, passed.len(), count.min(most), session, play) else { return Ok(None) };
        passed.extend(more);
        let levels = Levels::new(&passed, trials.request.rate);
        ceiling = levels.surely_not.map_or(ceiling, |level| ceiling.min(level + BEYOND));
        let is_enough = passed.len() >= SECOND_CASES && levels.is_narrow(&value);
        if passed.len() < most && !is_enough {
            continue;
        }
        let mut at = levels.at;
        let mut successes = 0;
        while let Some(level) = at {
            let Some(results) = played(trials, 0, passed.len(), session, |case| trials.passes(&players[level], case))
            else {
                return Ok(None);
            };
            successes = results.into_iter().filter(|passes| *passes).count();
            if successes as f64 >= trials.request.rate * passed.len() as f64 {
                break;
            }
            at = level.checked_sub(1);
        }
        return Ok(Some(Boundary {
            quantity,
            value: at.map(value),
            interval: [levels.surely.min(at).map(value), levels.surely_not.map(value)],
            successes,
            rollouts: passed.len(),
            is_open: at == Some(LEVELS),
        }));
    }
}

/// The easiest and the hardest value to try.
fn range(
    trials: &Trials,
    base: &Conditions,
    quantity: Quantity,
    session: &Session,
) -> Result<Option<[f64; 2]>, PlannerError> {
    let first = match quantity {
        Quantity::Clearance => return Ok(Some([WIDEST * trials.clearance()?, 0.0])),
        Quantity::Chamfer => return Ok(Some([trials.mouth()?.most, 0.0])),
        Quantity::Friction => return Ok(Some([0.0, quantity.limit()])),
        Quantity::Offset | Quantity::Hole => FIRST_LENGTH,
        Quantity::Rotation => FIRST_ANGLE,
    };
    let mut hardest = first;
    while hardest < quantity.limit() {
        let player = trials.player(base.with(quantity, hardest), None)?;
        let Some(passes) = played(trials, 0, SCOUTS, session, |case| trials.passes(&player, case)) else {
            return Ok(None);
        };
        if 2 * passes.iter().filter(|passes| **passes).count() < passes.len() {
            break;
        }
        hardest *= 2.0;
    }
    Ok(Some([0.0, hardest.min(quantity.limit())]))
}

/// Results of some cases, unless the session is interrupted.
fn played<R: Send>(
    trials: &Trials,
    from: usize,
    to: usize,
    session: &Session,
    play: impl Fn(&Case) -> R + Sync,
) -> Option<Vec<R>> {
    let mut results = Vec::with_capacity(to - from);
    for cases in trials.cases(to)[from..].chunks(CHUNK) {
        if session.is_interrupted() {
            return None;
        }
        results.extend(trials.workers.map(cases.iter(), &play));
        session.tell(Event::Rollouts { done: from + results.len(), count: to });
    }
    Some(results)
}

/// How many levels a case passes, from the easiest on. Who passes the last one, passes all that may follow.
fn levels_passed(trials: &Trials, players: &[Player], case: &Case) -> usize {
    let last = players.len() - 1;
    if trials.passes(&players[last], case) {
        return LEVELS + 1;
    }
    let (mut passed, mut failed) = (0, last);
    while passed < failed {
        let middle = (passed + failed) / 2;
        if trials.passes(&players[middle], case) {
            passed = middle + 1;
        } else {
            failed = middle;
        }
    }
    passed
}

/// The hardest levels at which the rate holds.
#[derive(Debug, PartialEq)]
struct Levels {
    /// By the cases that were played.
    at: Option<usize>,
    /// With confidence.
    surely: Option<usize>,
    /// The easiest at which it does not hold, with confidence.
    surely_not: Option<usize>,
}

impl Levels {
    /// From the number of levels that every case passes.
    fn new(passed: &[usize], rate: f64) -> Self {
        let successes: Vec<usize> =
            (0..=LEVELS).map(|level| passed.iter().filter(|count| **count > level).count()).collect();
        let hardest = |holds: &dyn Fn(usize) -> bool| (0..=LEVELS).rev().find(|&level| holds(successes[level]));
        let interval = |successes: usize| wilson_interval(successes, passed.len());
        Self {
            at: hardest(&|successes| successes as f64 >= rate * passed.len() as f64),
            surely: hardest(&|successes| interval(successes)[0] >= rate),
            surely_not: (0..=LEVELS).find(|&level| interval(successes[level])[1] < rate),
        }
    }

    fn is_narrow(&self, value: &impl Fn(usize) -> f64) -> bool {
        let Self { at: Some(at), surely: Some(surely), surely_not: Some(surely_not) } = *self else { return false };
        let width = surely_not.saturating_sub(surely);
        width <= 2 || (value(surely_not) - value(surely)).abs() <= NARROW * value(at).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_quantiles_with_their_interval() {
        // Of 1000 cases, ten pass 20 levels, thirty pass 30, and the others all.
        let passed: Vec<usize> = (0..1000)
            .map(|case| {
                if case < 10 {
                    20
                } else if case < 40 {
                    30
                } else {
                    65
                }
            })
            .collect();
        let levels = Levels::new(&passed, 0.99);
        assert_eq!(levels.at, Some(29), "990 of 1000 pass it");
        assert_eq!(levels.surely, Some(19), "all pass that");
        assert_eq!(levels.surely_not, Some(30), "960 pass it");
        let few = Levels::new(&[65; 100], 0.99);
        assert_eq!((few.at, few.surely, few.surely_not), (Some(LEVELS), None, None), "100 cases show no 99 %");
        assert_eq!(Levels::new(&[0; 500], 0.99).at, None);
    }
}

//! Everything that is asked of a plan at once.

use plan::{PlannerError, Session};
use simulation::Reference;

use crate::boundary::{Boundary, boundary};
use crate::map::{MapQuestion, map};
use crate::quantity::Quantity;
use crate::record::{NeedRecord, ToleranceRecord};
use crate::trials::Trials;

/// What is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Quantities whose boundaries are of interest; where there are none, all that the scene has.
    pub quantities: Vec<Quantity>,
    /// What is to be tolerated (SI units) at the smallest clearance that allows it.
    pub need: Option<(Quantity, f64)>,
    /// A map.
    pub map: Option<MapQuestion>,
}

/// Answers a question about the plan of some trials. `reference_at` has the reference for each row of the map. `None` when the
/// session is interrupted.
///
/// # Errors
/// When a value is not possible, and those of `reference_at`.
pub fn answer(
    trials: &Trials,
    question: &Question,
    reference_at: &mut dyn FnMut(f64) -> Result<Option<Reference>, PlannerError>,
    session: &Session,
) -> Result<Option<ToleranceRecord>, PlannerError> {
    let Some(boundaries) = boundaries(trials, &question.quantities, session)? else { return Ok(None) };
    let mut record = ToleranceRecord::new(trials, boundaries);
    if let Some((quantity, value)) = question.need {
        let base = trials.nominal().with(quantity, value);
        let Some(clearance) = boundary(trials, &base, Quantity::Clearance, session)? else { return Ok(None) };
        record.need = Some(NeedRecord { quantity, value, clearance });
    }
    if let Some(asked) = &question.map {
        let Some(map) = map(trials, asked, reference_at, session)? else { return Ok(None) };
        record.map = Some(map);
    }
    Ok(Some(record))
}

/// The boundaries of single quantities.
fn boundaries(
    trials: &Trials,
    quantities: &[Quantity],
    session: &Session,
) -> Result<Option<Vec<Boundary>>, PlannerError> {
    let is_possible = |quantity: &Quantity| *quantity != Quantity::Clearance || trials.clearance().is_ok();
    let mut quantities = quantities.to_vec();
    if quantities.is_empty() {
        quantities.extend(Quantity::ALL.into_iter().filter(is_possible));
    }
    let found = quantities.into_iter().map(|quantity| boundary(trials, &trials.nominal(), quantity, session));
    found.collect()
}

//! Everything that is asked of a plan at once.

use plan::{PlannerError, Session};
use serde::{Deserialize, Serialize};
use simulation::Reference;

use crate::boundary::Boundary;
use crate::map::{MapQuestion, map};
use crate::quantity::Quantity;
use crate::record::{NeedRecord, ToleranceRecord};
use crate::trials::Trials;
use crate::work::Work;

/// What is asked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// Quantities whose boundaries are of interest; where there are none, all that the scene has but the chamfer.
    pub quantities: Vec<Quantity>,
    /// What is to be tolerated.
    pub need: Option<Need>,
    /// A map.
    pub map: Option<MapQuestion>,
}

impl Question {
    /// Refuses quantities that the parts do not have, before anything is measured.
    fn require_possible(&self, trials: &Trials) -> Result<(), PlannerError> {
        let mut asked = self.quantities.iter().copied().chain(self.need.map(|need| need.by));
        asked.try_for_each(|quantity| trials.require(quantity))
    }
}

/// What is to be tolerated at the smallest clearance or chamfer that allows it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Need {
    /// Which error.
    pub quantity: Quantity,
    /// Its value (SI units).
    pub value: f64,
    /// What the parts meet it by: one of [`Quantity::OF_PARTS`].
    pub by: Quantity,
}

/// Answers a question about the plan of some trials. `reference_at` has the reference for each row of the map. `None` when the
/// session is interrupted. What is finished in `work` is not measured again.
///
/// # Errors
/// When a value is not possible, and those of `reference_at` and `work`.
pub fn answer(
    trials: &Trials,
    question: &Question,
    work: &mut Work,
    reference_at: &mut dyn FnMut(f64) -> Result<Option<Reference>, PlannerError>,
    session: &Session,
) -> Result<Option<ToleranceRecord>, PlannerError> {
    question.require_possible(trials)?;
    let Some(boundaries) = boundaries(trials, &question.quantities, work, session)? else { return Ok(None) };
    let mut record = ToleranceRecord::new(trials, boundaries);
    if let Some(Need { quantity, value, by }) = question.need {
        let base = trials.nominal().with(quantity, value);
        let Some(boundary) = work.boundary(trials, &base, by, session)? else { return Ok(None) };
        record.need = Some(NeedRecord { quantity, value, boundary });
    }
    if let Some(asked) = &question.map {
        let Some(map) = map(trials, asked, work, reference_at, session)? else { return Ok(None) };
        record.map = Some(map);
    }
    Ok(Some(record))
}

/// The boundaries of single quantities.
fn boundaries(
    trials: &Trials,
    quantities: &[Quantity],
    work: &mut Work,
    session: &Session,
) -> Result<Option<Vec<Boundary>>, PlannerError> {
    // A chamfer would be a change of the parts, which is measured where it is asked for.
    let is_possible = |quantity: &Quantity| *quantity != Quantity::Chamfer && trials.require(*quantity).is_ok();
    let mut quantities = quantities.to_vec();
    if quantities.is_empty() {
        quantities.extend(Quantity::ALL.into_iter().filter(is_possible));
    }
    let found = quantities.into_iter().map(|quantity| work.boundary(trials, &trials.nominal(), quantity, session));
    found.collect()
}

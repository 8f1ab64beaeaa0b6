//! Everything that is asked of a plan at once.

use plan::{PlannerError, Session};
use serde::{Deserialize, Serialize};
use simulation::Reference;

use crate::boundary::Boundary;
use crate::conditions::Conditions;
use crate::map::MapQuestion;
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

/// A boundary that is asked for.
#[derive(Debug, Clone, Copy)]
struct Asked {
    quantity: Quantity,
    /// The other errors.
    base: Conditions,
    /// Value of the other quantity, in a row of the map (SI units).
    row: Option<f64>,
}

/// Has the reference for a value of the other quantity of the map; `None` when the session is interrupted.
pub type ReferenceAt<'work> = &'work mut dyn FnMut(f64) -> Result<Option<Reference>, PlannerError>;

impl Question {
    /// The boundaries that are asked for: of single quantities, of what is needed, and of the rows of the map.
    ///
    /// # Errors
    /// When the parts do not have a quantity.
    fn asked(&self, trials: &Trials) -> Result<Vec<Asked>, PlannerError> {
        let (nominal, row) = (trials.nominal(), None);
        let single = self.quantities(trials).into_iter().map(|quantity| Asked { quantity, base: nominal, row });
        let need = self.need.map(|Need { quantity, value, by }| Asked {
            quantity: by,
            base: nominal.with(quantity, value),
            row,
        });
        let asked: Vec<Asked> = single.chain(need).collect();
        asked.iter().try_for_each(|one| trials.require(one.quantity))?;
        let rows = self.map.iter().flat_map(|map| {
            map.values.iter().map(|&at| Asked {
                quantity: map.quantity,
                base: nominal.with(map.over, at),
                row: Some(at),
            })
        });
        Ok(asked.into_iter().chain(rows).collect())
    }

    fn quantities(&self, trials: &Trials) -> Vec<Quantity> {
        if !self.quantities.is_empty() {
            return self.quantities.clone();
        }
        // A chamfer would be a change of the parts, which is measured where it is asked for.
        let is_possible = |quantity: &Quantity| *quantity != Quantity::Chamfer && trials.require(*quantity).is_ok();
        Quantity::ALL.into_iter().filter(is_possible).collect()
    }

    /// The record of all boundaries that are asked for, in their order.
    fn record(&self, trials: &Trials, mut found: Vec<Boundary>) -> ToleranceRecord {
        let rows = found.split_off(found.len() - self.map.as_ref().map_or(0, |map| map.values.len()));
        let needed = self.need.and_then(|need| Some((need, found.pop()?)));
        let mut record = ToleranceRecord::new(trials, found);
        record.need = needed.map(|(Need { quantity, value, .. }, boundary)| NeedRecord { quantity, value, boundary });
        record.map = self.map.as_ref().map(|map| map.drawn(rows));
        record
    }
}

impl Asked {
    fn measure(
        &self,
        trials: &Trials,
        work: &mut Work,
        reference_at: ReferenceAt,
        session: &Session,
    ) -> Result<Option<Boundary>, PlannerError> {
        let Self { quantity, base, row } = *self;
        let Some(at) = row else { return work.boundary(trials, &base, quantity, session) };
        let Some(reference) = reference_at(at)? else { return Ok(None) };
        work.boundary(&trials.of(reference, session)?, &base, quantity, session)
    }
}

/// Answers a question about the plan of some trials. `None` when the session is interrupted. What is finished in `work` is not
/// measured again.
///
/// # Errors
/// When a value is not possible, and those of `reference_at` and `work`.
pub fn answer(
    trials: &Trials,
    question: &Question,
    work: &mut Work,
    reference_at: ReferenceAt,
    session: &Session,
) -> Result<Option<ToleranceRecord>, PlannerError> {
    let asked = question.asked(trials)?;
    let found = asked.iter().map(|one| one.measure(trials, work, reference_at, session));
    let found: Option<Vec<Boundary>> = found.collect::<Result<_, _>>()?;
    Ok(found.map(|found| question.record(trials, found)))
}

/// Measures one of the boundaries that are asked for, by its number from 0, for another process to answer the question with.
/// `None` when the session is interrupted.
///
/// # Errors
/// Those of [`answer`], and when there is no boundary of that number.
pub fn answer_one(
    trials: &Trials,
    question: &Question,
    index: usize,
    work: &mut Work,
    reference_at: ReferenceAt,
    session: &Session,
) -> Result<Option<Boundary>, PlannerError> {
    let asked = question.asked(trials)?;
    let Some(one) = asked.get(index) else {
        let problem = format!("{index} is too large: {} boundaries are asked for, counted from 0", asked.len());
        return Err(PlannerError::Choice { name: "index", problem });
    };
    one.measure(trials, work, reference_at, session)
}

//! How the boundary of one quantity depends on another one.

use plan::{PlannerError, Session};
use serde::Serialize;
use simulation::Reference;

use crate::boundary::{Boundary, boundary};
use crate::quantity::Quantity;
use crate::trials::Trials;

/// Boundaries of a quantity at several values of another one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ToleranceMap {
    /// The quantity whose boundary is known.
    pub quantity: Quantity,
    /// The other one.
    pub over: Quantity,
    /// By ascending values of the other one.
    pub rows: Vec<ToleranceMapRow>,
}

/// The boundary at one value of the other quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ToleranceMapRow {
    /// Value of the other quantity (SI units).
    pub at: f64,
    /// The boundary there.
    pub boundary: Boundary,
}

/// Values around the nominal one, as multiples of it.
const MULTIPLES: [f64; 5] = [0.25, 0.5, 1.0, 1.5, 2.0];
/// Frictions (1) and rotation errors (rad).
const FRICTIONS: [f64; 5] = [0.0, 0.1, 0.2, 0.3, 0.5];
const ROTATIONS: [f64; 5] = [0.0, 0.01, 0.02, 0.05, 0.1];

/// A map that is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct MapQuestion {
    /// The quantity whose boundary is of interest.
    quantity: Quantity,
    /// The other one.
    over: Quantity,
    /// Its values, ascending.
    values: Vec<f64>,
}

impl MapQuestion {
    /// A map of a quantity over another one, at some values of that (SI units), or else around the scene's.
    ///
    /// # Errors
    /// When both are the same, or the scene has no clearance.
    pub fn new(trials: &Trials, quantity: Quantity, over: Quantity, values: &[f64]) -> Result<Self, PlannerError> {
        if quantity == over {
            let problem = format!("{0},{0}: the two quantities must differ", over.name());
            return Err(PlannerError::Choice { name: "map", problem });
        }
        if quantity == Quantity::Clearance {
            trials.clearance()?;
        }
        let mut values = if values.is_empty() { values_around(trials, over)? } else { values.to_vec() };
        values.sort_by(f64::total_cmp);
        Ok(Self { quantity, over, values })
    }

    /// The quantity of the rows.
    pub fn over(&self) -> Quantity {
        self.over
    }
}

/// Values of a quantity that are of interest for a plan.
fn values_around(trials: &Trials, over: Quantity) -> Result<Vec<f64>, PlannerError> {
    let around = |nominal: f64| MULTIPLES.map(|multiple| multiple * nominal).to_vec();
    Ok(match over {
        Quantity::Offset | Quantity::Hole => around(trials.problem().offset_magnitude()),
        Quantity::Clearance => around(trials.clearance()?),
        Quantity::Friction => FRICTIONS.to_vec(),
        Quantity::Rotation => ROTATIONS.to_vec(),
    })
}

/// Draws a map. `reference_at` has the reference for a value of the other quantity. `None` when the session is interrupted, or
/// there is no reference.
///
/// # Errors
/// When a value is not possible, and those of `reference_at`.
pub fn map(
    trials: &Trials,
    question: &MapQuestion,
    reference_at: &mut dyn FnMut(f64) -> Result<Option<Reference>, PlannerError>,
    session: &Session,
) -> Result<Option<ToleranceMap>, PlannerError> {
    let MapQuestion { quantity, over, values } = question;
    let mut rows = Vec::with_capacity(values.len());
    for &at in values {
        let Some(reference) = reference_at(at)? else { return Ok(None) };
        let of_row = trials.of(reference, session)?;
        match boundary(&of_row, &trials.nominal().with(*over, at), *quantity, session)? {
            Some(boundary) => rows.push(ToleranceMapRow { at, boundary }),
            None => return Ok(None),
        }
    }
    Ok(Some(ToleranceMap { quantity: *quantity, over: *over, rows }))
}

impl ToleranceMap {
    /// How much the boundary changes with the other quantity near its nominal value, as a sentence.
    pub fn sensitivity(&self, nominal: f64) -> Option<String> {
        let known: Vec<(f64, f64)> = self.rows.iter().filter_map(|row| Some((row.at, row.boundary.value?))).collect();
        let near = known.windows(2).min_by(|one, other| {
            let distance = |pair: &[(f64, f64)]| (0.5 * (pair[0].0 + pair[1].0) - nominal).abs();
            distance(one).total_cmp(&distance(other))
        })?;
        let [(low, from), (high, to)] = *near else { return None };
        let (change, bought) = (high - low, to - from);
        let (quantity, over) = (self.quantity, self.over);
        let direction = if bought < 0.0 { "costs" } else { "buys" };
        Some(format!(
            "from {} to {}, {} more {} {direction} {} of {}",
            over.in_words(low),
            over.in_words(high),
            over.in_words(change),
            over.name(),
            quantity.in_words(bought.abs()),
            quantity.name()
        ))
    }
}

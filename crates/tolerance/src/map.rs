//! How the boundary of one quantity depends on another one.

use plan::PlannerError;
use serde::{Deserialize, Serialize};

use crate::boundary::Boundary;
use crate::quantity::Quantity;
use crate::sensitivity::Sensitivity;
use crate::trials::Trials;

/// Boundaries of a quantity at several values of another one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ToleranceMap {
    /// The quantity whose boundary is known.
    pub quantity: Quantity,
    /// The other one.
    pub over: Quantity,
    /// By ascending values of the other one.
    pub rows: Vec<ToleranceMapRow>,
    /// What a change of the other quantity buys; `None` where the rows do not decide it.
    pub sensitivity: Option<Sensitivity>,
}

/// The boundary at one value of the other quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapQuestion {
    /// The quantity whose boundary is of interest.
    pub(crate) quantity: Quantity,
    /// The other one.
    pub(crate) over: Quantity,
    /// Its values, ascending.
    pub(crate) values: Vec<f64>,
}

impl MapQuestion {
    /// A map of a quantity over another one, at some values of that (SI units), or else around the scene's.
    ///
    /// # Errors
    /// When both are the same, or the scene has no clearance or no mouth of a hole.
    pub fn new(trials: &Trials, quantity: Quantity, over: Quantity, values: &[f64]) -> Result<Self, PlannerError> {
        if quantity == over {
            let problem = format!("{0},{0}: the two quantities must differ", over.name());
            return Err(PlannerError::Choice { name: "map", problem });
        }
        trials.require(quantity)?;
        let mut values = if values.is_empty() { values_around(trials, over)? } else { values.to_vec() };
        values.sort_by(f64::total_cmp);
        Ok(Self { quantity, over, values })
    }

    /// The quantity of the rows.
    pub fn over(&self) -> Quantity {
        self.over
    }

    /// The map of a boundary at each value.
    pub(crate) fn drawn(&self, boundaries: Vec<Boundary>) -> ToleranceMap {
        let row = |(&at, boundary)| ToleranceMapRow { at, boundary };
        let rows: Vec<ToleranceMapRow> = self.values.iter().zip(boundaries).map(row).collect();
        let sensitivity = Sensitivity::of(self.quantity, self.over, &rows);
        ToleranceMap { quantity: self.quantity, over: self.over, rows, sensitivity }
    }
}

/// Values of a quantity that are of interest for a plan.
fn values_around(trials: &Trials, over: Quantity) -> Result<Vec<f64>, PlannerError> {
    let around = |nominal: f64| MULTIPLES.map(|multiple| multiple * nominal).to_vec();
    Ok(match over {
        Quantity::Offset | Quantity::Hole => around(trials.problem().offset_magnitude()),
        Quantity::Clearance => around(trials.clearance()?),
        Quantity::Chamfer => around(0.5 * trials.mouth()?.most),
        Quantity::Friction => FRICTIONS.to_vec(),
        Quantity::Rotation => ROTATIONS.to_vec(),
    })
}

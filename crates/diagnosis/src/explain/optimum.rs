//! All constraints where the solver ended, with their multipliers.

use kkt::Owner;
use plan::Plan;
use serde::Serialize;

use crate::explain::words::constraint;
use crate::explain::{End, end};

/// A constraint, or a bound on a variable, at the solution of the chosen homotopy step.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConstraintRecord {
    /// Kind of the constraint; limits have the name of their key.
    pub kind: &'static str,
    /// Unit of its value.
    pub unit: &'static str,
    /// Component of a position, velocity or quaternion; `None` for contacts.
    pub axis: Option<&'static str>,
    /// Scenario, from 1; `None` for the reference.
    pub scenario: Option<usize>,
    /// Time.
    pub time_s: f64,
    /// Body and environment part, for contacts.
    pub pair: Option<String>,
    /// Its value.
    pub value: f64,
    /// Its lower bound; `None` without one.
    pub lower: Option<f64>,
    /// Its upper bound; `None` without one.
    pub upper: Option<f64>,
    /// Cost per unit of the value, in Ipopt's sign: positive where the upper bound holds the cost up.
    pub multiplier: f64,
}

/// Every constraint where the solver ended. `None` where that point is not known any more, or a distance has no value there.
pub fn optimum(plan: &Plan) -> Option<Vec<ConstraintRecord>> {
    let End { task, residuals, .. } = end(plan)?;
    let finite = |value: f64| value.is_finite().then_some(value);
    let records = residuals.into_iter().map(|residual| {
        let member = &residual.member;
        let name = constraint(member, &task);
        ConstraintRecord {
            kind: name.kind,
            unit: name.unit,
            axis: name.axis,
            scenario: match member.owner {
                Owner::Reference => None,
                Owner::Scenario(index) => Some(index + 1),
            },
            time_s: member.stage as f64 * task.horizon.time_step,
            pair: member.pair.map(|pair| task.pairs[pair].to_string()),
            value: residual.value,
            lower: finite(residual.lower),
            upper: finite(residual.upper),
            multiplier: residual.multiplier,
        }
    });
    Some(records.collect())
}

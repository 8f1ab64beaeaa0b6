//! Limits that a plan reaches.

use serde::{Deserialize, Serialize};
use task::{Limits, State, Trajectory};

/// Share of a limit from which on it is reached.
const REACHED: f64 = 0.99;

/// A limit that a plan reaches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ActiveLimitRecord {
    /// Its key in `[limits]`.
    pub limit: String,
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub unit: String,
    /// Steps in which the reference or a scenario reaches it.
    pub steps: usize,
    /// Steps of the plan.
    pub of: usize,
}

/// The limits of which a motion uses all that is `usable`.
pub fn active(limits: &Limits, usable: &Limits, motion: &Trajectory) -> Vec<ActiveLimitRecord> {
    let steps: Vec<Limits> = (1..motion.reference.len()).map(|step| kept_in(motion, step)).collect();
    let reached =
        |index: usize, limit: f64| steps.iter().filter(|step| step.named()[index].2 >= REACHED * limit).count();
    let all = limits.named().into_iter().zip(usable.named()).enumerate();
    let records = all.map(|(index, ((name, unit, value), (_, _, usable)))| ActiveLimitRecord {
        limit: name.to_owned(),
        value,
        unit: unit.to_owned(),
        steps: reached(index, usable),
        of: steps.len(),
    });
    records.filter(|record| record.value.is_finite() && record.steps > 0).collect()
}

/// The tightest limits that reference and scenarios satisfy in a step.
fn kept_in(motion: &Trajectory, step: usize) -> Limits {
    let window = |states: &[State]| states.get(step - 1..=step).unwrap_or_default().to_vec();
    let reference = Limits::kept_by(&window(&motion.reference), motion.time_step, &[], 0.0);
    motion.scenarios.iter().fold(reference, |limits, scenario| {
        let contacts = scenario.contacts.get(step - 1).into_iter().flatten();
        let force = contacts.map(|contact| contact.force).fold(0.0, f64::max);
        let wrench = scenario.wrenches.get(step - 1..step).unwrap_or_default();
        limits.max(&Limits::kept_by(&window(&scenario.states), motion.time_step, wrench, force))
    })
}

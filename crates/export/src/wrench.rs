//! `wrench.csv`: what the controller is expected to do at the tool point.

use plan::PlannerError;
use store::trajectory::{WrenchRow, read_tables};
use store::{StoredPlan, to_csv};
use task::Wrench;

use crate::frames::Frames;

/// The wrenches of all scenarios at the steps of the plan, with the columns of the plan's own table: force (N) and torque (Nm)
/// about the tool point, along the axes of the base.
///
/// # Errors
/// When a table of the plan is missing or wrong.
pub fn wrench_csv(plan: &StoredPlan, frames: &Frames) -> Result<Vec<u8>, PlannerError> {
    let tables = read_tables(&plan.folder)?;
    let rows = tables.scenarios.iter().zip(1..).flat_map(|(motion, scenario)| {
        let steps = motion.states[1..].iter().zip(&motion.wrenches).zip(1_u32..);
        steps.map(move |((state, wrench), step)| {
            let wrench = frames.tool_wrench(&state.pose().isometry(), wrench);
            WrenchRow::new(f64::from(step) * tables.time_step, scenario, &Wrench(wrench.into()))
        })
    });
    to_csv(rows)
}

//! `wrench.csv`: what the controller is expected to do at the tool point.

use planner::PlannerError;
use planner::files::trajectory::read_tables;
use planner::files::{StoredPlan, Value, to_csv};
use serde::Serialize;
use simulation::isometry;
use task::pose_of;

use crate::frames::Frames;

/// A row: time, scenario from 1, force (N) and torque (Nm) about the tool point, along the axes of the base.
#[derive(Debug, Clone, Copy, Serialize)]
struct ToolWrenchRow {
    time_s: Value,
    scenario: usize,
    fx_n: Value,
    fy_n: Value,
    fz_n: Value,
    tx_nm: Value,
    ty_nm: Value,
    tz_nm: Value,
}

/// The wrenches of all scenarios at the steps of the plan.
///
/// # Errors
/// When a table of the plan is missing or wrong.
pub fn wrench_csv(plan: &StoredPlan, frames: &Frames) -> Result<Vec<u8>, PlannerError> {
    let tables = read_tables(&plan.folder)?;
    let rows = tables.scenarios.iter().zip(1..).flat_map(|(motion, scenario)| {
        let steps = motion.states[1..].iter().zip(&motion.wrenches).zip(1..);
        steps.map(move |((state, wrench), step)| {
            let wrench = frames.tool_wrench(&isometry(&pose_of(state)), wrench);
            let [fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm] = <[f64; 6]>::from(wrench).map(Value);
            let time_s = Value(step as f64 * tables.time_step);
            ToolWrenchRow { time_s, scenario, fx_n, fy_n, fz_n, tx_nm, ty_nm, tz_nm }
        })
    });
    to_csv(rows)
}

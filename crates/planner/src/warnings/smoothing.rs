//! Whether a plan leans on smoothing: contact is soft while it is planned, real parts are not.

use crate::plan::Plan;

/// Overlap that counts as hard contact, as a fraction of the clearance at the goal.
const HARD: f64 = 0.1;
/// Factor between the overlaps of two homotopy iterations above which less smoothing does not help.
const STALLED: f64 = 0.9;

/// What is wrong with a plan whose exact shapes overlap by more than a tenth of the clearance at the goal, in plain
/// words with the setting that cures it.
pub fn warning(plan: &Plan) -> Option<String> {
    let task = &plan.task;
    let scenarios = &plan.trajectory.scenarios;
    let overlap = |scenario: usize| scenarios[scenario].quality.penetration.map_or(0.0, |peak| peak.value);
    let worst = (0..scenarios.len()).max_by(|&one, &other| overlap(one).total_cmp(&overlap(other)))?;
    let peak = scenarios[worst].quality.penetration?;
    let clearance = task.clearance(&task.goal);
    if clearance > 0.0 && peak.value <= HARD * clearance {
        return None;
    }
    let what = format!(
        "in scenario {} the exact shapes of {} overlap by {:.3} mm at {:.2} s",
        worst + 1,
        task.pairs[peak.pair],
        1e3 * peak.value,
        peak.step as f64 * plan.trajectory.time_step
    );
    if clearance <= 0.0 {
        return Some(format!(
            "{what}; the goal itself has no clearance ({:.3} mm) to compare that with: move it away from the environment \
             by the clearance that the parts have",
            1e3 * clearance
        ));
    }
    let much = format!("more than a tenth of the clearance at the goal ({:.3} mm)", 1e3 * clearance);
    if peak.step == 0 {
        return Some(format!("{what}, {much}: move this start away from the environment"));
    }
    let has_stalled = matches!(plan.iterations.as_slice(), [.., before, now]
        if now.record.max_penetration_m > STALLED * before.record.max_penetration_m);
    let cure = if has_stalled { shorter_steps(plan) } else { less_smoothing(plan, peak.value, clearance) };
    Some(format!("{what}, {much}; {cure}"))
}

/// The overlap shrinks in proportion to the last tau.
fn less_smoothing(plan: &Plan, overlap: f64, clearance: f64) -> String {
    let settings = &plan.variant.settings;
    let excess = overlap / (HARD * clearance);
    let missing = (excess.ln() / -settings.tau_rate.ln()).ceil().max(1.0) as usize;
    let iterations = settings.iterations + missing;
    let tau = |iterations: usize| settings.tau * settings.tau_rate.powi(iterations as i32 - 1);
    format!(
        "the plan leans on smoothing: set iterations = {iterations} in [homotopy], which was {}, so that the last tau is \
         {:.1e} instead of {:.1e}",
        settings.iterations,
        tau(iterations),
        tau(settings.iterations)
    )
}

/// What smoothing does not explain is the linearisation of the distances over one step.
fn shorter_steps(plan: &Plan) -> String {
    let horizon = plan.task.horizon;
    format!(
        "less smoothing hardly changes that, so the steps are too long: set steps = {} and time_step = {} in [horizon]",
        2 * horizon.steps,
        horizon.time_step / 2.0
    )
}

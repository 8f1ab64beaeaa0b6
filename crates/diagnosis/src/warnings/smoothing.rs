//! Whether a plan leans on smoothing: contact is soft while it is planned, real parts are not.

use plan::Plan;
use task::Penetration;

/// Warning about a plan whose exact shapes penetrate by more than a tenth of the clearance at the goal, with the
/// setting that cures it.
pub fn warning(plan: &Plan) -> Option<String> {
    let task = &plan.task;
    let (scenario, peak) = plan.trajectory.deepest_penetration()?;
    let before = plan.chosen_stage().checked_sub(2).map(|index| &plan.iterations[index].trajectory);
    let what = format!(
        "in scenario {} the exact shapes of {} penetrate by {:.3} mm at {:.2} s",
        scenario + 1,
        task.pairs[peak.pair],
        1e3 * peak.value,
        peak.step as f64 * plan.trajectory.time_step
    );
    let clearance = task.clearance(&task.goal);
    let much = format!("{what}, more than a tenth of the clearance at the goal ({:.3} mm)", 1e3 * clearance);
    match Penetration::of(task, &plan.trajectory, plan.chosen().record.tau, before) {
        Penetration::Hard => None,
        Penetration::Soft => Some(format!("{much}; {}", less_smoothing(plan, peak.value))),
        Penetration::Stalled => Some(format!("{much}; {}", shorter_steps(plan))),
        Penetration::AtStart => Some(format!("{much}: move this start away from the environment")),
        Penetration::NoClearance => Some(format!(
            "{what}; the goal itself has no clearance ({:.3} mm) to compare that with: move it away from the environment \
             by the clearance that the parts have",
            1e3 * clearance
        )),
    }
}

/// The penetration shrinks in proportion to the last tau.
fn less_smoothing(plan: &Plan, penetration: f64) -> String {
    let settings = &plan.variant.settings;
    let number = plan.chosen_stage();
    if number < plan.iterations.len() {
        return format!(
            "with less smoothing, in homotopy step {}, the plan got worse: try another tau in [homotopy]",
            number + 1
        );
    }
    let missing =
        (Penetration::excess(&plan.task, penetration).ln() / -settings.tau_rate.ln()).ceil().max(1.0) as usize;
    let tau = |number: usize| settings.tau * settings.tau_rate.powi(number as i32 - 1);
    format!(
        "the plan leans on smoothing: set further_iterations = {} in [homotopy], which was {}, so that the last tau is \
         {:.1e} instead of {:.1e}",
        settings.further_iterations + missing,
        settings.further_iterations,
        tau(number + missing),
        tau(number)
    )
}

/// Penetration beyond smoothing comes from the linearisation of the distances over one step.
fn shorter_steps(plan: &Plan) -> String {
    let horizon = plan.task.horizon;
    format!(
        "less smoothing hardly changes that, so the steps are too long: set steps = {} and time_step = {} in [horizon]",
        2 * horizon.steps,
        horizon.time_step / 2.0
    )
}

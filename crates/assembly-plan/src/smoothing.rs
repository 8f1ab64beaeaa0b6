//! Whether a plan leans on smoothing: contact is soft while it is planned, real parts are not.

use ocp::HomotopyIteration;

use crate::problem::Problem;
use crate::stage::Stage;

/// Overlap that counts as hard contact, as a part of the clearance at the goal.
const HARD: f64 = 0.1;
/// Factor between the overlaps of two homotopy iterations above which less smoothing does not help.
const STALLED: f64 = 0.9;

/// What is wrong with a plan whose exact shapes overlap by more than a tenth of the clearance at the goal, in plain
/// words with the setting that cures it.
pub fn warning(problem: &Problem, stages: &[Stage], last: &HomotopyIteration) -> Option<String> {
    let scenarios = &last.trajectory.scenarios;
    let overlap = |scenario: usize| scenarios[scenario].quality.penetration.map_or(0.0, |peak| peak.value);
    let worst = (0..scenarios.len()).max_by(|&one, &other| overlap(one).total_cmp(&overlap(other)))?;
    let peak = scenarios[worst].quality.penetration?;
    let clearance = problem.task.clearance(&problem.task.goal);
    if clearance > 0.0 && peak.value <= HARD * clearance {
        return None;
    }
    let what = format!(
        "in scenario {} the exact shapes of {} overlap by {:.3} mm at {:.2} s",
        worst + 1,
        problem.task.pairs[peak.pair],
        1e3 * peak.value,
        peak.step as f64 * last.trajectory.time_step
    );
    if clearance <= 0.0 {
        return Some(format!(
            "{what}; whether that is much cannot be told, because the goal itself has no clearance ({:.3} mm): move it \
             away from the environment by the clearance that the parts have",
            1e3 * clearance
        ));
    }
    let much = format!("more than a tenth of the clearance at the goal ({:.3} mm)", 1e3 * clearance);
    if peak.step == 0 {
        return Some(format!("{what}, {much}: move this start away from the environment"));
    }
    let shrinks = !matches!(stages, [.., before, now] if now.max_penetration_m > STALLED * before.max_penetration_m);
    let cure = if shrinks { less_smoothing(problem, peak.value, clearance) } else { shorter_steps(problem) };
    Some(format!("{what}, {much}; {cure}"))
}

/// The overlap shrinks in proportion to the last tau.
fn less_smoothing(problem: &Problem, overlap: f64, clearance: f64) -> String {
    let settings = &problem.homotopy;
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
fn shorter_steps(problem: &Problem) -> String {
    let horizon = problem.task.horizon;
    format!(
        "less smoothing hardly changes that, so the steps are too long: set steps = {} and time_step = {} in [horizon]",
        2 * horizon.steps,
        horizon.time_step / 2.0
    )
}

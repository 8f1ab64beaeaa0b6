//! The summary of a plan, in a few lines.

use planner::files::{AdmittanceRecord, LimitsRecord, MotionRecord, PlanResult};
use planner::{
    Millimetres, OffsetRegion, PushReport, RobustnessReport, SuccessRate, SuccessRates, TestReport, interval,
    max_force, rate,
};

/// What solving the problem took.
fn solving(result: &PlanResult) -> String {
    let PlanResult { objective, iterations, wall_s, linear_solver, linear_solver_fallbacks, .. } = result;
    if *iterations == 0 {
        return "nothing was solved".to_owned();
    }
    let fallbacks = match linear_solver_fallbacks {
        0 => String::new(),
        count => format!(" ({count} systems left to the general solver)"),
    };
    format!(
        "objective {objective:.4}, {iterations} iterations, {wall_s:.1} s, linear solver {linear_solver}{fallbacks}"
    )
}

/// The summary of a plan, in a few lines.
pub fn summary(result: &PlanResult) -> String {
    let mut lines = vec![format!("{}: {}; {}", result.scene, result.status, solving(result))];
    for attempt in &result.attempts {
        lines.push(format!(
            "  tried {}: {}, ends {:.2} mm from the goal, {} iterations, {:.1} s",
            attempt.planned,
            attempt.status,
            1e3 * attempt.position_error_m,
            attempt.iterations,
            attempt.wall_s
        ));
    }
    for (number, scenario) in (1..).zip(&result.scenarios) {
        lines.push(format!(
            "  scenario {number} ({}): ends {:.2} mm and {:.4} rad from the goal, penetrates at most {:.2} mm, presses with at \
             most {:.1} N",
            scenario.grasp,
            1e3 * scenario.position_error_m,
            scenario.orientation_error_rad,
            1e3 * scenario.max_penetration_m,
            scenario.max_force_n
        ));
    }
    let deepest = result.scenarios.iter().map(|scenario| scenario.max_penetration_m).fold(0.0, f64::max);
    let [deepest, most] = [deepest, result.allowed_penetration_m].map(|penetration| 1e3 * penetration);
    lines.push(format!("  exact shapes penetrate by at most {deepest:.3} mm ({most:.3} mm allowed)"));
    lines.push(format!("  offsets covered: {}", result.coverage));
    lines.push(execution(result));
    lines.extend(result.motion.as_ref().map(motion));
    lines.extend(limits(&result.limits, &result.reached));
    let why = result.explanation.iter().flat_map(|explanation| explanation.sentences(result.converged));
    lines.extend(why.map(|sentence| format!("  {sentence}")));
    lines.extend(result.robust.iter().flat_map(|report| robustness(report, result.chosen_stage)));
    lines.extend(result.tested.iter().flat_map(tested));
    let push = result.robust.iter().flat_map(|report| &report.push).chain(result.tested.iter().map(|test| &test.push));
    lines.extend(push.map(straight_push));
    if result.planned {
        lines
            .push("  run with --robust for a plan that succeeds in rollouts with hard contact and friction".to_owned());
    }
    lines.join("\n")
}

/// Duration, largest rotation and forces of a plan.
fn motion(motion: &MotionRecord) -> String {
    format!(
        "  moves for {:.2} s, contact force up to {:.1} N (mean over 10 ms), rotates by up to {:.1} degrees away from the \
         straight motion, leaves the straight path by up to {:.2} mm ({:.2} mm in free air)",
        motion.duration_s,
        motion.max_force_n,
        motion.rotation.largest.to_degrees(),
        1e3 * motion.departure.largest,
        1e3 * motion.free_departure.largest
    )
}

/// Used fraction of every limit of a plan; `None` without limits.
fn limits(limits: &LimitsRecord, reached: &LimitsRecord) -> Option<String> {
    let both = limits.named().into_iter().zip(reached.named());
    let used: Vec<String> = both
        .filter(|((_, _, limit), _)| limit.is_finite())
        .map(|((name, unit, limit), (_, _, value))| format!("{name} {value:.4} of {limit} {unit}"))
        .collect();
    (!used.is_empty()).then(|| format!("  limits, in the planned scenarios: {}", used.join(", ")))
}

fn robustness(report: &RobustnessReport, planned: usize) -> Vec<String> {
    let mut lines = vec![format!(
        "success in rollouts with hard contact: {:.1} % of {} before, {:.1} % of {} after (target of {:.1} % at each friction), \
         {:.0} s; {}",
        100.0 * report.rate_before,
        report.before.rollouts(),
        100.0 * report.rate_after,
        report.after.rollouts(),
        100.0 * report.target_rate,
        report.wall_s,
        changes(report, planned)
    )];
    lines.extend(by_friction(&report.after));
    if report.unplayed == 0 && !report.planned_offsets_succeed() {
        lines.push("  not every planned offset reaches the goal".to_owned());
    }
    lines.extend(report.loss.iter().flat_map(|loss| loss.sentences().map(|sentence| format!("  {sentence}"))));
    lines
}

/// Success of an unrefined plan in rollouts.
fn tested(report: &TestReport) -> Vec<String> {
    let mut lines =
        vec![format!("played in {} rollouts with hard contact, {:.1} s:", report.rates.rollouts(), report.wall_s)];
    lines.extend(by_friction(&report.rates));
    lines
}

fn straight_push(push: &PushReport) -> String {
    match push.reached {
        true => "  a straight push also succeeds in these rollouts: no plan is needed".to_owned(),
        false => format!(
            "  a straight push succeeds in {:.1} % of {} of the same rollouts",
            100.0 * push.rates.overall(),
            push.rates.rollouts()
        ),
    }
}

fn by_friction(rates: &SuccessRates) -> impl Iterator<Item = String> {
    rates.by_friction().map(|groups| {
        let listed: Vec<String> = groups.iter().map(group).collect();
        let [low, high] = interval(groups).map(|bound| 100.0 * bound);
        let (friction, percent) = (groups[0].friction, 100.0 * rate(groups));
        let force = max_force(groups);
        format!(
            "  friction {friction}: {percent:.1} % (95 % confidence: {low:.1} to {high:.1}), contact force up to {force:.1} N: {}",
            listed.join(", ")
        )
    })
}

fn group(group: &SuccessRate) -> String {
    let length = Millimetres(group.magnitude_m);
    let offsets = match (group.planned, group.region) {
        (true, _) => format!("{length} mm planned"),
        (false, OffsetRegion::Hull) => format!("{length} mm"),
        (false, OffsetRegion::Inside) => format!("up to {length} mm"),
        (false, OffsetRegion::Rim) => format!("rim, {length} mm,"),
    };
    format!("{offsets} {} of {}", group.successes, group.rollouts)
}

/// Origin of the kept reference, in words.
fn changes(report: &RobustnessReport, planned: usize) -> String {
    let reference = match (report.kept_perturbations, report.kept_stage) {
        (0, 0) => format!("{}, unchanged", report.kept().map_or("the reference", |kept| &kept.planned)),
        (0, stage) if stage == planned => "the plan was left as it was".to_owned(),
        (0, stage) => format!("the reference of homotopy step {stage}, unchanged"),
        (1, _) => "1 change of the reference".to_owned(),
        (changes, _) => format!("{changes} changes of the reference"),
    };
    match report.kept() {
        Some(kept) if report.rounds.len() > 1 => {
            format!("{reference}, the best of {} rounds: {}", report.rounds.len(), kept.planned)
        }
        _ => reference,
    }
}

/// What the controller must be like.
fn execution(result: &PlanResult) -> String {
    let gains = format!(
        "  execute with {:.0} N/m and {:.1} Nm/rad",
        result.gains.translational_stiffness_n_m, result.gains.rotational_stiffness_nm_rad
    );
    match &result.admittance {
        None => format!("{gains}, and the damping of resolved.toml"),
        Some(AdmittanceRecord { mass, damping, period_s, lag_s, contact_stiffness_n_m, sensitivity, .. }) => format!(
            "{gains}, {:.0} Ns/m and {:.2} Nms/rad, and a virtual mass of {:.2} kg and {:.4} kg m^2, every {:.1} ms: stable against \
             contacts of up to {contact_stiffness_n_m:.1e} N/m with a lag of {:.1} ms (largest sensitivity {sensitivity:.2})",
            damping[0],
            damping[1],
            mass[0],
            mass[1],
            1e3 * period_s,
            1e3 * lag_s
        ),
    }
}

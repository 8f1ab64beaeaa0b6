//! Advice where a plan is not done. Each piece of advice stands for a condition that holds for the plan.

use nlp::SolveStatus;
use plan::pose_clearance::along_insertion;
use plan::{Millimetres, Plan, Stop};
use scene::Part;
use task::algebra::norm;
use task::{Pose, State};

use crate::check::{first_smoothing, rest, step};
use crate::explain::limits::ActiveLimitRecord;
use crate::explain::stuck::StuckScenario;
use crate::warnings::tolerance::free_offset;

/// Penetration that is worth a word (m).
const PENETRATION: f64 = 1e-4;
/// Share of the steps in which a limit that matters is reached.
const OFTEN: f64 = 0.1;
/// More steps than these are no advice.
const MOST_STEPS: f64 = 1e4;
/// More steps are at least this share of those there are.
const MORE_STEPS: f64 = 0.5;
/// Poses on the straight path from where a scenario ends to the goal.
const POSES: usize = 50;
/// Time in which a critically damped controller closes all but 4 % of a distance, in `sqrt(mass / stiffness)`.
const SETTLING: f64 = 5.0;

/// Advice, the most certain first.
pub fn advice(plan: &Plan, stuck: &[StuckScenario], limits: &[ActiveLimitRecord]) -> Vec<String> {
    let case = Case { plan, stuck };
    let smoothing = || (!stuck.is_empty()).then(|| first_smoothing(&plan.task, plan.variant.settings.tau)).flatten();
    if plan.stopped == Some(Stop::TimeLimit) {
        // There is no time to look at all pairs along the path.
        return [case.large_offset(), smoothing()].into_iter().flatten().collect();
    }
    let often = |limit: &&ActiveLimitRecord| limit.steps as f64 >= OFTEN * limit.of as f64;
    let is_fast = limits.iter().filter(often).any(|limit| limit.limit == "translational_velocity");
    let sure = [
        case.penetration_at_goal(),
        case.penetration_at_start(),
        free_offset(&plan.problem),
        case.large_offset(),
        case.way_blocked(),
        case.clearance(),
        case.final_smoothing(),
    ];
    let mut advice: Vec<String> = sure.into_iter().flatten().collect();
    let is_unexplained = advice.is_empty();
    advice.extend(limits.iter().filter(often).map(limit_advice));
    let others = [
        is_unexplained.then(|| case.longer_horizon()),
        is_fast.then(|| case.slow_controller()),
        Some(case.shorter_steps()),
        Some(case.more_iterations()),
        Some(case.smaller_offset()),
        Some(smoothing()),
    ];
    advice.extend(others.into_iter().flatten().flatten());
    if advice.is_empty() && plan.is_converged() {
        advice.push(
            "[homotopy]: the motion found is a local optimum: use half or twice the first tau, or another [[start]]"
                .to_owned(),
        );
    }
    advice
}

fn limit_advice(limit: &ActiveLimitRecord) -> String {
    let ActiveLimitRecord { limit, value, unit, steps, of } = limit;
    format!(
        "[limits]: {limit} = {value} {unit} is reached in {steps} of {of} steps: allow more, or give [horizon] more steps"
    )
}

/// A plan that is not done, and the scenarios that miss the goal.
struct Case<'plan> {
    plan: &'plan Plan,
    stuck: &'plan [StuckScenario],
}

impl Case<'_> {
    /// The pair that penetrates most at a pose, with its penetration (m), if any does.
    fn penetration(&self, pose: &Pose) -> Option<(String, f64)> {
        let pairs = self.plan.task.pairs.iter().map(|pair| (pair, -pair.shapes.exact_distance(pose)));
        let (pair, penetration) = pairs.max_by(|one, other| one.1.total_cmp(&other.1))?;
        (penetration > PENETRATION).then(|| (pair.to_string(), penetration))
    }

    fn penetration_at_goal(&self) -> Option<String> {
        let (pair, penetration) = self.penetration(&self.plan.task.goal)?;
        Some(format!(
            "[goal]: {pair} penetrate there by {:.2} mm, so that no motion reaches it: move the goal out of the environment",
            1e3 * penetration
        ))
    }

    fn penetration_at_start(&self) -> Option<String> {
        let starts = self.plan.trajectory.scenarios.iter().map(|motion| &motion.states[0]);
        let penetrations =
            (1..).zip(starts).filter_map(|(number, state)| Some((number, self.penetration(&state.pose())?)));
        let (scenario, (pair, penetration)) = penetrations.max_by(|(_, one), (_, other)| one.1.total_cmp(&other.1))?;
        Some(format!(
            "[[start]] \"{}\": with the grasp error of scenario {scenario}, {pair} penetrate there by {:.2} mm: move the start \
             away from the environment, or plan with a smaller offset_magnitude",
            self.plan.problem.start().name,
            1e3 * penetration
        ))
    }

    /// A smaller offset where a scenario is farther off than the body is thick: it may start beside the place where it
    /// belongs.
    fn large_offset(&self) -> Option<String> {
        let thickness = thickness(&self.plan.problem.scene().body);
        let offset = |stuck: &StuckScenario| norm(&stuck.grasp.offset_m);
        let largest = self.stuck.iter().map(offset).max_by(f64::total_cmp)?;
        (largest > thickness).then(|| {
            format!(
                "[robustness]: the offset of {:.1} mm is larger than the body is thick, {:.1} mm: contact can hardly lead it \
                 in; set a smaller offset_magnitude",
                1e3 * largest,
                1e3 * thickness
            )
        })
    }

    /// More steps where a scenario that nothing holds still approaches the goal at the end: as many as it takes at the
    /// speed of the last quarter.
    fn longer_horizon(&self) -> Option<String> {
        let plan = self.plan;
        let (steps, time_step) = (plan.trajectory.reference.len() - 1, plan.trajectory.time_step);
        let quarter = steps.div_ceil(4);
        let missing = |stuck: &StuckScenario| {
            let states = &plan.trajectory.scenarios[stuck.scenario - 1].states;
            let before = position_error(&states[steps - quarter], &plan.task.goal);
            let speed = (before - stuck.end.position_error_m) / (quarter as f64 * time_step);
            let more = (stuck.end.position_error_m / (speed * time_step)).max(MORE_STEPS * steps as f64).ceil();
            (speed > 0.0 && more <= MOST_STEPS).then_some((stuck.scenario, speed, more as usize))
        };
        let still_coming = self.stuck.iter().filter(|stuck| stuck.end.from_s.is_none() && stuck.end.held_by.is_empty());
        let (scenario, speed, more) = still_coming.filter_map(missing).max_by_key(|&(_, _, more)| more)?;
        Some(format!(
            "[horizon]: scenario {scenario} still approaches the goal at the end, with {:.1} mm/s: set steps = {} and time_step = \
             {time_step}",
            1e3 * speed,
            steps + more
        ))
    }

    /// Shorter steps where a solve that did not converge has steps that are long compared with the clearance.
    fn shorter_steps(&self) -> Option<String> {
        let task = &self.plan.task;
        (!self.plan.is_converged()).then(|| step(task, &along_insertion(task)))?
    }

    /// More stiffness where the body has a tracking error, the reference may not be faster, and nothing holds the body.
    fn slow_controller(&self) -> Option<String> {
        let plan = self.plan;
        let (mass, stiffness) = (plan.task.inertia.mean_mass(), plan.task.impedance.translational_stiffness);
        let (time, settling) =
            (plan.task.horizon.steps as f64 * plan.task.horizon.time_step, SETTLING * (mass / stiffness).sqrt());
        let free = self.stuck.iter().find(|stuck| stuck.end.held_by.is_empty())?;
        (settling > time).then(|| {
            format!(
                "[impedance]: translational_stiffness = {stiffness} N/m takes {settling:.1} s to move {mass} kg, longer \
                 than the horizon of {time:.1} s, and nothing holds scenario {}: set it to at least {:.1}, or give \
                 [horizon] more steps",
                free.scenario,
                mass * (SETTLING / time).powi(2)
            )
        })
    }

    fn more_iterations(&self) -> Option<String> {
        let record = &self.plan.chosen().record;
        (record.status == SolveStatus::IterationLimit.to_string()).then(|| {
            format!(
                "[ipopt]: max_iter ended homotopy step {} after {} iterations: allow more",
                self.plan.chosen_stage(),
                record.iterations
            )
        })
    }

    /// A larger tolerance where the resting error is as large as the final error.
    fn clearance(&self) -> Option<String> {
        let (worst, farthest) = (self.worst_error()?, self.plan.problem.engagement().rest_m);
        rest(&self.plan.problem, farthest.filter(|&farthest| worst <= farthest))
    }

    /// Less smoothing at the end where its reach explains the error.
    fn final_smoothing(&self) -> Option<String> {
        let plan = self.plan;
        let (tolerance, reach) = (plan.problem.success().position, plan.task.smoothing_gap(plan.chosen().record.tau));
        (plan.is_converged() && tolerance < reach && self.worst_error()? <= reach).then(|| {
            format!(
                "--position-tolerance {tolerance}: the last tau moves contacts by up to {:.2} mm: allow more, or set \
                 further_iterations higher than {} in [homotopy]",
                1e3 * reach,
                plan.variant.settings.further_iterations
            )
        })
    }

    /// Another path where a part stands between the end of a scenario and the goal.
    fn way_blocked(&self) -> Option<String> {
        let goal = &self.plan.task.goal;
        if self.penetration(goal).is_some() {
            return None;
        }
        let blocked = |stuck: &StuckScenario| {
            let states = &self.plan.trajectory.scenarios[stuck.scenario - 1].states;
            let end = states.last()?.pose();
            let between = |place: usize| {
                let share = place as f64 / POSES as f64;
                let mut pose = *goal;
                (0..3).for_each(|axis| pose.0[axis] = end[axis] + share * (goal[axis] - end[axis]));
                self.penetration(&pose)
            };
            let (pair, penetration) = (1..POSES).filter_map(between).max_by(|one, other| one.1.total_cmp(&other.1))?;
            (penetration > self.plan.problem.success().position).then_some((stuck.scenario, pair, penetration))
        };
        let (scenario, pair, penetration) =
            self.stuck.iter().filter_map(blocked).max_by(|one, other| one.2.total_cmp(&other.2))?;
        Some(format!(
            "[[start]]: from where scenario {scenario} ends, the straight path to the goal leads {:.1} mm deep through \
             {pair}: start where the path is free, or check the parts with `check`",
            1e3 * penetration
        ))
    }

    /// A smaller offset where scenarios with smaller offsets reach the goal.
    fn smaller_offset(&self) -> Option<String> {
        let motions = (1..).zip(&self.plan.trajectory.scenarios);
        let has_missed = |number: usize| self.stuck.iter().any(|stuck| stuck.scenario == number);
        let (missed, reached): (Vec<_>, Vec<_>) = motions.partition(|&(number, _)| has_missed(number));
        let lengths = |motions: &[(usize, &task::ScenarioTrajectory)]| -> Vec<f64> {
            motions.iter().map(|(_, motion)| norm(&motion.grasp.offset)).collect()
        };
        let largest = lengths(&reached).into_iter().max_by(f64::total_cmp)?;
        let smallest = lengths(&missed).into_iter().min_by(f64::total_cmp)?;
        (largest < smallest).then(|| {
            format!(
                "[robustness]: offsets up to {} mm reach the goal, those from {} mm miss it: find the limit with \
                 --delta",
                Millimetres(largest),
                Millimetres(smallest)
            )
        })
    }

    /// Largest final position error (m) of the scenarios that miss the goal without another cause.
    fn worst_error(&self) -> Option<f64> {
        let tolerance = self.plan.problem.success().orientation;
        let turned = self.stuck.iter().any(|stuck| stuck.end.orientation_error_rad > tolerance);
        self.stuck.iter().map(|stuck| stuck.end.position_error_m).max_by(f64::total_cmp).filter(|_| !turned)
    }
}

fn position_error(state: &State, goal: &Pose) -> f64 {
    norm(&[0, 1, 2].map(|axis| state[axis] - goal[axis]))
}

/// Shortest edge of the smallest box along the axes that holds some parts (m).
fn thickness(parts: &[Part]) -> f64 {
    let corners = || parts.iter().flat_map(|part| part.shape.vertices());
    let extent = |axis: usize| {
        let coordinates = corners().map(|corner| corner[axis]);
        coordinates.clone().fold(f64::NEG_INFINITY, f64::max) - coordinates.fold(f64::INFINITY, f64::min)
    };
    (0..3).map(extent).fold(f64::INFINITY, f64::min)
}

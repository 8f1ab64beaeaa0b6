//! The worst group of rollouts of the best plan, found by playing some of its failures again.

use plan::directions::direction;
use plan::records::{GraspRecord, LossRecord, MotionEnd};
use plan::{Problem, RobustnessTarget, SuccessRate, interval, rate};
use simulation::{Injection, LIMIT_SLACK, Settings, TestCase};
use task::algebra::norm;
use task::{ScenarioTrajectory, Trajectory};

use crate::candidate::Evaluated;

/// Failing test cases that are played again.
const PLAYED: usize = 8;
/// Smoothing of the distances in rollouts, which are not used here (N m).
const TAU: f64 = 1e-6;
/// Length of the mean of unit vectors from which on they have a direction in common.
const COMMON: f64 = 0.5;

/// The worst group of rollouts of the best plan. `None` where no rollout failed, as when time ended before any.
pub fn loss(problem: &Problem, target: &RobustnessTarget, best: &Evaluated) -> Option<LossRecord> {
    let groups = best.rates.by_friction().min_by(|one, other| rate(one).total_cmp(&rate(other)))?;
    let rate_of = |group: &SuccessRate| rate(std::slice::from_ref(group));
    let lossy = groups.iter().filter(|group| group.successes < group.rollouts);
    let order = |group: &&SuccessRate| (rate_of(group), group.rollouts);
    let worst = lossy.min_by(|one, other| {
        let ((one, few), (other, many)) = (order(one), order(other));
        one.total_cmp(&other).then(many.cmp(&few))
    });
    let worst = worst?.clone();
    let is_worst = |case: &&TestCase| target.frictions.get(case.friction.0) == Some(&worst.friction);
    let failing: Vec<TestCase> = best.failing.iter().filter(is_worst).copied().collect();
    let mut world = problem.world();
    world.horizon = best.reference.horizon();
    let settings = Settings { friction: worst.friction, ..Settings::default() };
    // The arm has reached the start before.
    let rollout = problem.rollout_in(&world, settings).ok()?;
    let injections: Vec<Injection> = failing.iter().take(PLAYED).map(TestCase::injection).collect();
    let Trajectory { scenarios, time_step, .. } = rollout.trajectory(&best.reference, &injections, TAU);
    let error = |motion: &ScenarioTrajectory| motion.quality.position_error;
    let shown = injections.iter().zip(&scenarios).max_by(|one, other| error(one.1).total_cmp(&error(other.1)));
    let (Injection { grasp, disturbance }, motion) = shown?;
    let contact_force_share = target.parameters.evaluation.force_share;
    Some(LossRecord {
        rate: rate(groups),
        worst_interval: interval(std::slice::from_ref(&worst)),
        worst,
        offset_direction: common_direction(&failing),
        grasp: GraspRecord::from(grasp),
        inertia_error: disturbance.inertia,
        stiffness_error: disturbance.stiffness,
        delay_s: disturbance.delay,
        bias: disturbance.bias,
        edge_radius_m: disturbance.edge_radius,
        max_force_n: motion.quality.max_force,
        contact_force_share,
        exceeds_contact_force: motion.quality.max_force
            > (1.0 + LIMIT_SLACK) * contact_force_share * world.limits.contact_force,
        end: MotionEnd::new(&world, motion, time_step, &problem.success()),
    })
}

fn common_direction(failing: &[TestCase]) -> Option<String> {
    let mut mean = [0.0; 3];
    for case in failing {
        let length = norm(&case.grasp.offset);
        if length > 0.0 {
            (0..3).for_each(|axis| mean[axis] += case.grasp.offset[axis] / length / failing.len() as f64);
        }
    }
    direction(&mean).filter(|_| norm(&mean) > COMMON)
}

//! How well a plan succeeds as it is exported: rollouts with hard contact of exactly this reference.

use plan::{PlannerError, Problem};
use serde::Serialize;
use simulation::{Settings, larger, offsets, wilson_interval};
use store::StoredPlan;
use task::GraspError;
use workers::Workers;

use crate::smooth::SmoothReference;

/// Random grasp errors at each friction, besides the planned ones, and their seed.
const RANDOM: usize = 20;
const SEED: u64 = 20;
/// Straight pieces of the reference between two knots of the plan.
const PIECES: usize = 4;
/// Lowest success rate at any friction of a plan that is exported without `--anyway`.
pub const LEAST_RATE: f64 = 0.95;

/// Results of rollouts of a reference, over all planned and some random grasp errors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TrialRecord {
    /// Success rates, one per friction.
    pub rates: Vec<RateRecord>,
    /// Largest force of a contact in all rollouts, the mean over 10 ms (N).
    pub contact_force_n: f64,
    /// Its limit in the scene (N), if there is one.
    pub contact_force_limit_n: Option<f64>,
}

/// Success at one friction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RateRecord {
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Largest offset (m).
    pub magnitude_m: f64,
    /// Largest rotation error (rad).
    pub turn_rad: f64,
    /// Rollouts.
    pub rollouts: usize,
    /// Those that reach the goal.
    pub successes: usize,
    /// Wilson's 95 % confidence interval of the rate.
    pub interval: [f64; 2],
}

impl RateRecord {
    /// Successes over rollouts.
    pub fn rate(&self) -> f64 {
        self.successes as f64 / self.rollouts.max(1) as f64
    }
}

impl TrialRecord {
    /// Plays a reference, at the frictions that a robust plan was refined for, else at those of the scene.
    ///
    /// # Errors
    /// When the arm does not reach the start, or the reference is too long.
    pub fn new(plan: &StoredPlan, problem: &Problem, reference: &SmoothReference) -> Result<Self, PlannerError> {
        let grasps = grasps(plan, problem);
        let (played, success, limits) = (reference.pieces(PIECES), problem.success(), problem.task().limits);
        let workers = Workers::new(std::thread::available_parallelism().map_or(1, usize::from));
        let mut contact_force_n = 0.0_f64;
        let mut rates = Vec::new();
        for friction in frictions(plan, problem) {
            let settings = Settings { friction, ..Settings::default() };
            settings.validate_for(&played)?;
            let outcomes = problem.rollout(settings)?.simulate(&played, &grasps, &workers);
            contact_force_n = outcomes.iter().map(|outcome| outcome.loads.contact_force).fold(contact_force_n, larger);
            let successes = outcomes.iter().filter(|outcome| outcome.succeeds(&success, &limits)).count();
            let (magnitude_m, turn_rad) = (problem.offset_magnitude(), problem.scene().robustness.rotation_error);
            let interval = wilson_interval(successes, outcomes.len());
            rates.push(RateRecord { friction, magnitude_m, turn_rad, rollouts: outcomes.len(), successes, interval });
        }
        let limit = limits.contact_force;
        Ok(Self { rates, contact_force_n, contact_force_limit_n: Some(limit).filter(|limit| limit.is_finite()) })
    }

    /// Frictions at which the plan succeeds too rarely, in words.
    pub fn low_rates(&self) -> Vec<String> {
        let is_low = |rate: &&RateRecord| !(rate.rate() >= LEAST_RATE);
        let in_words = |rate: &RateRecord| {
            let RateRecord { friction, successes, rollouts, .. } = rate;
            format!("at friction {friction}, {successes} of {rollouts} rollouts with hard contact reach the goal")
        };
        self.rates.iter().filter(is_low).map(in_words).collect()
    }

    /// The force of a contact in rollouts, in words, if it is beyond its limit.
    pub fn excess(&self) -> Option<String> {
        let Self { contact_force_n, contact_force_limit_n, .. } = self;
        let limit = contact_force_limit_n.filter(|limit| !(contact_force_n <= limit))?;
        Some(format!("in rollouts the force of a contact reaches {contact_force_n:.0} N, its limit is {limit:.0} N"))
    }
}

fn frictions(plan: &StoredPlan, problem: &Problem) -> Vec<f64> {
    let refined = plan.result.robust.iter().flat_map(|robust| robust.after.by_friction());
    let refined: Vec<f64> = refined.filter_map(|groups| groups.first()).map(|group| group.friction).collect();
    if refined.is_empty() { problem.scene().robustness.frictions.clone() } else { refined }
}

/// The planned grasp errors, and random offsets of those that the scene covers with random rotations.
fn grasps(plan: &StoredPlan, problem: &Problem) -> Vec<GraspError> {
    let planned: Vec<GraspError> = plan.result.scenarios.iter().map(|scenario| (&scenario.grasp).into()).collect();
    let offsets: Vec<[f64; 3]> = problem.task().grasps.iter().map(|grasp| grasp.offset).collect();
    let random = offsets::covered(&problem.scene().coverage, &offsets, problem.offset_magnitude(), RANDOM, SEED);
    let turns = offsets::ball(problem.scene().robustness.rotation_error, RANDOM, SEED);
    let random = random.into_iter().zip(turns).map(|(offset, rotation)| GraspError { offset, rotation });
    GraspError::distinct(planned.into_iter().chain(random))
}

//! What a refined plan loses: where, and what holds the body there.

use serde::{Deserialize, Serialize};
use simulation::{Disturbance, Injection, Settings, Trial};
use task::algebra::norm;
use task::{GraspError, ScenarioTrajectory, Trajectory};

use crate::explain::stuck::MotionEnd;
use crate::explain::words::direction;
use crate::files::GraspRecord;
use crate::or_null;
use crate::problem::Problem;
use crate::refine::{EVALUATION_FORCE_SHARE, Kept};
use crate::success_rates::{SuccessRate, interval, rate};

/// Failing trials that are played again.
const PLAYED: usize = 8;
/// Smoothing of the distances in rollouts, which say nothing here (N m).
const TAU: f64 = 1e-6;
/// Length of the mean of unit vectors from which on they have a direction in common.
const COMMON: f64 = 0.5;
/// Fraction of a limit by which a rollout may exceed it.
const LIMIT_SLACK: f64 = 1e-3;

/// What a plan loses most, and a rollout that shows it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LossRecord {
    /// Success rate at the friction where it is smallest.
    pub rate: f64,
    /// The group of rollouts at that friction with the smallest success rate.
    pub worst: SuccessRate,
    /// Wilson's 95 % confidence interval of the success rate of that group.
    pub worst_interval: [f64; 2],
    /// Axes of the body along which failing offsets at that friction lie; null where they have none in common.
    pub offset_direction: Option<String>,
    /// Of the failing rollout at that friction that ends farthest from the goal.
    #[serde(flatten)]
    pub grasp: GraspRecord,
    /// Its relative error of the inertia.
    pub inertia_error: f64,
    /// Its relative error of the stiffness.
    pub stiffness_error: f64,
    /// Its delay of an arm's controller.
    pub delay_s: f64,
    /// Its radius of edges.
    pub edge_radius_m: f64,
    /// Its largest contact force.
    #[serde(with = "or_null")]
    pub max_force_n: f64,
    /// Whether that exceeds what rollouts may use of `limits.contact_force`.
    pub exceeds_contact_force: bool,
    /// How it ends.
    pub end: MotionEnd,
}

/// What the best plan loses most. `None` where no rollout failed, as when time ended before any.
pub fn loss(problem: &Problem, frictions: &[f64], best: &Kept) -> Option<LossRecord> {
    let groups = best.rates.by_friction().min_by(|one, other| rate(one).total_cmp(&rate(other)))?;
    let rate_of = |group: &SuccessRate| rate(std::slice::from_ref(group));
    let lossy = groups.iter().filter(|group| group.successes < group.rollouts);
    let order = |group: &&SuccessRate| (rate_of(group), group.rollouts);
    let worst = lossy.min_by(|one, other| {
        let ((one, few), (other, many)) = (order(one), order(other));
        one.total_cmp(&other).then(many.cmp(&few))
    });
    let worst = worst?.clone();
    let is_worst = |trial: &&Trial| frictions.get(trial.friction) == Some(&worst.friction);
    let failing: Vec<Trial> = best.failing.iter().filter(is_worst).copied().collect();
    let mut world = problem.world();
    world.horizon = best.reference.horizon();
    let settings = Settings { friction: worst.friction, ..Settings::default() };
    // The arm has reached the start before.
    let rollout = problem.rollout_in(&world, settings).ok()?;
    let injections: Vec<Injection> = failing.iter().take(PLAYED).map(Trial::injection).collect();
    let Trajectory { scenarios, time_step, .. } = rollout.trajectory(&best.reference, &injections, TAU);
    let error = |motion: &ScenarioTrajectory| motion.quality.position_error;
    let shown = injections.iter().zip(&scenarios).max_by(|one, other| error(one.1).total_cmp(&error(other.1)));
    let (Injection { grasp, disturbance }, motion) = shown?;
    Some(LossRecord {
        rate: rate(groups),
        worst_interval: interval(std::slice::from_ref(&worst)),
        worst,
        offset_direction: common_direction(&failing),
        grasp: GraspRecord::from(grasp),
        inertia_error: disturbance.inertia,
        stiffness_error: disturbance.stiffness,
        delay_s: disturbance.delay,
        edge_radius_m: disturbance.edge_radius,
        max_force_n: motion.quality.max_force,
        exceeds_contact_force: motion.quality.max_force
            > (1.0 + LIMIT_SLACK) * EVALUATION_FORCE_SHARE * world.limits.contact_force,
        end: MotionEnd::new(&world, motion, time_step, &problem.success()),
    })
}

fn common_direction(failing: &[Trial]) -> Option<String> {
    let mut mean = [0.0; 3];
    for trial in failing {
        let length = norm(&trial.grasp.offset);
        if length > 0.0 {
            (0..3).for_each(|axis| mean[axis] += trial.grasp.offset[axis] / length / failing.len() as f64);
        }
    }
    direction(&mean).filter(|_| norm(&mean) > COMMON)
}

impl LossRecord {
    /// Two sentences without full stops: what is lost most, and how a rollout ends.
    pub fn sentences(&self) -> [String; 2] {
        let SuccessRate { friction, rollouts, successes, .. } = self.worst;
        let common = self.offset_direction.as_ref();
        let common =
            common.map_or_else(String::new, |axes| format!("; failing offsets lie towards {axes} of the body"));
        let most = format!(
            "most is lost at friction {friction}, where {:.1} % succeed, and there with {}, \
             {successes} of {rollouts} (95 % confidence: {:.0} to {:.0} %){common}",
            100.0 * self.rate,
            self.worst.offsets_in_words(),
            100.0 * self.worst_interval[0],
            100.0 * self.worst_interval[1]
        );
        let force = match self.exceeds_contact_force {
            true => format!(
                "; pushes with {:.1} N, more than {:.0} % of limits.contact_force",
                self.max_force_n,
                100.0 * EVALUATION_FORCE_SHARE
            ),
            false => String::new(),
        };
        let injected = [vec![self.grasp.to_string()], self.disturbance_in_words()].concat().join(", ");
        [most, format!("with the {injected}, the body {}{force}", self.end)]
    }

    /// The errors of that rollout.
    pub fn injection(&self) -> Injection {
        let Self {
            inertia_error: inertia, stiffness_error: stiffness, delay_s: delay, edge_radius_m: edge_radius, ..
        } = *self;
        Injection {
            grasp: GraspError::from(&self.grasp),
            disturbance: Disturbance { inertia, stiffness, delay, edge_radius, ..Disturbance::default() },
        }
    }

    /// How robot, controller and edges differ there, such as `+10 % of inertia`; nothing where they do not.
    pub fn disturbance_in_words(&self) -> Vec<String> {
        [
            (self.inertia_error, format!("{:+.0} % of inertia", 100.0 * self.inertia_error)),
            (self.stiffness_error, format!("{:+.0} % of stiffness", 100.0 * self.stiffness_error)),
            (self.delay_s, format!("{:.1} ms of delay", 1e3 * self.delay_s)),
            (self.edge_radius_m, format!("{:.3} mm of radius of edges", 1e3 * self.edge_radius_m)),
        ]
        .into_iter()
        .filter_map(|(size, words)| (size != 0.0).then_some(words))
        .collect()
    }
}

//! Where a motion stops approaching its goal, and what holds it there.

use std::fmt;

use serde::{Deserialize, Serialize};
use simulation::Success;
use task::algebra::norm;
use task::{AssemblyTask, Pose, ScenarioTrajectory, State};

use crate::directions::direction;
use crate::or_null;

/// A motion approaches its goal as long as its errors, each in tolerances, still fall by this sum.
const NEARER: f64 = 0.5;
/// Share of the steps at the end in which a motion that still comes nearer is not stuck.
const END: f64 = 0.05;
/// Contact forces below this share of the largest do not hold the body.
const MINOR: f64 = 0.2;
/// Contact forces below this do not either (N).
const PUSHING: f64 = 1e-2;
/// Pairs nearer than this touch (m).
const TOUCHING: f64 = 5e-4;
/// Pairs that are named.
const NAMED: usize = 3;
/// Cosine of the angle between two directions from which on they are against each other.
const AGAINST: f64 = -0.5;

/// The end of a motion that misses the goal. Forces are means from the time at which it gets stuck.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionEnd {
    /// Final distance from the goal.
    #[serde(with = "or_null")]
    pub position_error_m: f64,
    /// Final angle to the goal.
    #[serde(with = "or_null")]
    pub orientation_error_rad: f64,
    /// Axes of the world along which the goal lies from there; null at the goal.
    pub goal_direction: Option<String>,
    /// Time from which on it comes no nearer; null where it still comes nearer at the end.
    pub from_s: Option<f64>,
    /// Pairs that hold it, the largest force first.
    pub held_by: Vec<HoldRecord>,
    /// Force of the impedance controller.
    #[serde(with = "or_null")]
    pub controller_force_n: f64,
    /// Axes of the world along which the controller pushes; null without a force.
    pub controller_direction: Option<String>,
    /// Whether the controller pushes against the contacts.
    pub pushes_against_contact: bool,
}

/// A pair that holds the body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HoldRecord {
    /// Body and environment part.
    pub pair: String,
    /// Mean normal force.
    #[serde(with = "or_null")]
    pub force_n: f64,
}

impl MotionEnd {
    /// From a motion of a task in steps of `time_step` (s).
    pub fn new(task: &AssemblyTask, motion: &ScenarioTrajectory, time_step: f64, success: &Success) -> Self {
        let last = motion.states.len() - 1;
        let from = stuck_step(task, &motion.states, success);
        let later = motion.wrenches.iter().skip(from);
        let controller: [f64; 3] = std::array::from_fn(|axis| mean(later.clone().map(|wrench| wrench[axis])));
        let later = motion.contacts.iter().skip(from);
        let force = |pair: usize| mean(later.clone().map(|contacts| contacts[pair].force));
        let forces: Vec<f64> = (0..task.pairs.len()).map(force).collect();
        let end = motion.states[last].pose();
        let missing: [f64; 3] = std::array::from_fn(|axis| task.goal[axis] - end[axis]);
        let holding = holding(task, &end, &forces, &missing);
        let contact = contact_force(task, &end, &holding, &forces);
        let product: f64 = (0..3).map(|axis| contact[axis] * controller[axis]).sum();
        let hold = |&pair: &usize| HoldRecord { pair: task.pairs[pair].to_string(), force_n: forces[pair] };
        Self {
            position_error_m: motion.quality.position_error,
            orientation_error_rad: motion.quality.orientation_error,
            goal_direction: direction(&missing),
            from_s: ((from as f64) < (1.0 - END) * last as f64).then_some(from as f64 * time_step),
            held_by: holding.iter().take(NAMED).map(hold).collect(),
            controller_force_n: norm(&controller),
            controller_direction: direction(&controller),
            pushes_against_contact: product < AGAINST * norm(&contact) * norm(&controller),
        }
    }
}

/// Indices of the pairs that hold a body at a pose, the largest force (N) first: those that push, those that penetrate, and
/// those that touch on the side of the goal, which lies in the direction `missing`.
fn holding(task: &AssemblyTask, pose: &Pose, forces: &[f64], missing: &[f64; 3]) -> Vec<usize> {
    let largest = forces.iter().copied().fold(0.0, f64::max);
    let is_in_the_way = |pair: usize| {
        let distance = task.pairs[pair].shapes.exact_distance(pose);
        let normal = normal(task, pose, pair);
        let along: f64 = (0..3).map(|axis| normal[axis] * missing[axis]).sum();
        distance < -TOUCHING || distance < TOUCHING && along < AGAINST * norm(missing)
    };
    let holds = |&pair: &usize| forces[pair] >= PUSHING.max(MINOR * largest) || is_in_the_way(pair);
    let mut pairs: Vec<usize> = (0..forces.len()).filter(holds).collect();
    pairs.sort_by(|&one, &other| forces[other].total_cmp(&forces[one]));
    pairs
}

/// The step from which on the motion comes no nearer to its goal.
fn stuck_step(task: &AssemblyTask, states: &[State], success: &Success) -> usize {
    let miss = |state: &State| {
        let error = state.pose().error(&task.goal);
        error.position / success.position + error.orientation / success.orientation
    };
    let misses: Vec<f64> = states.iter().map(miss).collect();
    let least = misses.iter().copied().fold(f64::INFINITY, f64::min);
    misses.iter().position(|&miss| miss <= least + NEARER).unwrap_or(0)
}

/// Sum of the normal forces of some pairs on the body at a pose (N, world frame).
fn contact_force(task: &AssemblyTask, pose: &Pose, pairs: &[usize], forces: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for &pair in pairs {
        let normal = normal(task, pose, pair);
        (0..3).for_each(|axis| sum[axis] += forces[pair] * normal[axis]);
    }
    sum
}

/// Direction in which a pair pushes the body at a pose (world frame); zero where there is no distance.
fn normal(task: &AssemblyTask, pose: &Pose, pair: usize) -> [f64; 3] {
    /// Smoothing with which normals hardly differ from those of the exact shapes (N m).
    const TAU: f64 = 1e-6;
    let distance = task.pairs[pair].shapes.distance(pose, TAU);
    distance.map_or([0.0; 3], |distance| std::array::from_fn(|axis| distance.contact_normal[axis]))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (count, sum) = values.fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value));
    if count > 0.0 { sum / count } else { 0.0 }
}

impl fmt::Display for HoldRecord {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self.force_n >= PUSHING {
            true => write!(formatter, "{} with {:.2} N", self.pair, self.force_n),
            false => write!(formatter, "{}", self.pair),
        }
    }
}

impl fmt::Display for MotionEnd {
    /// The rest of a sentence whose subject is the motion.
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self.from_s {
            Some(time) => write!(formatter, "comes no nearer from {time:.2} s on")?,
            None => write!(formatter, "comes nearer until the end")?,
        }
        let (position, orientation) = (1e3 * self.position_error_m, self.orientation_error_rad);
        write!(formatter, ", {position:.2} mm and {orientation:.4} rad from the goal")?;
        if let Some(direction) = &self.goal_direction {
            write!(formatter, ", which lies towards {direction}")?;
        }
        let pairs: Vec<String> = self.held_by.iter().map(HoldRecord::to_string).collect();
        match pairs.is_empty() {
            true => write!(formatter, "; nothing holds it")?,
            false => write!(formatter, "; held by {}", pairs.join(", "))?,
        }
        let against = if self.pushes_against_contact { " against that" } else { "" };
        match &self.controller_direction {
            Some(direction) => {
                let force = self.controller_force_n;
                write!(formatter, "; the controller pushes{against} with {force:.2} N towards {direction}")
            }
            None => Ok(()),
        }
    }
}

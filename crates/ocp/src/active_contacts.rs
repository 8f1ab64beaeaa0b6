//! Broad phase: which pairs may touch before which step of which scenario.
//!
//! Most pairs of parts with many pieces never touch, and the others touch for a part of the motion only, but each contact
//! costs variables, constraints and distances. A homotopy step has the contacts that come near in the motion it starts
//! from. If a pair penetrates where it has no contact in the solution, its contacts are added and the solve continues, so
//! that no contact that matters is left out.

use std::ops::{Range, RangeInclusive};

use task::{AssemblyTask, Pose, Scenario, Trajectory, pose};

/// Pairs that come nearer than this fraction of the size of the largest part of the body may touch.
const NEAR: f64 = 0.0125;
/// They have contacts where they are nearer than this multiple of that distance to the motion of the step before: motions shift
/// from one homotopy step to the next, and contacts that were missing are found by solving again.
const AROUND: f64 = 8.0;
/// Up to this number of pairs, a pair that comes near at all has contacts in all steps: as the motion shifts, contacts
/// come and go between homotopy steps, and few pairs save less than the repeated solves cost.
const FEW_PAIRS: usize = 16;
/// Contacts begin this number of steps earlier and end as much later than pairs are near: motions shift in time, too.
const STEPS_AROUND: usize = 4;
/// A motion from rest may be earlier or later than one of constant speed by one of this many parts of all steps.
const FIRST_STEPS_AROUND: usize = 4;

/// The pairs that have a contact in each step of each scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ActiveContacts {
    pairs: usize,
    scenarios: usize,
    /// The pairs, ascending, of every stage and scenario: at `(stage - 1) n_s + scenario`.
    active: Vec<Vec<usize>>,
}

impl ActiveContacts {
    /// Every pair at every stage.
    pub fn all(task: &AssemblyTask) -> Self {
        Self::from_fn(task, |_, _, _| true)
    }

    /// Those that a motion from a rest at the start may have: pairs that come near on the straight paths of all scenarios,
    /// around the time at which a motion of constant speed is there. Of few pairs, all.
    pub fn on_straight_paths(task: &AssemblyTask) -> Self {
        if task.pairs.len() <= FEW_PAIRS {
            return Self::all(task);
        }
        let steps = task.horizon.steps;
        let share = |step: usize| step as f64 / steps as f64;
        let believed =
            |step| Pose::from(&pose::interpolate(&task.start.isometry(), &task.goal.isometry(), share(step)));
        let path: Vec<Pose> = (0..=steps).map(believed).collect();
        let motion = |scenario: Scenario| path.iter().map(|pose| scenario.grasp.actual(pose)).collect();
        let motions: Vec<Vec<Pose>> = task.scenarios().into_iter().map(motion).collect();
        // The body may deviate from its path as far as it is off in the gripper.
        let deviation = task.offsets().into_iter().map(|offset| task::algebra::norm(&offset)).fold(0.0, f64::max);
        let near = reach(task) + deviation;
        Self::around(task, &motions, [near, near], steps / FIRST_STEPS_AROUND)
    }

    /// Those near a motion, from the poses of every scenario at k = 0..N.
    pub fn near(task: &AssemblyTask, motions: &[Vec<Pose>]) -> Self {
        let near = reach(task);
        Self::around(task, motions, [near, AROUND * near], STEPS_AROUND)
    }

    /// Those of pairs that come nearer in some motions than the first distance (m), where they are nearer than the second or are
    /// within some steps. The contact of a stage is at the pose before its step.
    fn around(task: &AssemblyTask, motions: &[Vec<Pose>], [near, nearby]: [f64; 2], steps_around: usize) -> Self {
        let poses = pose::arrays(&motions.concat());
        let (steps, length) = (task.horizon.steps, task.horizon.steps + 1);
        let distances = task.pairs.iter().map(|pair| pair.shapes.exact_distances(&poses));
        let distances: Vec<_> = distances.map(|distances| comes_near(&distances, near).then_some(distances)).collect();
        Self::from_fn(task, |stage, scenario, pair| {
            let Some(distances) = &distances[pair] else { return false };
            let before = stage - 1;
            let around = before.saturating_sub(steps_around)..=(before + steps_around).min(steps);
            let of_scenario = &distances[scenario * length..][around];
            task.pairs.len() <= FEW_PAIRS || comes_near(of_scenario, nearby)
        })
    }

    /// These and those of other pairs that penetrate in a motion. `None` when there are none.
    pub fn with_missing(&self, motion: &Trajectory) -> Option<Self> {
        let mut more = self.clone();
        for (scenario, motion) in motion.scenarios.iter().enumerate() {
            // Contacts of a trajectory are at the end of its steps. The last one has no step after it.
            let stages = motion.contacts.len();
            for (index, contacts) in motion.contacts[..stages - 1].iter().enumerate() {
                let stage = index + 2;
                let penetrating = (0..self.pairs).filter(|&pair| !(contacts[pair].distance >= 0.0));
                for pair in penetrating.filter(|&pair| self.slot(stage, scenario, pair).is_none()) {
                    match self.pairs {
                        ..=FEW_PAIRS => more.add(pair, 1..=stages, 0..self.scenarios),
                        _ => {
                            let around = stage.saturating_sub(STEPS_AROUND).max(1)..=(stage + STEPS_AROUND).min(stages);
                            more.add(pair, around, scenario..scenario + 1);
                        }
                    }
                }
            }
        }
        (more != *self).then_some(more)
    }

    /// The pairs with a contact at a stage (from 1) of a scenario, ascending.
    pub fn of(&self, stage: usize, scenario: usize) -> &[usize] {
        &self.active[(stage - 1) * self.scenarios + scenario]
    }

    /// The number of a pair among those with a contact there, from 0.
    pub fn slot(&self, stage: usize, scenario: usize, pair: usize) -> Option<usize> {
        self.of(stage, scenario).binary_search(&pair).ok()
    }

    /// Number of contacts.
    pub fn count(&self) -> usize {
        self.active.iter().map(Vec::len).sum()
    }

    fn add(&mut self, pair: usize, stages: RangeInclusive<usize>, scenarios: Range<usize>) {
        for stage in stages {
            for scenario in scenarios.clone() {
                let pairs = &mut self.active[(stage - 1) * self.scenarios + scenario];
                if let Err(slot) = pairs.binary_search(&pair) {
                    pairs.insert(slot, pair);
                }
            }
        }
    }

    /// Where a function of stage (from 1), scenario and pair (from 0) says so.
    pub fn from_fn(task: &AssemblyTask, is_active: impl Fn(usize, usize, usize) -> bool) -> Self {
        let (pairs, scenarios) = (task.pairs.len(), task.grasps.len() * task.frictions.len());
        let stages = (1..=task.horizon.steps).flat_map(|stage| (0..scenarios).map(move |scenario| (stage, scenario)));
        let of_stage = |(stage, scenario)| (0..pairs).filter(|&pair| is_active(stage, scenario, pair)).collect();
        Self { pairs, scenarios, active: stages.map(of_stage).collect() }
    }
}

/// Distance (m) below which exact shapes are near. Smoothed distances are longer, with much smoothing even between parts that
/// penetrate.
fn reach(task: &AssemblyTask) -> f64 {
    NEAR * task.pairs.iter().map(|pair| pair.shapes.body().size()).fold(0.0, f64::max)
}

/// Whether one of some distances (m) is below another one. A distance that cannot be computed counts as near.
fn comes_near(distances: &[f64], reach: f64) -> bool {
    !distances.iter().all(|distance| *distance >= reach)
}

//! Variants that are planned where the plan of the scene cannot be refined: problems whose plans may have more margin.
//! Which of them helps differs from scene to scene.

use std::fmt;

use plan::Variant;
use plan::parameters::PortfolioParameters;
use serde::{Deserialize, Serialize};
use simulation::Reference;
use task::algebra::norm;
use task::{CostWeights, GraspError, HomotopySettings};

/// A change of the problem, in scenarios, horizon, weights, smoothing or first guess.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Recipe {
    HalfTheTimeStep,
    StraightFirstGuess,
    FailingOffsetsFromRefinedPlan,
    FailingOffsets,
    NoneAndHalfOffsets,
    MoreOffset,
    TwiceTheTime,
    SlowMotion,
    HalfTheFirstSmoothing,
    TwiceTheFirstSmoothing,
}

/// The variants, the promising first.
pub const PORTFOLIO: [Recipe; 10] = [
    Recipe::HalfTheTimeStep,
    Recipe::StraightFirstGuess,
    Recipe::FailingOffsetsFromRefinedPlan,
    Recipe::FailingOffsets,
    Recipe::NoneAndHalfOffsets,
    Recipe::MoreOffset,
    Recipe::TwiceTheTime,
    Recipe::SlowMotion,
    Recipe::HalfTheFirstSmoothing,
    Recipe::TwiceTheFirstSmoothing,
];

impl Recipe {
    /// The changed problem. `refined` is the best reference so far, and `failing` are grasp errors at which it fails.
    pub fn variant(
        self,
        scene: &Variant,
        refined: &Reference,
        failing: &[GraspError],
        parameters: &PortfolioParameters,
    ) -> Variant {
        let mut variant = scene.clone();
        self.change(&mut variant, failing, parameters);
        variant.task.grasps = GraspError::distinct(variant.task.grasps);
        let task = &variant.task;
        let first_guess = match self {
            Self::StraightFirstGuess => Some(Reference::straight(&task.start, &task.goal, task.horizon)),
            Self::FailingOffsetsFromRefinedPlan => Some(refined.clone()),
            _ => None,
        };
        match first_guess {
            Some(reference) => variant.started_from(&reference),
            None => Variant { near: None, ..variant },
        }
    }

    fn change(self, variant: &mut Variant, failing: &[GraspError], parameters: &PortfolioParameters) {
        let (task, settings) = (&mut variant.task, &mut variant.settings);
        let scaled = |grasps: &[GraspError], factor: f64| -> Vec<GraspError> {
            grasps.iter().map(|grasp| grasp.scaled(factor)).collect()
        };
        match self {
            Self::HalfTheTimeStep => {
                task.horizon.steps *= 2;
                task.horizon.time_step *= 0.5;
            }
            Self::StraightFirstGuess => {}
            Self::FailingOffsetsFromRefinedPlan => {
                add_failures(&mut task.grasps, failing, parameters.added_failures);
                end_of_homotopy(settings, parameters);
            }
            Self::FailingOffsets => add_failures(&mut task.grasps, failing, parameters.added_failures),
            Self::NoneAndHalfOffsets => {
                let half = scaled(&task.grasps, 0.5);
                task.grasps.push(GraspError::default());
                task.grasps.extend(half);
            }
            Self::MoreOffset => task.grasps = scaled(&task.grasps, parameters.offset_margin),
            Self::TwiceTheTime => task.horizon.steps *= 2,
            Self::SlowMotion => {
                slow_down(&mut task.cost.reference, parameters.slowness);
                slow_down(&mut task.cost.compliant, parameters.slowness);
            }
            Self::HalfTheFirstSmoothing => {
                settings.tau *= 0.5;
                settings.sigma *= 0.5;
            }
            Self::TwiceTheFirstSmoothing => {
                settings.tau *= 2.0;
                settings.sigma *= 2.0;
                settings.iterations += 1;
            }
        }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(match self {
            Self::HalfTheTimeStep => "half the time step",
            Self::StraightFirstGuess => "straight motion as first guess",
            Self::FailingOffsetsFromRefinedPlan => "failing offsets as scenarios, from the refined plan",
            Self::FailingOffsets => "failing offsets as scenarios",
            Self::NoneAndHalfOffsets => "no offset and half offsets as scenarios",
            Self::MoreOffset => "more offset",
            Self::TwiceTheTime => "twice the time",
            Self::SlowMotion => "slower motion",
            Self::HalfTheFirstSmoothing => "half the first smoothing",
            Self::TwiceTheFirstSmoothing => "twice the first smoothing",
        })
    }
}

/// Keeps the last homotopy steps only: more smoothing would lead away from a motion that is nearly a solution.
fn end_of_homotopy(settings: &mut HomotopySettings, parameters: &PortfolioParameters) {
    let iterations = settings.iterations.min(parameters.resolved_iterations);
    if let Some(first) = settings.schedule().nth(settings.iterations - iterations) {
        (settings.tau, settings.sigma, settings.mu_init) = (first.tau, first.sigma, parameters.resolved_barrier);
        settings.iterations = iterations;
    }
}

fn slow_down(weights: &mut CostWeights, slowness: f64) {
    weights.translational_velocity *= slowness;
    weights.rotational_velocity *= slowness;
}

/// Adds a few of the failing grasp errors, each as far from all scenarios as possible: offsets and rotations are
/// measured relative to the largest of each.
fn add_failures(grasps: &mut Vec<GraspError>, failing: &[GraspError], count: usize) {
    let largest = |part: fn(&GraspError) -> [f64; 3]| {
        let length = grasps.iter().chain(failing).map(|grasp| norm(&part(grasp))).fold(0.0, f64::max);
        if length > 0.0 { length } else { 1.0 }
    };
    let (offset, rotation) = (largest(|grasp| grasp.offset), largest(|grasp| grasp.rotation));
    let apart = |one: [f64; 3], other: [f64; 3]| norm(&[0, 1, 2].map(|axis| one[axis] - other[axis]));
    let distance = |one: &GraspError, other: &GraspError| {
        (apart(one.offset, other.offset) / offset).hypot(apart(one.rotation, other.rotation) / rotation)
    };
    for _ in 0..count {
        let nearest =
            |grasp: &GraspError| grasps.iter().map(|other| distance(grasp, other)).fold(f64::INFINITY, f64::min);
        let farthest = failing.iter().copied().max_by(|one, other| nearest(one).total_cmp(&nearest(other)));
        grasps.extend(farthest);
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use plan::{Choices, Problem};

    use super::*;

    /// Every recipe changes what it is named after, and nothing else of time, scenarios, weights and smoothing.
    #[test]
    fn recipes_change_what_they_are_named_after() {
        let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
        let problem = Problem::load(&scene, &Choices::default()).unwrap();
        let (scene, parameters) = (Variant::of_scene(&problem), PortfolioParameters::default());
        let task = &scene.task;
        let refined = Reference::straight(&task.start, &task.goal, task.horizon);
        let failing = [GraspError::from([0.0, 0.005, 0.0])];
        let offsets =
            |variant: &Variant| -> Vec<f64> { variant.task.grasps.iter().map(|grasp| norm(&grasp.offset)).collect() };
        let duration = |variant: &Variant| variant.task.horizon.steps as f64 * variant.task.horizon.time_step;
        for recipe in PORTFOLIO {
            let variant = recipe.variant(&scene, &refined, &failing, &parameters);
            let ratio = |of: fn(&Variant) -> f64| of(&variant) / of(&scene);
            let measured = [
                duration(&variant) / duration(&scene),
                ratio(|variant| variant.task.horizon.time_step),
                ratio(|variant| variant.task.cost.compliant.translational_velocity),
                ratio(|variant| variant.settings.tau),
            ];
            let [half, twice, slow] = [0.5, 2.0, parameters.slowness];
            let first = scene.settings.iterations - parameters.resolved_iterations;
            let end = scene.settings.schedule().nth(first).unwrap().tau / scene.settings.tau;
            let (expected, grasps, begins_from_motion) = match recipe {
                Recipe::HalfTheTimeStep => ([1.0, half, 1.0, 1.0], 2, false),
                Recipe::StraightFirstGuess => ([1.0; 4], 2, true),
                Recipe::FailingOffsetsFromRefinedPlan => ([1.0, 1.0, 1.0, end], 3, true),
                Recipe::FailingOffsets => ([1.0; 4], 3, false),
                Recipe::NoneAndHalfOffsets => ([1.0; 4], 5, false),
                Recipe::MoreOffset => ([1.0; 4], 2, false),
                Recipe::TwiceTheTime => ([twice, 1.0, 1.0, 1.0], 2, false),
                Recipe::SlowMotion => ([1.0, 1.0, slow, 1.0], 2, false),
                Recipe::HalfTheFirstSmoothing => ([1.0, 1.0, 1.0, half], 2, false),
                Recipe::TwiceTheFirstSmoothing => ([1.0, 1.0, 1.0, twice], 2, false),
            };
            let is_same = measured.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12);
            assert!(is_same, "{recipe}: {measured:?}");
            assert_eq!((variant.task.grasps.len(), variant.near.is_some()), (grasps, begins_from_motion), "{recipe}");
            let largest = offsets(&variant).into_iter().fold(0.0, f64::max);
            let factor = if recipe == Recipe::MoreOffset { parameters.offset_margin } else { 1.0 };
            assert!((largest - 0.02 * factor).abs() < 1e-12, "{recipe}: {largest}");
        }
    }

    #[test]
    fn failures_that_are_turned_are_far_from_scenarios_that_are_not() {
        let planned = GraspError::from([0.01, 0.0, 0.0]);
        let near = GraspError::from([0.008, 0.0, 0.0]);
        let turned = GraspError { rotation: [0.0, 0.02, 0.0], ..planned };
        let mut grasps = vec![planned];
        add_failures(&mut grasps, &[near, turned], 3);
        assert_eq!(grasps[..3], [planned, turned, near]);
    }
}

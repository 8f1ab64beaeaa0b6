//! What is planned where the plan of the scene cannot be refined: problems whose plans may have more margin. Which of
//! them helps differs from scene to scene.

use simulation::{Reference, Rollout, Settings, offsets};
use task::{AssemblyTask, CostWeights, HomotopySettings};

use crate::variant::Variant;

/// Failing offsets that a variant takes over as scenarios.
const ADDED_FAILURES: usize = 3;

/// Factor of the offsets that are planned with a margin.
const MARGIN: f64 = 1.1;

/// Factor of the weights of velocities in a slower plan.
const SLOWNESS: f64 = 10.0;

/// Iterations of the homotopy that begins at a motion.
const RESOLVED_ITERATIONS: usize = 2;

/// Its first barrier parameter: there are no multipliers yet.
const RESOLVED_BARRIER: f64 = 1e-2;

/// A way to change the problem, in scenarios, horizon, weights, smoothing or first guess.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

/// All of them, the promising first.
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
    /// The changed problem. `refined` is the best reference so far, and `failing` are offsets (m) at which it fails.
    pub fn variant(self, scene: &Variant, refined: &Reference, failing: &[[f64; 3]]) -> Variant {
        let mut variant = Variant { name: self.name().to_owned(), ..scene.clone() };
        self.change(&mut variant.task, &mut variant.settings, failing);
        variant.task.offsets = offsets::distinct(&variant.task.offsets);
        let task = &variant.task;
        let first_guess = match self {
            Self::StraightFirstGuess => Some(Reference::straight(&task.start, &task.goal, task.horizon)),
            Self::FailingOffsetsFromRefinedPlan => Some(refined.clone()),
            _ => None,
        };
        if first_guess.is_some() {
            // It is a motion on all steps.
            variant.settings.coarse_iterations = 0;
        }
        variant.near = first_guess.map(|reference| {
            Rollout::new(task, Settings::default()).trajectory(&reference, &task.offsets, variant.settings.tau)
        });
        variant
    }

    fn name(self) -> &'static str {
        match self {
            Self::HalfTheTimeStep => "half the time step",
            Self::StraightFirstGuess => "straight motion as first guess",
            Self::FailingOffsetsFromRefinedPlan => "failing offsets as scenarios, from the refined plan",
            Self::FailingOffsets => "failing offsets as scenarios",
            Self::NoneAndHalfOffsets => "no offset and half offsets as scenarios",
            Self::MoreOffset => "10 % more offset",
            Self::TwiceTheTime => "twice the time",
            Self::SlowMotion => "ten times the weight of velocities",
            Self::HalfTheFirstSmoothing => "half the first smoothing",
            Self::TwiceTheFirstSmoothing => "twice the first smoothing",
        }
    }

    fn change(self, task: &mut AssemblyTask, settings: &mut HomotopySettings, failing: &[[f64; 3]]) {
        let scaled = |offsets: &[[f64; 3]], factor: f64| -> Vec<[f64; 3]> {
            offsets.iter().map(|offset| offset.map(|component| factor * component)).collect()
        };
        match self {
            Self::HalfTheTimeStep => {
                task.horizon.steps *= 2;
                task.horizon.time_step *= 0.5;
            }
            Self::StraightFirstGuess => {}
            Self::FailingOffsetsFromRefinedPlan => {
                add_failures(&mut task.offsets, failing);
                end_of_homotopy(settings);
            }
            Self::FailingOffsets => add_failures(&mut task.offsets, failing),
            Self::NoneAndHalfOffsets => {
                let half = scaled(&task.offsets, 0.5);
                task.offsets.push([0.0; 3]);
                task.offsets.extend(half);
            }
            Self::MoreOffset => task.offsets = scaled(&task.offsets, MARGIN),
            Self::TwiceTheTime => task.horizon.steps *= 2,
            Self::SlowMotion => {
                slow_down(&mut task.cost.reference);
                slow_down(&mut task.cost.compliant);
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

/// Keeps the last iterations only: more smoothing would lead away from a motion that is nearly a solution.
fn end_of_homotopy(settings: &mut HomotopySettings) {
    let iterations = settings.iterations.min(RESOLVED_ITERATIONS);
    if let Some(first) = settings.schedule().nth(settings.iterations - iterations) {
        (settings.tau, settings.sigma, settings.mu_init) = (first.tau, first.sigma, RESOLVED_BARRIER);
        settings.iterations = iterations;
    }
}

fn slow_down(weights: &mut CostWeights) {
    weights.translational_velocity *= SLOWNESS;
    weights.rotational_velocity *= SLOWNESS;
}

/// Adds a few of the failing offsets, each as far from all scenarios as possible.
fn add_failures(offsets: &mut Vec<[f64; 3]>, failing: &[[f64; 3]]) {
    let distance = |one: &[f64; 3], other: &[f64; 3]| (0..3).map(|axis| (one[axis] - other[axis]).powi(2)).sum::<f64>();
    for _ in 0..ADDED_FAILURES {
        let nearest =
            |offset: &[f64; 3]| offsets.iter().map(|other| distance(offset, other)).fold(f64::INFINITY, f64::min);
        let farthest = failing.iter().copied().max_by(|one, other| nearest(one).total_cmp(&nearest(other)));
        offsets.extend(farthest);
    }
}

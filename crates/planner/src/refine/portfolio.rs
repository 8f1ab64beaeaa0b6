//! What is planned: the scene as it is and, where its plan cannot be refined, problems whose plans may have more margin.
//! Which of them helps differs from scene to scene.

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

impl Variant {
    /// With another name and something changed.
    fn changed(&self, name: &str, change: impl FnOnce(&mut AssemblyTask, &mut HomotopySettings)) -> Self {
        let mut variant = Self { name: name.to_owned(), ..self.clone() };
        change(&mut variant.task, &mut variant.settings);
        variant.task.offsets = offsets::distinct(&variant.task.offsets);
        variant
    }
}

/// Variants in scenarios, horizon, weights and smoothing. `failing` are offsets (m) at which the refined reference, the
/// best so far, fails.
pub fn portfolio(scene: &Variant, refined: &Reference, failing: &[[f64; 3]]) -> Vec<Variant> {
    let mut resolved = scene.changed("failing offsets as scenarios, from the refined plan", |task, settings| {
        add_failures(&mut task.offsets, failing);
        end_of_homotopy(settings);
    });
    let rollout = Rollout::new(&resolved.task, Settings::default());
    resolved.near = Some(rollout.trajectory(refined, &resolved.task.offsets, resolved.settings.tau));
    let scaled = |factor: f64| scene.task.offsets.iter().map(move |offset| offset.map(|component| factor * component));
    vec![
        resolved,
        scene.changed("failing offsets as scenarios", |task, _| add_failures(&mut task.offsets, failing)),
        scene.changed("no offset and half offsets as scenarios", |task, _| {
            task.offsets.push([0.0; 3]);
            task.offsets.extend(scaled(0.5));
        }),
        scene.changed("10 % more offset", |task, _| task.offsets = scaled(MARGIN).collect()),
        scene.changed("twice the time", |task, _| task.horizon.steps *= 2),
        scene.changed("half the time step", |task, _| {
            task.horizon.steps *= 2;
            task.horizon.time_step *= 0.5;
        }),
        scene.changed("ten times the weight of velocities", |task, _| {
            slow_down(&mut task.cost.reference);
            slow_down(&mut task.cost.compliant);
        }),
        scene.changed("half the first smoothing", |_, settings| {
            settings.tau *= 0.5;
            settings.sigma *= 0.5;
        }),
        scene.changed("twice the first smoothing", |_, settings| {
            settings.tau *= 2.0;
            settings.sigma *= 2.0;
            settings.iterations += 1;
        }),
    ]
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

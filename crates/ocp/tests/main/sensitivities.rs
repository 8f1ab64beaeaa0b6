//! The derivative of the optimal cost, beside optima of changed tasks.

use std::path::Path;

use nlp::{Control, Start};
use ocp::{Formulation, Homotopy, HomotopyStep, Transcription};
use task::{AssemblyTask, HomotopySettings};

/// Change of a task (m) between two optima, and that for the slope of the Lagrangian.
const CHANGE: f64 = 2e-5;
const STEP: f64 = 1e-6;

fn corner() -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    scene::Scene::load(&path).unwrap().task(None, None).unwrap()
}

fn solve(task: &AssemblyTask, settings: &HomotopySettings, start: Start) -> HomotopyStep {
    let homotopy = Homotopy::new(task, settings.clone());
    let steps = homotopy.run_from(&[], start, |_| Control::Continue, |_, _| Control::Continue).unwrap();
    let last = steps.into_iter().next_back().unwrap();
    assert!(last.status.is_success());
    last
}

#[test]
fn the_cost_of_an_optimum_follows_offsets_start_and_goal() {
    let task = corner();
    let rough = HomotopySettings { iterations: 1, coarse_iterations: 0, ..scene::default_homotopy() };
    let whole = Formulation::new(&task, rough.complementarity);
    let solved = solve(&task, &rough, Start::Cold(whole.initial_guess()));
    let settings = HomotopySettings { mu_init: 1e-9, ..rough };
    let solved = solve(&task, &settings, Start::Warm(solved.iterate));
    let near = whole.near(&solved.iterate.x);
    let point = near.point_of(&whole, &solved.iterate);
    let lagrangian = |task: &AssemblyTask| {
        let contacts = near.layout().contacts().clone();
        let formulation = Formulation::new(task, settings.complementarity).with_contacts(contacts);
        let mut transcription = Transcription::of(formulation, settings.complementarity, settings.hessian);
        transcription.set_smoothing(settings.tau, settings.sigma);
        transcription.lagrangian(&point).unwrap()
    };
    type Change = fn(&mut AssemblyTask, f64);
    let changes: [(&str, Change); 6] = [
        ("offset 1 x", |task, by| task.grasps[0].offset[0] += by),
        ("offset 1 z", |task, by| task.grasps[0].offset[2] += by),
        ("start x", |task, by| task.start.0[0] += by),
        ("start z", |task, by| task.start.0[2] += by),
        ("goal x", |task, by| task.goal.0[0] += by),
        ("goal z", |task, by| task.goal.0[2] += by),
    ];
    for (name, change) in changes {
        let changed = |by: f64| {
            let mut changed = task.clone();
            change(&mut changed, by);
            changed
        };
        let slope = (lagrangian(&changed(STEP)) - lagrangian(&changed(-STEP))) / (2.0 * STEP);
        let other = solve(&changed(CHANGE), &settings, Start::Warm(solved.iterate.clone()));
        let costs = other.objective - solved.objective;
        assert!((CHANGE * slope - costs).abs() < 0.05 * costs.abs(), "{name}: {costs} and {}", CHANGE * slope);
    }
}

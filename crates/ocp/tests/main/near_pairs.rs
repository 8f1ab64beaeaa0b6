//! Homotopy steps without the pairs that stay far apart.

use std::path::Path;

use nlp::{Control, Iterate, Start};
use ocp::{Homotopy, HomotopyStep};
use task::{AssemblyTask, ContactPair, HomotopySettings};

/// Index of the pair that [`with_a_far_pair`] adds.
const FAR: usize = 2;

fn corner() -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    scene::Scene::load(&path).unwrap().task(None, None).unwrap()
}

/// The corner with another wall behind the body, a metre away.
fn with_a_far_pair() -> AssemblyTask {
    let mut task = corner();
    let wall = &task.pairs[1];
    let shapes =
        collision::Pair::new(wall.shapes.body().clone(), wall.shapes.environment().placed([1.2, 0.0, 0.0], UNTURNED));
    let far = ContactPair { body: wall.body.clone(), environment: "far wall".to_owned(), shapes };
    task.pairs.push(far);
    assert_eq!(task.pairs.len(), FAR + 1);
    task
}

const UNTURNED: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

fn solve(task: &AssemblyTask, settings: HomotopySettings, start: Option<Start>) -> HomotopyStep {
    let mut homotopy = Homotopy::new(task, settings);
    let start = start.unwrap_or_else(|| Start::Cold(homotopy.transcription(1).initial_guess()));
    let iterations = homotopy.run_from(&[], start, |_| Control::Continue, |_, _| Control::Continue).unwrap();
    assert!(iterations.iter().all(|iteration| iteration.status.is_success()));
    iterations.into_iter().next_back().unwrap()
}

#[test]
fn a_far_pair_changes_nothing_and_exerts_no_force() {
    let (without, with) =
        (solve(&corner(), scene::default_homotopy(), None), solve(&with_a_far_pair(), scene::default_homotopy(), None));
    assert!((without.objective - with.objective).abs() < 1e-6 * without.objective, "{without:?}");
    for (one, other) in without.trajectory.reference.iter().zip(&with.trajectory.reference) {
        assert!(one.iter().zip(other.iter()).all(|(one, other)| (one - other).abs() < 1e-4));
    }
    for contacts in with.trajectory.scenarios.iter().flat_map(|scenario| &scenario.contacts) {
        assert_eq!(contacts.len(), FAR + 1, "all pairs are in the result");
        assert_eq!(contacts[FAR].force, 0.0);
        assert!(contacts[FAR].distance > 0.5);
    }
}

#[test]
fn pairs_that_come_near_are_added() {
    let task = corner();
    let settings =
        HomotopySettings { iterations: 1, further_iterations: 0, tau: 1e-5, sigma: 1e-5, ..scene::default_homotopy() };
    let transcription = ocp::Transcription::new(&task, settings.complementarity, settings.hessian);
    // At rest at the start, where all pairs are far apart.
    let x = transcription.initial_guess();
    let multipliers = |count: usize| vec![settings.mu_init; count];
    let rest = Iterate {
        constraint_multipliers: multipliers(transcription.layout().constraint_count()),
        lower_multipliers: multipliers(x.len()),
        upper_multipliers: multipliers(x.len()),
        x,
    };
    let end = solve(&task, settings, Some(Start::Warm(rest)));
    assert!(end.trajectory.max_penetration() < 1e-3, "{}", end.trajectory.max_penetration());
    let forces = end.trajectory.scenarios.iter().map(|scenario| scenario.quality.max_force);
    assert!(forces.fold(0.0, f64::max) > 0.1, "walls push");
}

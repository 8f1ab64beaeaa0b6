//! Homotopy steps without contacts of pairs that are far apart.

use std::path::Path;

use kkt::Owner;
use nlp::{Control, Iterate, Start};
use ocp::{ActiveContacts, Formulation, Homotopy, HomotopyStep, IterationEnd, Member};
use task::{AssemblyTask, Complementarity, ContactPair, HomotopySettings};

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
    let homotopy = Homotopy::new(task, settings);
    let start = start.unwrap_or_else(|| Start::Cold(homotopy.formulation(1).initial_guess()));
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
    let x = transcription.formulation().initial_guess();
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

/// The corner with its floor in strips side by side, of which few are near in any step.
fn with_strips(count: usize) -> AssemblyTask {
    let width = 0.6 / count as f64;
    let mut task = corner();
    let body = task.pairs[0].shapes.body().clone();
    let strips = (0..count).map(|strip| {
        let floor = collision::Polytope::from_box([width, 0.6, 0.1]).unwrap();
        let floor = floor.placed([-0.3 + (strip as f64 + 0.5) * width, 0.0, -0.05], UNTURNED);
        let shapes = collision::Pair::new(body.clone(), floor);
        ContactPair { body: "box".to_owned(), environment: format!("floor {strip}"), shapes }
    });
    task.pairs.splice(0..1, strips);
    task
}

/// With sixteen pairs, those that come near have contacts at all steps; with one more, only where they are near.
#[test]
fn of_many_pairs_those_that_are_near_have_contacts_and_the_plan_is_the_same() {
    let (task, settings) = (with_strips(16), scene::default_homotopy());
    let mut fewer = task.clone();
    // A strip that the body never comes near.
    fewer.pairs.remove(0);
    let (few, strips) = (solve(&fewer, settings.clone(), None), solve(&task, settings.clone(), None));
    let difference = (few.objective - strips.objective).abs();
    assert!(difference < 1e-2 * few.objective, "{} instead of {}", strips.objective, few.objective);
    assert!(strips.trajectory.max_penetration() < 1e-3, "{}", strips.trajectory.max_penetration());
    let formulation = Formulation::new(&task, settings.complementarity);
    let near = formulation.near(&strips.iterate.x);
    let (all, active) = (formulation.layout().contacts().count(), near.layout().contacts().count());
    assert!(active > 0 && 2 * active < all, "{active} of {all}");
}

/// The strips are one piece; points and contacts are of all strips, and a homotopy that goes on from them is the same bit for
/// bit.
#[test]
fn homotopy_steps_have_the_points_of_all_pieces_and_can_be_resumed() {
    let task = with_strips(20);
    let homotopy = Homotopy::new(&task, scene::default_homotopy());
    let observe = |_: ocp::Event| Control::Continue;
    let all = homotopy.run(observe, |_, _| Control::Continue).unwrap();
    assert!(all.iter().all(|step| step.status.is_success()));
    for (index, step) in all.iter().enumerate() {
        assert_eq!(step.iterate.x.len(), homotopy.formulation(index + 1).layout().variable_count());
        for contacts in step.trajectory.scenarios.iter().flat_map(|scenario| &scenario.contacts) {
            assert_eq!(contacts.len(), task.pairs.len());
            let pushing = contacts[..20].iter().filter(|contact| contact.force > 0.0).count();
            assert!(pushing <= 1, "one piece pushes once: {pushing}");
        }
    }
    // However a part is cut, the plan is the same.
    let cut_otherwise = solve(&with_strips(30), scene::default_homotopy(), None);
    let difference = (cut_otherwise.objective - all[all.len() - 1].objective).abs();
    assert!(difference < 1e-6 * cut_otherwise.objective, "{difference:e}");
    let (earlier, later) = all.split_at(2);
    let ends: Vec<IterationEnd> = earlier.iter().map(IterationEnd::from).collect();
    let start = Start::Warm(earlier[1].iterate.clone());
    let resumed = homotopy.run_from(&ends, start, observe, |_, _| Control::Continue).unwrap();
    assert_eq!(resumed.len(), later.len());
    assert!(resumed.iter().zip(later).all(|(resumed, step)| resumed.iterate == step.iterate));
}

#[test]
fn points_keep_their_values_with_fewer_contacts_and_back() {
    let task = with_strips(24);
    let whole = Formulation::new(&task, Complementarity::Relaxation);
    let few = whole.with_contacts(ActiveContacts::on_straight_paths(&task));
    let count = few.layout().contacts().count();
    assert!(count > 0 && count < whole.layout().contacts().count(), "{count}");
    let numbered = |count: usize| (1..=count).map(|number| number as f64).collect::<Vec<_>>();
    let point = Iterate {
        x: numbered(few.layout().variable_count()),
        constraint_multipliers: numbered(few.layout().constraint_count()),
        lower_multipliers: numbered(few.layout().variable_count()),
        upper_multipliers: numbered(few.layout().variable_count()),
    };
    let extended = whole.point_of(&few, &point);
    assert_eq!(extended.x.len(), whole.layout().variable_count());
    assert_eq!(few.point_of(&whole, &extended), point);
    let members = whole.layout().variable_members();
    let has_contact = |member: &Member| match (member.pair, member.owner) {
        (Some(pair), Owner::Scenario(scenario)) => few.layout().contacts().slot(member.stage, scenario, pair).is_some(),
        _ => true,
    };
    for (value, member) in extended.x.iter().zip(&members) {
        assert_eq!(*value != 0.0, has_contact(member), "{member:?}");
    }
    let motion = few.motion(&few.initial_guess(), 1e-3);
    assert_eq!(motion.scenarios[0].contacts[0].len(), task.pairs.len(), "all pairs are in the motion");
}

//! A new term needs one file and one line of registration: three terms that exist for tests only have exact derivatives
//! and are solved by the stage solver.

mod drag;
mod friction;
mod tilted;

use std::path::Path;

use kkt::Fallbacks;
use nlp::{Control, LinearSystemSolver, Options, Problem, SolveStatus, Start, check_derivatives};
use ocp::{Owners, StepTerm, Transcription, TranscriptionSolver, VELOCITY_DYNAMICS, standard_terms};
use task::{AssemblyTask, Complementarity, HessianKind, POSE, TWIST};
use workers::Workers;

use drag::ViscousDrag;
use friction::RegularisedCoulomb;
use tilted::TiltedContacts;

fn corner(steps: usize) -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml");
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = steps;
    task
}

fn transcribe(task: &AssemblyTask, new: Option<Box<dyn StepTerm>>) -> Transcription {
    let mut terms = standard_terms(task, Complementarity::Relaxation);
    terms.extend(new);
    let mut transcription = Transcription::with_terms(task, terms, HessianKind::Exact);
    transcription.set_smoothing(0.0025, 0.00125);
    transcription
}

/// The initial guess, disturbed by up to 0.02.
fn disturbed_guess(problem: &Transcription) -> Vec<f64> {
    let noise = |index: usize| 0.02 * (index as f64 * 12.9898).sin();
    problem.formulation().initial_guess().iter().enumerate().map(|(index, value)| value + noise(index)).collect()
}

fn assert_derivatives(mut problem: Transcription) {
    let x = disturbed_guess(&problem);
    let rows = problem.layout().constraint_count();
    let multipliers: Vec<f64> = (0..rows).map(|row| (row as f64 * 7.77).sin()).collect();
    check_derivatives(&mut problem, &x, &multipliers, 1e-6).unwrap().assert_within(1e-5);
}

/// Solves with the stage solver, which must not fall back on the general one; returns the objective.
fn solve(mut problem: Transcription) -> f64 {
    let mut options = Options::default();
    options.set("tol", 1e-2);
    options.set("mu_init", 1.0);
    let mut solver = TranscriptionSolver::new(problem.layout(), Workers::default());
    let start = Start::Cold(problem.formulation().initial_guess());
    let own = LinearSystemSolver::Own(&mut solver);
    let solution = nlp::solve(&mut problem, &start, &options, own, &mut |_| Control::Continue).unwrap();
    assert_eq!(solution.status, SolveStatus::Solved);
    assert_eq!(solver.report().unwrap().fallbacks, Fallbacks::default());
    solution.objective
}

fn drag(task: &AssemblyTask) -> Option<Box<dyn StepTerm>> {
    Some(Box::new(ViscousDrag::new(task, 3.0)))
}

fn friction(task: &AssemblyTask) -> Option<Box<dyn StepTerm>> {
    Some(Box::new(RegularisedCoulomb::new(task, 0.3, 0.1)))
}

fn tilted(task: &AssemblyTask) -> Option<Box<dyn StepTerm>> {
    Some(Box::new(TiltedContacts::new(task, 0.3)))
}

#[test]
fn derivatives_of_new_terms_are_exact() {
    let task = AssemblyTask { pairs: corner(3).pairs[..2].to_vec(), ..corner(3) };
    for new in [drag(&task), friction(&task), tilted(&task)] {
        assert_derivatives(transcribe(&task, new));
    }
}

#[test]
fn the_stage_solver_solves_new_terms() {
    let task = corner(20);
    let without = solve(transcribe(&task, None));
    for new in [drag(&task), friction(&task), tilted(&task)] {
        let with = solve(transcribe(&task, new));
        assert!((with - without).abs() > 1e-3 * without, "the term changes nothing: {with}, {without}");
    }
}

#[test]
fn a_term_adds_to_the_rows_of_another_one() {
    let task = corner(3);
    let (mut without, mut with) = (transcribe(&task, None), transcribe(&task, drag(&task)));
    let x = disturbed_guess(&without);
    assert_eq!(without.layout(), with.layout());
    let [before, after] = [&mut without, &mut with].map(|problem| {
        let mut values = vec![0.0; problem.layout().constraint_count()];
        problem.set_point(&x).unwrap();
        problem.constraints(&mut values).unwrap();
        values
    });
    let mut expected = before;
    for (stage, owner) in with.layout().stages_of(Owners::Scenarios) {
        let twist = with.layout().state(stage, owner) + POSE;
        let row = with.layout().row(VELOCITY_DYNAMICS, stage, owner);
        for axis in 0..3 {
            expected[row + axis] += task.horizon.time_step * 3.0 / task.inertia.mass().unwrap() * x[twist + axis];
        }
    }
    let largest = expected.iter().zip(&after).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
    assert!(largest < 1e-15, "{largest:e}");
}

#[test]
fn new_variables_and_rows_have_a_place_of_their_own() {
    let task = corner(2);
    let (without, with) = (transcribe(&task, None), transcribe(&task, tilted(&task)));
    let added = 2 * task.pairs.len();
    let stages = task.horizon.steps * task.grasps.len();
    assert_eq!(with.layout().variable_count(), without.layout().variable_count() + stages * added);
    assert_eq!(with.layout().constraint_count(), without.layout().constraint_count() + stages * 2 * added);
    let bounds = with.variable_bounds();
    for (stage, owner) in with.layout().stages_of(Owners::Scenarios) {
        let first = with.layout().variable(tilted::FORCE, stage, owner);
        assert_eq!(bounds.lower[first..][..added], vec![0.0; added]);
        assert!(first >= with.layout().state(stage, owner) + POSE + TWIST + task.pairs.len());
    }
}

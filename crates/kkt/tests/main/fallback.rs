//! Matrices that go to the general solver, and matrices that cannot be factorised.

use crate::support::{Random, Shape, System};
use kkt::{Class, Factorisation, Fallbacks, StageSolver, StructureError};

fn system() -> System {
    System::random(&Shape { stages: 3, scenarios: 2, pairs: 2, smoothing: false, delta_w: 1e4, delta_c: 0.0, seed: 3 })
}

fn solver(system: &System) -> StageSolver {
    StageSolver::new(&system.labels, &system.rows, &system.columns).unwrap()
}

/// Expects the right inertia and an accurate solution, from either solver.
fn check(solver: &mut StageSolver, system: &System) {
    let negative = system.negative_eigenvalues();
    assert_eq!(solver.factorise(&system.values), Factorisation::Inertia { negative });
    let right = Random(7).vector(system.dimension());
    let mut solution = right.clone();
    assert!(solver.solve(&mut solution));
    assert!(system.backward_error(&solution, &right) < 1e-10);
}

#[test]
fn an_entry_between_distant_stages_goes_to_the_general_solver_and_is_named() {
    let mut system = system();
    let (row, column) = (system.row(1, Class::Velocity, 0), system.row(3, Class::Velocity, 0));
    system.add(row, column, 2.0);
    let mut solver = solver(&system);
    let message = solver.structure_error().unwrap().to_string();
    assert!(message.contains("only neighbouring stages may be coupled"), "{message}");
    assert!(message.contains("Velocity 0 of scenario 0 at stage 3"), "{message}");
    check(&mut solver, &system);
    assert_eq!(solver.report().fallbacks, Fallbacks { structure: 1, ..Fallbacks::default() });
}

#[test]
fn contacts_of_two_scenarios_may_not_be_coupled() {
    let mut system = system();
    let forces: Vec<usize> = (0..system.dimension())
        .filter(|&row| system.labels[row].class == Class::ContactForce && system.labels[row].stage == 2)
        .collect();
    system.add(forces[0], *forces.last().unwrap(), 1.0);
    assert!(matches!(solver(&system).structure_error(), Some(StructureError::Coupling { .. })));
    check(&mut solver(&system), &system);
}

#[test]
fn more_quality_is_a_matter_for_the_general_solver_once() {
    let system = system();
    let mut solver = solver(&system);
    solver.increase_quality();
    check(&mut solver, &system);
    check(&mut solver, &system);
    assert_eq!(solver.report().fallbacks, Fallbacks { quality: 1, ..Fallbacks::default() });
    assert_eq!(solver.report().fast_path, 1);
}

#[test]
fn numbers_that_are_not_finite_are_a_failure() {
    for wrong in [f64::NAN, f64::INFINITY] {
        let mut system = system();
        let mut solver = solver(&system);
        let kept = std::mem::replace(&mut system.values[5], wrong);
        assert_eq!(solver.factorise(&system.values), Factorisation::Failed);
        assert!(!solver.solve(&mut vec![1.0; system.dimension()]));
        assert_eq!(solver.report().fallbacks.not_finite, 1);
        system.values[5] = kept;
        check(&mut solver, &system);
    }
}

#[test]
fn a_constraint_that_repeats_another_makes_the_matrix_singular() {
    let mut system = system();
    let (first, second) = (system.row(2, Class::VelocityMultiplier, 0), system.row(2, Class::VelocityMultiplier, 1));
    repeat(&mut system, first, second);
    let mut solver = solver(&system);
    assert_eq!(solver.factorise(&system.values), Factorisation::Singular);
    assert_eq!(solver.report().fallbacks.total(), 1);
    // Perturbed constraints, Ipopt's remedy, make it regular again.
    for row in 0..system.dimension() {
        let perturbation = if system.labels[row].class.is_multiplier() { -1e-4 } else { 0.0 };
        system.add(row, row, perturbation);
    }
    let mut solver = self::solver(&system);
    check(&mut solver, &system);
}

/// Makes all entries of a row those of another.
fn repeat(system: &mut System, original: usize, copy: usize) {
    for entry in 0..system.values.len() {
        if system.rows[entry] == copy || system.columns[entry] == copy {
            system.values[entry] = 0.0;
        }
    }
    for entry in 0..system.values.len() {
        let (row, column, value) = (system.rows[entry], system.columns[entry], system.values[entry]);
        if row == original && column != original {
            system.add(copy, column, value);
        } else if column == original && row != original {
            system.add(copy, row, value);
        }
    }
}

#[test]
fn pivots_that_are_nothing_but_rounding_are_not_trusted() {
    let mut system = system();
    let (first, second) = (system.row(2, Class::VelocityMultiplier, 0), system.row(2, Class::VelocityMultiplier, 1));
    repeat(&mut system, first, second);
    // A relative change of 1e-16: the sign of the difference is random.
    let touched = system.rows.iter().position(|&row| row == second).unwrap();
    system.values[touched] += 1e-16;
    let mut solver = solver(&system);
    solver.factorise(&system.values);
    assert_eq!(solver.report().fallbacks.uncertain_pivot, 1);
}

#[test]
fn a_matrix_without_numbers_is_singular() {
    let mut system = system();
    system.values.fill(0.0);
    assert_eq!(solver(&system).factorise(&system.values), Factorisation::Singular);
}

#[test]
fn labels_and_entries_that_describe_no_matrix_are_refused() {
    let system = system();
    let (labels, rows, columns) = (&system.labels, &system.rows, &system.columns);
    let refused = |rows: &[usize], columns: &[usize]| StageSolver::new(labels, rows, columns).err().unwrap();
    assert_eq!(refused(&rows[1..], columns), StructureError::Length { rows: rows.len() - 1, columns: rows.len() });
    assert!(matches!(refused(&[labels.len()], &[0]), StructureError::Range { entry: 0, .. }));
    let mut labels = labels.clone();
    labels[4].stage = 0;
    let solver = StageSolver::new(&labels, rows, columns).unwrap();
    assert!(matches!(solver.structure_error(), Some(StructureError::Stage { row: 4, .. })));
}

//! Inertia and solutions of random staged matrices against dense linear algebra.

use crate::support::{Random, Shape, System, shapes};
use kkt::{Class, Factorisation, StageSolver};
use proptest::prelude::*;
use pulp::Arch;
use workers::Workers;

/// Every instruction set of this machine.
fn arches() -> Vec<(&'static str, Arch)> {
    let mut arches = vec![("scalar", Arch::Scalar)];
    #[cfg(target_arch = "x86_64")]
    {
        arches.extend(pulp::x86::V3::try_new().map(|simd| ("AVX2", Arch::V3(simd))));
        arches.extend(pulp::x86::V4::try_new().map(|simd| ("AVX-512", Arch::V4(simd))));
    }
    #[cfg(target_arch = "aarch64")]
    arches.extend(pulp::aarch64::Neon::try_new().map(|simd| ("NEON", Arch::Neon(simd))));
    arches
}

fn solver(system: &System, arch: Arch) -> StageSolver {
    let solver =
        StageSolver::with_arch(&system.labels, &system.rows, &system.columns, arch, Workers::default()).unwrap();
    assert_eq!(solver.structure_error(), None);
    solver
}

/// Checks a factorisation and a solve with it.
fn check(solver: &mut StageSolver, system: &System, negative: usize) -> Result<(), TestCaseError> {
    let found = solver.factorise(&system.values);
    let Factorisation::Inertia { negative: counted } = found else {
        return Err(TestCaseError::fail(format!("{found:?} instead of {negative} negative eigenvalues")));
    };
    if negative <= system.multipliers() {
        prop_assert_eq!(counted, negative);
    } else {
        prop_assert!(counted > system.multipliers());
    }
    let right = Random(7).vector(system.dimension());
    let mut solution = right.clone();
    prop_assert!(solver.solve(&mut solution));
    prop_assert!(system.backward_error(&solution, &right) < 1e-10);
    Ok(())
}

proptest! {
    // Fewer where the environment says so, as on an emulated processor.
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.min(96)))]

    #[test]
    fn inertia_is_that_of_the_eigenvalues(shape in shapes()) {
        let system = System::random(&shape);
        let negative = system.negative_eigenvalues();
        for (name, arch) in arches() {
            let mut solver = solver(&system, arch);
            check(&mut solver, &system, negative)
                .map_err(|error| TestCaseError::fail(format!("{name}: {error}, {:?}", solver.report())))?;
        }
    }

    #[test]
    fn the_order_of_rows_and_entries_does_not_matter(shape in shapes()) {
        let system = System::random(&shape);
        let reversed = reversed(&system);
        let negative = system.negative_eigenvalues();
        check(&mut solver(&reversed, Arch::new()), &reversed, negative)?;
    }
}

fn reversed(system: &System) -> System {
    let last = system.dimension() - 1;
    System {
        labels: system.labels.iter().rev().copied().collect(),
        rows: system.rows.iter().rev().map(|row| last - row).collect(),
        columns: system.columns.iter().rev().map(|column| last - column).collect(),
        values: system.values.iter().rev().copied().collect(),
    }
}

fn regular() -> Shape {
    Shape { stages: 3, scenarios: 2, pairs: 2, smoothing: false, delta_w: 1e4, delta_c: 0.0, seed: 1 }
}

#[test]
fn zero_diagonals_of_the_kinematics_take_the_fast_path() {
    let mut solver_without = solver(&System::random(&regular()), Arch::new());
    let system = System::random(&regular());
    check(&mut solver_without, &system, system.multipliers()).unwrap();
    let report = solver_without.report();
    assert_eq!((report.fast_path, report.general_path, report.fallbacks.total()), (1, 0, 0));

    let perturbed = System::random(&Shape { delta_c: 1e-8, ..regular() });
    check(&mut solver_without, &perturbed, perturbed.multipliers()).unwrap();
    let report = solver_without.report();
    assert_eq!((report.fast_path, report.general_path, report.fallbacks.total()), (1, 1, 0));
}

#[test]
fn a_surplus_of_negative_eigenvalues_ends_a_factorisation_early_and_can_be_solved_with_all_the_same() {
    let mut system = System::random(&regular());
    let velocity = system.row(3, Class::Velocity, 0);
    system.add(velocity, velocity, -1e7);
    let negative = system.negative_eigenvalues();
    assert!(negative > system.multipliers());
    let mut solver = solver(&system, Arch::new());
    check(&mut solver, &system, negative).unwrap();
    assert_eq!(solver.report().early_exits, 1);
}

#[test]
fn factors_of_one_matrix_leave_no_trace_in_the_next() {
    let first = System::random(&regular());
    let mut second = first.clone();
    let mut random = Random(5);
    second.values.iter_mut().for_each(|value| *value *= random.between(0.5, 2.0));
    let mut used = solver(&first, Arch::new());
    used.factorise(&first.values);
    used.factorise(&second.values);
    let mut fresh = solver(&second, Arch::new());
    fresh.factorise(&second.values);
    let right = Random(7).vector(first.dimension());
    let (mut x, mut y) = (right.clone(), right);
    assert!(used.solve(&mut x) && fresh.solve(&mut y));
    assert_eq!(x, y);
}

/// With a right and a wrong inertia, which ends the factorisation early.
#[test]
fn threads_change_no_bit() {
    let shape = Shape { stages: 30, scenarios: 3, pairs: 4, ..regular() };
    let good = System::random(&shape);
    let mut bad = good.clone();
    let velocity = bad.row(20, Class::Velocity, 0);
    bad.add(velocity, velocity, -1e7);
    for system in [good, bad] {
        let run = |threads| {
            let (labels, rows, columns) = (&system.labels, &system.rows, &system.columns);
            let mut solver = StageSolver::with_workers(labels, rows, columns, Workers::new(threads)).unwrap();
            let found = solver.factorise(&system.values);
            let mut solution = Random(7).vector(system.dimension());
            assert!(solver.solve(&mut solution));
            let report = solver.report();
            (found, solution, report.early_exits, report.refinements, report.fallbacks.total())
        };
        let alone = run(1);
        assert_eq!(alone.4, 0);
        for threads in [2, 3, 2, 3] {
            assert_eq!(run(threads), alone, "{threads} threads");
        }
    }
}

#[test]
fn stages_without_coupling_and_problems_of_one_row_are_solved() {
    let label = System::random(&regular()).labels[0];
    let mut solver = StageSolver::new(&[label], &[0], &[0]).unwrap();
    assert_eq!(solver.factorise(&[-2.0]), Factorisation::Inertia { negative: 1 });
    let mut x = [3.0];
    assert!(solver.solve(&mut x));
    assert_eq!(x, [-1.5]);
}

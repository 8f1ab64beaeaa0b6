//! A small problem: solved, rejected, interrupted, and its derivatives checked.

use crate::support::{Product, cold};
use nlp::{
    Control, Iterate, LinearSystemSolver, Options, SolveError, SolveStatus, Start, check, check_derivatives, solve,
};

fn run(problem: &mut Product, start: &Start, options: &Options) -> nlp::Solution {
    solve(problem, start, options, LinearSystemSolver::Named(nlp::MUMPS), &mut |_| Control::Continue).unwrap()
}

#[test]
fn the_known_minimum_is_found() {
    let solution = run(&mut Product::default(), &cold(), &Options::default());
    assert_eq!(solution.status, SolveStatus::Solved);
    assert!((solution.objective - 17.014_017_3).abs() < 1e-6);
    assert!(solution.constraint_violation < 1e-6);
    assert_eq!(solution.log.len(), solution.iterations + 1);
    assert_eq!(solution.linear_solver, "mumps");
}

#[test]
fn a_warm_start_needs_fewer_iterations() {
    let first = run(&mut Product::default(), &cold(), &Options::default());
    let mut options = Options::default();
    options.set("mu_init", 1e-9);
    options.set("warm_start_bound_push", 1e-9);
    options.set("warm_start_mult_bound_push", 1e-9);
    let again = run(&mut Product::default(), &Start::Warm(first.iterate.clone()), &options);
    assert!(again.status.is_success());
    assert!(again.iterations < first.iterations, "{} and {}", again.iterations, first.iterations);
}

#[test]
fn unknown_and_ill_typed_options_are_refused() {
    for (name, value) in [("no_such_option", "yes".into()), ("tol", "small".into()), ("max_iter", 2.5.into())] {
        let mut options = Options::default();
        let value: nlp::OptionValue = value;
        options.set(name, value);
        let refused =
            solve(&mut Product::default(), &cold(), &options, LinearSystemSolver::Named(nlp::MUMPS), &mut |_| {
                Control::Continue
            });
        assert!(matches!(refused, Err(SolveError::Option { name: refused, .. }) if refused == name));
    }
    let mut options = Options::default();
    options.set("tol", 1);
    assert!(run(&mut Product::default(), &cold(), &options).status.is_success(), "an integer is a number");
}

#[test]
fn unknown_and_missing_linear_solvers_are_refused() {
    let refused = solve(
        &mut Product::default(),
        &cold(),
        &Options::default(),
        LinearSystemSolver::Named("no_such_solver"),
        &mut |_| Control::Continue,
    );
    assert!(matches!(refused, Err(SolveError::LinearSolver { .. })));
    match check(&Options::default(), Some("ma27")) {
        Ok(()) => eprintln!("the HSL library is installed"),
        Err(error) => assert!(error.to_string().contains("the HSL library libhsl"), "{error}"),
    }
}

#[test]
fn a_starting_point_of_the_wrong_size_is_refused() {
    let start = Start::Warm(Iterate { x: vec![1.0; 4], ..Iterate::default() });
    let refused =
        solve(&mut Product::default(), &start, &Options::default(), LinearSystemSolver::Named(nlp::MUMPS), &mut |_| {
            Control::Continue
        });
    assert!(matches!(refused, Err(SolveError::Problem(_))));
}

#[test]
fn a_panic_goes_on_after_ipopt_has_returned() {
    let panicked = std::panic::catch_unwind(|| {
        let mut problem = Product { panics: true, ..Product::default() };
        run(&mut problem, &cold(), &Options::default())
    });
    let message = *panicked.unwrap_err().downcast::<&str>().unwrap();
    assert_eq!(message, "the third point is one too many");
    assert!(run(&mut Product::default(), &cold(), &Options::default()).status.is_success(), "and the next solve works");
}

#[test]
fn the_observer_stops_a_solve_at_its_last_iterate() {
    let mut stop = |progress: &nlp::Progress| {
        if progress.iteration == 2 { Control::Stop } else { Control::Continue }
    };
    let solution =
        solve(&mut Product::default(), &cold(), &Options::default(), LinearSystemSolver::Named(nlp::MUMPS), &mut stop)
            .unwrap();
    assert_eq!(solution.status, SolveStatus::Interrupted);
    assert_eq!(solution.iterations, 2);
    assert_ne!(solution.iterate.x, [1.0, 5.0, 5.0, 1.0]);
}

#[test]
fn where_there_is_no_value_the_step_is_shortened() {
    let free = run(&mut Product::default(), &cold(), &Options::default());
    assert!(free.evaluation_error.is_none());
    let mut problem = Product { wall: Some(1.05), ..Product::default() };
    let solution = run(&mut problem, &cold(), &Options::default());
    assert!((solution.objective - free.objective).abs() < 1e-5);
    assert_eq!(solution.evaluation_error.unwrap().to_string(), "behind the wall");
}

#[test]
fn a_stray_option_file_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("ipopt.opt"), "max_iter 1\n").unwrap();
    std::env::set_current_dir(folder.path()).unwrap();
    let status = run(&mut Product::default(), &cold(), &Options::default()).status;
    std::env::set_current_dir("/").unwrap();
    assert_eq!(status, SolveStatus::Solved);
}

#[test]
fn each_point_is_set_once() {
    let mut problem = Product::default();
    let solution = run(&mut problem, &cold(), &Options::default());
    let trials: usize = solution.log.iter().map(|progress| progress.line_search_trials).sum();
    assert!(problem.points <= trials + 2, "{} points for {trials} trials", problem.points);
}

#[test]
fn solves_in_threads_take_turns() {
    let alone = run(&mut Product::default(), &cold(), &Options::default());
    let threads: Vec<_> = (0..4)
        .map(|_| std::thread::spawn(|| run(&mut Product::default(), &cold(), &Options::default()).iterate))
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap(), alone.iterate);
    }
}

#[test]
fn derivatives_are_checked() {
    let (x, multipliers) = ([1.1, 4.2, 3.3, 1.4], [0.7, -0.3]);
    check_derivatives(&mut Product::default(), &x, &multipliers, 1e-6).unwrap().assert_within(1e-7);
    let mut wrong = Product { wrong_hessian: true, ..Product::default() };
    let report = check_derivatives(&mut wrong, &x, &multipliers, 1e-6).unwrap();
    let worst = report.entries[0];
    assert_eq!((worst.kind, worst.row.max(worst.column), worst.row.min(worst.column)), (nlp::Kind::Hessian, 2, 1));
    assert!(std::panic::catch_unwind(|| report.assert_within(1e-7)).is_err());
}

//! A linear solver of the caller inside Ipopt.

use crate::support::{Product, cold};
use nalgebra::{DMatrix, DVector};
use nlp::{
    AnalysisError, Control, Factorisation, KktSolver, LinearSystemSolver, Options, Solution, SolveError, SolveStatus,
    solve,
};

/// Dense linear algebra with injected failures.
#[derive(Default)]
struct Dense {
    matrix: DMatrix<f64>,
    places: Vec<(usize, usize)>,
    factorisations: usize,
    quality_requests: usize,
    refuses: bool,
    panics_at: Option<usize>,
    fails_from: Option<usize>,
    singular_at: Option<usize>,
    poor_at: Option<usize>,
}

impl KktSolver for Dense {
    fn name(&self) -> &str {
        "dense"
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        self.matrix = DMatrix::zeros(dimension, dimension);
        self.places = rows.iter().copied().zip(columns.iter().copied()).collect();
        if self.refuses { Err("the pattern is not supported".into()) } else { Ok(()) }
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        self.factorisations += 1;
        let now = Some(self.factorisations);
        assert!(self.panics_at != now, "a matrix too many");
        if self.fails_from.is_some() && self.fails_from <= now {
            return Factorisation::Failed;
        }
        if self.singular_at == now {
            return Factorisation::Singular;
        }
        self.matrix.fill(0.0);
        for (&(row, column), value) in self.places.iter().zip(values) {
            self.matrix[(row, column)] += value;
            if row != column {
                self.matrix[(column, row)] += value;
            }
        }
        let negative = self.matrix.symmetric_eigenvalues().iter().filter(|&&value| value < 0.0).count();
        Factorisation::Inertia { negative }
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        let Some(solution) = self.matrix.clone().lu().solve(&DVector::from_column_slice(values)) else { return false };
        let error = if self.poor_at == Some(self.factorisations) { 1.5 } else { 1.0 };
        values.iter_mut().zip(&solution).for_each(|(value, solution)| *value = error * solution);
        true
    }

    fn increase_quality(&mut self) {
        self.quality_requests += 1;
        self.poor_at = None;
    }
}

fn run(solver: &mut Dense) -> Result<Solution, SolveError> {
    let solver = LinearSystemSolver::Own(solver);
    solve(&mut Product::default(), &cold(), &Options::default(), solver, &mut |_| Control::Continue)
}

#[test]
fn it_takes_the_same_iterations_as_mumps() {
    let own = run(&mut Dense::default()).unwrap();
    let mumps = LinearSystemSolver::Named(nlp::MUMPS);
    let mumps =
        solve(&mut Product::default(), &cold(), &Options::default(), mumps, &mut |_| Control::Continue).unwrap();
    assert_eq!((own.status, own.iterations), (SolveStatus::Solved, mumps.iterations));
    assert!((own.objective - mumps.objective).abs() < 1e-9);
    assert_eq!(own.linear_solver, "dense");
    assert!(own.timing.linear_solver > 0.0);
}

#[test]
fn it_does_not_run_as_ma57() {
    for _ in 0..2 {
        let named = LinearSystemSolver::Named("ma57");
        assert_eq!(run(&mut Dense::default()).unwrap().status, SolveStatus::Solved);
        match solve(&mut Product::default(), &cold(), &Options::default(), named, &mut |_| Control::Continue) {
            Ok(solution) => assert_eq!((solution.status, &*solution.linear_solver), (SolveStatus::Solved, "ma57")),
            Err(error) => assert!(error.to_string().contains("hsl"), "{error}"),
        }
    }
}

#[test]
fn its_refusal_is_an_error_in_its_own_words() {
    let error = run(&mut Dense { refuses: true, ..Dense::default() }).unwrap_err();
    assert_eq!(error.to_string(), "linear solver \"dense\": the pattern is not supported");
}

#[test]
fn its_panic_passes_through_ipopt_and_leaves_it_usable() {
    let mut solver = Dense { panics_at: Some(3), ..Dense::default() };
    let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| run(&mut solver)));
    assert_eq!(outcome.unwrap_err().downcast_ref::<&str>(), Some(&"a matrix too many"));
    assert_eq!(run(&mut Dense::default()).unwrap().status, SolveStatus::Solved);
}

#[test]
fn its_failures_are_a_status() {
    let solution = run(&mut Dense { fails_from: Some(3), ..Dense::default() }).unwrap();
    assert!(!solution.status.is_success(), "{:?}", solution.status);
}

#[test]
fn singular_matrices_are_perturbed() {
    let mut solver = Dense { singular_at: Some(3), ..Dense::default() };
    assert_eq!(run(&mut solver).unwrap().status, SolveStatus::Solved);
}

#[test]
fn poor_solutions_lead_to_a_request_for_more_quality() {
    let mut solver = Dense { poor_at: Some(3), ..Dense::default() };
    assert_eq!(run(&mut solver).unwrap().status, SolveStatus::Solved);
    assert_eq!(solver.quality_requests, 1);
}

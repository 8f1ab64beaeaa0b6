//! The stage solver inside whole solves: matrix by matrix against MUMPS, and in several threads.

use std::path::Path;

use kkt::Fallbacks;
use mumps_oracle::Mumps;
use nalgebra::{Matrix6, Vector3, Vector6};
use nlp::{AnalysisError, Control, Factorisation, KktSolver, LinearSystemSolver, Options, SolveStatus, Start};
use ocp::{Transcription, TranscriptionSolver};
use task::{AssemblyTask, Complementarity, HessianKind, Impedance, Inertia, Limits};
use workers::Workers;

fn task(scene: &str, steps: usize) -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{scene}.toml"));
    let mut task = scene::Scene::load(&path).unwrap().task(None, None).unwrap();
    task.horizon.steps = steps;
    task
}

fn transcribe(task: &AssemblyTask, complementarity: Complementarity, hessian: HessianKind) -> Transcription {
    let mut transcription = Transcription::new(task, complementarity, hessian);
    transcription.set_smoothing(0.0025, 0.00125);
    transcription
}

fn options() -> Options {
    let mut options = Options::default();
    options.set("tol", 1e-2);
    options.set("mu_init", 1.0);
    options.set("max_iter", 40);
    options
}

/// Runs the stage solver and MUMPS side by side.
struct Compared {
    stage: TranscriptionSolver,
    mumps: Mumps,
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    constraints: usize,
    right_inertia: usize,
    wrong_inertia: usize,
}

impl Compared {
    fn new(transcription: &Transcription) -> Self {
        Self {
            stage: TranscriptionSolver::new(transcription.layout(), Workers::default()),
            mumps: Mumps::new(),
            rows: Vec::new(),
            columns: Vec::new(),
            values: Vec::new(),
            constraints: transcription.layout().constraint_count(),
            right_inertia: 0,
            wrong_inertia: 0,
        }
    }

    /// Largest component of `b - A x` relative to `|A| |x| + |b|`.
    fn backward_error(&self, x: &[f64], b: &[f64]) -> f64 {
        let mut residual = b.to_vec();
        let mut terms: Vec<f64> = b.iter().map(|b| b.abs()).collect();
        for ((&row, &column), &value) in self.rows.iter().zip(&self.columns).zip(&self.values) {
            let mut add = |row: usize, column: usize| {
                residual[row] -= value * x[column];
                terms[row] += (value * x[column]).abs();
            };
            add(row, column);
            if row != column {
                add(column, row);
            }
        }
        let floor = 1e-12 * terms.iter().fold(0.0, |largest: f64, &term| largest.max(term));
        residual.iter().zip(&terms).map(|(residual, term)| residual.abs() / (term + floor)).fold(0.0, f64::max)
    }
}

impl KktSolver for Compared {
    fn name(&self) -> &str {
        "stage beside MUMPS"
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        (self.rows, self.columns) = (rows.to_vec(), columns.to_vec());
        self.mumps.analyse(dimension, rows, columns)?;
        self.stage.analyse(dimension, rows, columns)
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        self.values = values.to_vec();
        let (found, expected) = (self.stage.factorise(values), self.mumps.factorise(values));
        match (found, expected) {
            (Factorisation::Inertia { negative: found }, Factorisation::Inertia { negative: expected }) => {
                if found > self.constraints {
                    assert!(expected > self.constraints, "{expected}, not {found} negative eigenvalues");
                    self.wrong_inertia += 1;
                } else {
                    assert_eq!(found, expected, "number of negative eigenvalues");
                    self.right_inertia += 1;
                }
            }
            _ => assert_eq!(found, expected),
        }
        found
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        let right = values.to_vec();
        assert!(self.stage.solve(values));
        let error = self.backward_error(values, &right);
        assert!(error < 1e-9, "backward error {error:e}");
        true
    }

    fn increase_quality(&mut self) {
        self.stage.increase_quality();
        self.mumps.increase_quality();
    }
}

/// One comparison.
struct Case {
    scene: &'static str,
    steps: usize,
    complementarity: Complementarity,
    hessian: HessianKind,
    limits: Limits,
    options: &'static [(&'static str, &'static str)],
}

const PLAIN: Case = Case {
    scene: "corner",
    steps: 20,
    complementarity: Complementarity::Relaxation,
    hessian: HessianKind::Exact,
    limits: Limits::NONE,
    options: &[],
};

fn compare(case: Case) -> (Compared, kkt::Report) {
    compare_on(&AssemblyTask { limits: case.limits, ..task(case.scene, case.steps) }, case)
}

/// Solves a task with both solvers side by side and expects the same inertia of every matrix.
fn compare_on(task: &AssemblyTask, case: Case) -> (Compared, kkt::Report) {
    let mut transcription = transcribe(task, case.complementarity, case.hessian);
    let mut solver = Compared::new(&transcription);
    let mut options = options();
    for &(name, value) in case.options {
        options.set(name, value);
    }
    let start = Start::Cold(transcription.formulation().initial_guess());
    let chosen = LinearSystemSolver::Own(&mut solver);
    nlp::solve(&mut transcription, &start, &options, chosen, &mut |_| Control::Continue).unwrap();
    let report = *solver.stage.report().unwrap();
    assert!(report.factorisations > 20, "{report:?}");
    assert_eq!(report.fallbacks, Fallbacks::default());
    (solver, report)
}

#[test]
fn relaxation_agrees_with_mumps() {
    let (solver, report) = compare(PLAIN);
    assert!(solver.right_inertia > 20 && solver.wrong_inertia > 0);
    assert_eq!(report.general_path, 0);
}

#[test]
fn smoothing_agrees_with_mumps() {
    compare(Case { complementarity: Complementarity::Smoothing, ..PLAIN });
}

#[test]
fn many_pairs_and_three_scenarios_agree_with_mumps() {
    let (_, report) = compare(Case { scene: "peg2", steps: 15, ..PLAIN });
    assert!(report.early_exits > 0);
}

#[test]
fn friction_agrees_with_mumps() {
    let (_, report) = compare_on(&AssemblyTask { frictions: vec![0.3], ..task(PLAIN.scene, PLAIN.steps) }, PLAIN);
    assert_eq!(report.general_path, 0);
}

/// An arm's apparent inertia (kg, kg m, kg m^2): the arm's mass is not at the part.
#[test]
fn an_arm_agrees_with_mumps() {
    let lever = Vector3::new(0.02, -0.1, 0.3).cross_matrix() * 8.0;
    let mut matrix = Matrix6::from_diagonal(&Vector6::new(12.0, 7.0, 8.0, 1.5, 1.2, 0.8));
    matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&-lever);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&lever);
    assert!(matrix.cholesky().is_some());
    let inertia = Inertia::from_matrix(matrix);
    let impedance = Impedance::critically_damped(400.0, 40.0, &inertia);
    let (_, report) = compare_on(&AssemblyTask { inertia, impedance, ..task(PLAIN.scene, PLAIN.steps) }, PLAIN);
    assert_eq!(report.general_path, 0);
}

/// Limits; those of velocity, acceleration and wrench are active in the corner.
const TIGHT: Limits = Limits {
    translational_velocity: 0.06,
    rotational_velocity: 0.12,
    translational_acceleration: 0.15,
    rotational_acceleration: 0.3,
    contact_force: 1.5,
    force: 0.5,
    torque: 0.06,
};

#[test]
fn limits_agree_with_mumps() {
    for complementarity in [Complementarity::Relaxation, Complementarity::Smoothing] {
        let (solver, report) = compare(Case { limits: TIGHT, complementarity, ..PLAIN });
        assert!(solver.right_inertia > 20);
        assert_eq!(report.general_path, 0);
    }
    // Accelerations alone couple the references of neighbouring stages; wrenches alone couple the trajectories of a
    // stage.
    let accelerations = Limits { force: f64::INFINITY, torque: f64::INFINITY, ..TIGHT };
    compare(Case { limits: accelerations, scene: "peg2", steps: 15, ..PLAIN });
    compare(Case { limits: Limits { force: 0.5, ..Limits::NONE }, ..PLAIN });
}

#[test]
fn the_restoration_phase_agrees_with_mumps() {
    let (_, report) = compare(Case { options: &[("start_with_resto", "yes")], ..PLAIN });
    assert!(report.general_path > 0, "{report:?}");
}

#[test]
fn perturbed_constraints_agree_with_mumps() {
    let (_, report) = compare(Case { options: &[("perturb_always_cd", "yes")], ..PLAIN });
    assert!(report.general_path > 20, "{report:?}");
}

#[test]
fn gauss_newton_and_quasi_newton_agree_with_mumps() {
    compare(Case { hessian: HessianKind::GaussNewton, ..PLAIN });
    let limited_memory = &[("hessian_approximation", "limited-memory")];
    compare(Case { hessian: HessianKind::LimitedMemory, options: limited_memory, ..PLAIN });
}

/// A solution's bits.
fn solve_corner() -> (SolveStatus, Vec<u64>) {
    let complementarity = Complementarity::Relaxation;
    let mut transcription = transcribe(&task("corner", 20), complementarity, HessianKind::Exact);
    let mut solver = TranscriptionSolver::new(transcription.layout(), Workers::default());
    let start = Start::Cold(transcription.formulation().initial_guess());
    let chosen = LinearSystemSolver::Own(&mut solver);
    let solution = nlp::solve(&mut transcription, &start, &options(), chosen, &mut |_| Control::Continue).unwrap();
    (solution.status, solution.iterate.x.iter().map(|value| value.to_bits()).collect())
}

#[test]
fn solves_in_threads_have_the_bits_of_sequential_ones() {
    let expected = solve_corner();
    assert_eq!(expected, solve_corner());
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(|| [(); 3].map(|()| solve_corner()))).collect();
        for thread in threads {
            for solution in thread.join().unwrap() {
                assert_eq!(solution, expected);
            }
        }
    });
}

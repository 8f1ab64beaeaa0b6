//! The linear systems of real solves, by the stage solver, by MUMPS and by feral: milliseconds of processor time of a
//! factorisation and of a solve, the speedup over MUMPS, and backward errors. The solvers take turns; each processes
//! every matrix twice, first with cold caches, after another solver has run, then with warm ones. All figures are
//! medians over the matrices.
//!
//! `cargo bench -p ocp --bench linear_solver [-- SCENE...]`

use std::path::Path;

use cpu_time::ThreadTime;
use feral::{CscMatrix, FactorStatus};
use mumps_oracle::Mumps;
use nlp::{AnalysisError, Control, Factorisation, KktSolver, LinearSystemSolver, Options, Start};
use ocp::{Transcription, TranscriptionSolver};
use task::{AssemblyTask, Complementarity, HessianKind};
use workers::Workers;

const SCENES: [&str; 4] = ["corner", "peg1", "peg5", "clamp1"];
/// Maximum number of matrices per scene.
const SAMPLES: usize = 30;

/// Linear systems of a solve.
#[derive(Default)]
struct Systems {
    dimension: usize,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Values and right-hand side of the systems that were solved.
    samples: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Systems {
    /// `|b - A x|` relative to the largest sum of the absolute values of a row's terms.
    fn backward_error(&self, values: &[f64], x: &[f64], b: &[f64]) -> f64 {
        let mut residual = b.to_vec();
        let mut terms: Vec<f64> = b.iter().map(|b| b.abs()).collect();
        for ((&row, &column), &value) in self.rows.iter().zip(&self.columns).zip(values) {
            let mut add = |row: usize, column: usize| {
                residual[row] -= value * x[column];
                terms[row] += (value * x[column]).abs();
            };
            add(row, column);
            if row != column {
                add(column, row);
            }
        }
        let largest = |values: &[f64]| values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        largest(&residual) / largest(&terms)
    }
}

/// Records the systems that it solves.
struct Capture {
    solver: TranscriptionSolver,
    values: Vec<f64>,
    systems: Systems,
}

impl KktSolver for Capture {
    fn name(&self) -> &str {
        self.solver.name()
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        self.systems = Systems { dimension, rows: rows.to_vec(), columns: columns.to_vec(), samples: Vec::new() };
        self.solver.analyse(dimension, rows, columns)
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        self.values = values.to_vec();
        self.solver.factorise(values)
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        // A second solve with the same matrix has nothing new.
        if !self.values.is_empty() {
            self.systems.samples.push((std::mem::take(&mut self.values), values.to_vec()));
        }
        self.solver.solve(values)
    }

    fn increase_quality(&mut self) {
        self.solver.increase_quality();
    }
}

fn task(scene: &str) -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{scene}.toml"));
    let scene = scene::Scene::load(&path).unwrap_or_else(|error| panic!("{error}"));
    scene.task(None, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Systems of the first homotopy step, spread evenly over it.
fn capture(transcription: &mut Transcription) -> Systems {
    let solver = TranscriptionSolver::new(transcription.layout(), Workers::default());
    let mut capture = Capture { solver, values: Vec::new(), systems: Systems::default() };
    let mut options = Options::default();
    options.set("tol", 1e-2);
    options.set("mu_init", 1.0);
    options.set("max_iter", 80);
    let start = Start::Cold(transcription.formulation().initial_guess());
    let own = LinearSystemSolver::Own(&mut capture);
    nlp::solve(transcription, &start, &options, own, &mut |_| Control::Continue).unwrap();
    let mut systems = capture.systems;
    let step = systems.samples.len().div_ceil(SAMPLES);
    systems.samples = systems.samples.into_iter().step_by(step).collect();
    systems
}

/// feral as a solver of Ipopt's systems.
#[derive(Default)]
struct Feral {
    solver: feral::Solver,
    dimension: usize,
    rows: Vec<usize>,
    columns: Vec<usize>,
}

impl KktSolver for Feral {
    fn name(&self) -> &str {
        "feral"
    }

    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError> {
        self.dimension = dimension;
        let lower = rows.iter().zip(columns).map(|(&row, &column)| (row.max(column), row.min(column)));
        (self.rows, self.columns) = lower.unzip();
        self.solver = feral::Solver::new().with_parallel(false);
        Ok(())
    }

    fn factorise(&mut self, values: &[f64]) -> Factorisation {
        let matrix = CscMatrix::from_triplets(self.dimension, &self.rows, &self.columns, values).unwrap();
        match (self.solver.factor(&matrix, None), self.solver.inertia()) {
            (FactorStatus::Success, Some(inertia)) => Factorisation::Inertia { negative: inertia.negative },
            _ => Factorisation::Failed,
        }
    }

    fn solve(&mut self, values: &mut [f64]) -> bool {
        self.solver.solve(values).is_ok_and(|solution| {
            values.copy_from_slice(&solution);
            true
        })
    }

    fn increase_quality(&mut self) {}
}

/// Measurements of a solver, matrix by matrix.
#[derive(Default)]
struct Figures {
    name: String,
    /// With cold caches, then with warm ones.
    factorise: [Vec<f64>; 2],
    solve: [Vec<f64>; 2],
    errors: Vec<f64>,
    found: Vec<Factorisation>,
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

fn measure(systems: &Systems, solvers: &mut [&mut dyn KktSolver]) -> Vec<Figures> {
    let new = |solver: &&mut dyn KktSolver| Figures { name: solver.name().to_owned(), ..Figures::default() };
    let mut figures: Vec<Figures> = solvers.iter().map(new).collect();
    for solver in &mut *solvers {
        solver.analyse(systems.dimension, &systems.rows, &systems.columns).unwrap();
        solver.factorise(&systems.samples[0].0);
    }
    for (values, right) in &systems.samples {
        for (solver, figures) in solvers.iter_mut().zip(&mut figures) {
            for caches in 0..2 {
                let begin = ThreadTime::now();
                let found = solver.factorise(values);
                figures.factorise[caches].push(begin.elapsed().as_secs_f64());
                let mut solution = right.clone();
                let begin = ThreadTime::now();
                assert!(solver.solve(&mut solution), "{} cannot solve", solver.name());
                figures.solve[caches].push(begin.elapsed().as_secs_f64());
                figures.found.push(found);
                figures.errors.push(systems.backward_error(values, &solution, right));
            }
        }
    }
    figures
}

fn report(scene: &str, systems: &Systems, figures: &[Figures]) {
    let reference = figures.iter().find(|figures| figures.name == nlp::MUMPS).expect("MUMPS is measured");
    for solver in figures {
        print!("{scene:8} {:6} {:8} {:6}", systems.dimension, systems.rows.len(), solver.name);
        for caches in [1, 0] {
            let [factorise, solve] = [&solver.factorise, &solver.solve].map(|times| median(&times[caches]));
            let others = median(&reference.factorise[caches]) + median(&reference.solve[caches]);
            print!(" {:8.2} {:6.2} {:5.1}", 1e3 * factorise, 1e3 * solve, others / (factorise + solve));
        }
        let agreeing = solver.found.iter().zip(&reference.found).filter(|(own, other)| own == other).count();
        println!(" {:7.0e} {agreeing:4} of {}", median(&solver.errors), solver.found.len());
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let scenes = if arguments.is_empty() { SCENES.map(str::to_owned).to_vec() } else { arguments };
    println!("                                     warm caches            cold caches           ");
    println!("scene      rows  entries solver   factor  solve times   factor  solve times   error inertia as MUMPS");
    for scene in scenes {
        let mut transcription = Transcription::new(&task(&scene), Complementarity::Relaxation, HessianKind::Exact);
        transcription.set_smoothing(0.0025, 0.00125);
        let systems = capture(&mut transcription);
        let mut stage = TranscriptionSolver::new(transcription.layout(), Workers::default());
        let (mut mumps, mut feral) = (Mumps::new(), Feral::default());
        let figures = measure(&systems, &mut [&mut stage, &mut mumps, &mut feral]);
        report(&scene, &systems, &figures);
    }
}

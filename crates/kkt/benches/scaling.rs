//! Time of an analysis, a factorisation and a solve as a function of stages, scenarios and pairs: medians of processor
//! time in milliseconds, on random matrices.

#[path = "../tests/main/support/mod.rs"]
#[allow(dead_code, reason = "tests use the rest")]
mod support;

use std::hint::black_box;

use cpu_time::ThreadTime;
use kkt::{Factorisation, StageSolver};
use support::{Random, Shape, System};

/// A problem of the size of a peg's.
const PEG: Shape = Shape { stages: 100, scenarios: 3, pairs: 6, smoothing: false, delta_w: 1e4, delta_c: 0.0, seed: 1 };
const REPETITIONS: usize = 21;

/// Median milliseconds of a function.
fn median<T>(mut function: impl FnMut() -> T) -> f64 {
    let mut times: Vec<f64> = (0..REPETITIONS)
        .map(|_| {
            let begin = ThreadTime::now();
            black_box(function());
            1e3 * begin.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPETITIONS / 2]
}

fn measure(what: &str, size: usize, shape: &Shape) {
    let system = System::random(shape);
    let analyse = || StageSolver::new(&system.labels, &system.rows, &system.columns).unwrap();
    let mut solver = analyse();
    let analysis = median(analyse);
    let factorisation = median(|| solver.factorise(&system.values));
    assert_eq!(solver.factorise(&system.values), Factorisation::Inertia { negative: system.multipliers() });
    assert_eq!(solver.report().fallbacks.total(), 0);
    let right = Random(7).vector(system.dimension());
    let mut solution = right.clone();
    let solve = median(|| {
        solution.copy_from_slice(&right);
        assert!(solver.solve(&mut solution));
    });
    println!("{what:9} {size:4} {:7} {analysis:9.2} {factorisation:9.2} {solve:8.2}", system.dimension());
}

fn main() {
    println!("               rows analysis  factorise    solve");
    for stages in [25, 50, 100, 200, 400] {
        measure("stages", stages, &Shape { stages, ..PEG });
    }
    for scenarios in [1, 3, 5, 9] {
        measure("scenarios", scenarios, &Shape { scenarios, ..PEG });
    }
    for pairs in [3, 6, 12, 24, 48] {
        measure("pairs", pairs, &Shape { pairs, ..PEG });
    }
}

//! How the time of a factorisation and of a solve grows with stages, scenarios and pairs.

#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use kkt::{Factorisation, StageSolver};
use support::{Random, Shape, System};

/// A problem of the size of a peg's.
const PEG: Shape = Shape { stages: 100, scenarios: 3, pairs: 6, smoothing: false, delta_w: 1e4, delta_c: 0.0, seed: 1 };

fn measure(criterion: &mut Criterion, what: &str, shapes: impl Iterator<Item = (usize, Shape)>) {
    let mut group = criterion.benchmark_group(what);
    for (size, shape) in shapes {
        let system = System::random(&shape);
        group.throughput(Throughput::Elements(size as u64));
        let analyse = || StageSolver::new(&system.labels, &system.rows, &system.columns).unwrap();
        let mut solver = analyse();
        group.bench_function(BenchmarkId::new("analyse", size), |bencher| bencher.iter(analyse));
        group.bench_function(BenchmarkId::new("factorise", size), |bencher| {
            bencher.iter(|| solver.factorise(black_box(&system.values)));
        });
        assert_eq!(solver.factorise(&system.values), Factorisation::Inertia { negative: system.multipliers() });
        assert_eq!(solver.report().fallbacks.total(), 0);
        let right = Random(7).vector(system.dimension());
        group.bench_function(BenchmarkId::new("solve", size), |bencher| {
            bencher.iter(|| {
                let mut solution = right.clone();
                assert!(solver.solve(&mut solution));
                solution
            });
        });
    }
    group.finish();
}

fn scaling(criterion: &mut Criterion) {
    let stages = [25, 50, 100, 200, 400].map(|stages| (stages, Shape { stages, ..PEG }));
    measure(criterion, "stages", stages.into_iter());
    let scenarios = [1, 3, 5, 9].map(|scenarios| (scenarios, Shape { scenarios, ..PEG }));
    measure(criterion, "scenarios", scenarios.into_iter());
    let pairs = [3, 6, 12, 24, 48].map(|pairs| (pairs, Shape { pairs, ..PEG }));
    measure(criterion, "pairs", pairs.into_iter());
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = scaling
}
criterion_main!(benches);

//! One time step of an impedance-controlled body at 300 points: by tape and by hand-written loops over `f64`.

#[path = "stage/by_hand.rs"]
mod by_hand;
#[path = "stage/step.rs"]
mod step;

use std::hint::black_box;

use autodiff::{Batch, Instructions, Tape, Workspace};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use step::{INPUTS, OUTPUTS};

const POINTS: usize = 300;

fn stage(criterion: &mut Criterion) {
    let tape = Tape::record(INPUTS, |x| step::step(x).to_vec());
    let (jacobian, hessian) = (tape.jacobian(INPUTS), tape.lagrangian_hessian(INPUTS));
    let points: Vec<[f64; INPUTS + OUTPUTS]> = (0..POINTS).map(step::sample).collect();
    let mut inputs = Batch::new(INPUTS + OUTPUTS, POINTS);
    for (point, sample) in points.iter().enumerate() {
        for (row, value) in sample.iter().enumerate() {
            inputs.row_mut(row)[point] = *value;
        }
    }
    let mut group = criterion.benchmark_group("stage");
    group.throughput(Throughput::Elements(POINTS as u64));
    by_tape(&mut group, "values", &tape, &inputs);
    by_plain_loop(&mut group, "values", &points, |x, values: &mut [f64; OUTPUTS]| *values = step::step(&x[..INPUTS]));
    by_tape(&mut group, "jacobian", jacobian.tape(), &inputs);
    by_plain_loop(&mut group, "jacobian", &points, by_hand::jacobian);
    by_tape(&mut group, "hessian", hessian.tape(), &inputs);
    by_plain_loop(&mut group, "hessian", &points, by_hand::hessian);
    group.bench_function("recording and differentiating", |bencher| {
        bencher.iter(|| {
            let tape = Tape::record(INPUTS, |x| step::step(x).to_vec());
            (tape.jacobian(INPUTS), tape.lagrangian_hessian(INPUTS))
        });
    });
    group.finish();
}

fn by_tape(group: &mut BenchmarkGroup<WallTime>, name: &str, tape: &Tape, inputs: &Batch) {
    let mut outputs = Batch::new(tape.output_count(), POINTS);
    let mut workspace = Workspace::default();
    for (set, instructions) in [("", Instructions::best()), (", no vectors", Instructions::scalar())] {
        group.bench_function(format!("{name} by tape{set} ({} operations)", tape.operation_count()), |bencher| {
            bencher.iter(|| tape.evaluate_with(instructions, black_box(inputs), &mut outputs, &mut workspace));
        });
    }
}

fn by_plain_loop<const N: usize>(
    group: &mut BenchmarkGroup<WallTime>,
    name: &str,
    points: &[[f64; INPUTS + OUTPUTS]],
    function: impl Fn(&[f64; INPUTS + OUTPUTS], &mut [f64; N]),
) {
    let mut outputs = vec![[0.0; N]; POINTS];
    group.bench_function(format!("{name} by hand"), |bencher| {
        bencher.iter(|| {
            for (point, output) in black_box(points).iter().zip(black_box(&mut outputs)) {
                function(point, output);
            }
        });
    });
}

criterion_group!(benches, stage);
criterion_main!(benches);

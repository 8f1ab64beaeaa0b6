//! One step of an impedance-controlled body at 300 points: by tape and by hand-written loops.

use std::hint::black_box;

use autodiff::{Batch, Expression, Tape, Workspace};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const POINTS: usize = 300;
const INPUTS: usize = 39;
const TIME_STEP: f64 = 0.04;
const OFFSET: [f64; 3] = [0.01, -0.02, 0.005];

/// Scalars that the step can be computed with: tape expressions and plain numbers.
trait Scalar:
    Copy
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Mul<f64, Output = Self>
{
}
impl Scalar for f64 {}
impl Scalar for Expression<'_> {}

/// Previous state, state, reference state to 13 defects.
fn step<T: Scalar>(x: &[T]) -> [T; 13] {
    let (last, rest) = x.split_at(13);
    let (now, reference) = rest.split_at(13);
    let [w, i, j, k] = [now[3], now[4], now[5], now[6]];
    let [a, b, c, d] = [reference[3], reference[4], reference[5], reference[6]];
    let [p, q, r] = [now[10], now[11], now[12]];
    let rates = [(i * p + j * q + k * r) * -1.0, w * p + j * r - k * q, w * q + k * p - i * r, w * r + i * q - j * p];
    let arm = [
        (w * w + i * i - j * j - k * k) * OFFSET[0]
            + (i * j - w * k) * (2.0 * OFFSET[1])
            + (i * k + w * j) * (2.0 * OFFSET[2]),
        (i * j + w * k) * (2.0 * OFFSET[0])
            + (w * w - i * i + j * j - k * k) * OFFSET[1]
            + (j * k - w * i) * (2.0 * OFFSET[2]),
        (i * k - w * j) * (2.0 * OFFSET[0])
            + (j * k + w * i) * (2.0 * OFFSET[1])
            + (w * w - i * i - j * j + k * k) * OFFSET[2],
    ];
    let scalar = w * a + i * b + j * c + k * d;
    let vector = [w * b - i * a - j * d + k * c, w * c + i * d - j * a - k * b, w * d - i * c + j * b - k * a];
    std::array::from_fn(|row| match row {
        0..3 => now[row] - last[row] - now[7 + row] * TIME_STEP,
        3..7 => now[row] - last[row] - rates[row - 3] * (0.5 * TIME_STEP),
        7..10 => {
            let axis = row - 7;
            let force = (reference[axis] - now[axis] - arm[axis]) * 50.0 + (reference[row] - now[row]) * 14.0;
            now[row] - last[row] - force * TIME_STEP
        }
        _ => {
            let torque = scalar * vector[row - 10] * 10.0 + (reference[row] - now[row]) * 1.4;
            now[row] - last[row] - torque * (10.0 * TIME_STEP)
        }
    })
}

fn points() -> Batch {
    let mut inputs = Batch::new(INPUTS + 13, POINTS);
    for row in 0..INPUTS + 13 {
        for (point, value) in inputs.row_mut(row).iter_mut().enumerate() {
            *value = ((row * 7 + point * 3) as f64 * 0.618).fract() - 0.5;
        }
    }
    inputs
}

fn stage(criterion: &mut Criterion) {
    let tape = Tape::record(INPUTS, |x| step(x).to_vec());
    let (jacobian, hessian) = (tape.jacobian(INPUTS), tape.lagrangian_hessian(INPUTS));
    let inputs = points();
    let mut workspace = Workspace::default();
    let mut group = criterion.benchmark_group("stage");
    group.throughput(Throughput::Elements(POINTS as u64));
    for (name, tape) in [("values", &tape), ("jacobian", jacobian.tape()), ("hessian", hessian.tape())] {
        let mut outputs = Batch::new(tape.output_count(), POINTS);
        group.bench_function(format!("{name} by tape"), |bencher| {
            bencher.iter(|| tape.evaluate(black_box(&inputs), &mut outputs, &mut workspace));
        });
    }
    let rows: Vec<[f64; INPUTS]> =
        (0..POINTS).map(|point| std::array::from_fn(|input| inputs.row(input)[point])).collect();
    group.bench_function("values by plain f64", |bencher| {
        bencher.iter(|| rows.iter().map(|row| step(black_box(row)).iter().sum::<f64>()).sum::<f64>());
    });
    group.finish();
}

criterion_group!(benches, stage);
criterion_main!(benches);

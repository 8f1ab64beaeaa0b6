//! What a rollout in joint space needs in each step: mass matrix, bias and Jacobian, of an arm with six joints and
//! of one with seven.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use robot::{Arm, JointVector};

fn dynamics(criterion: &mut Criterion) {
    for name in ["six", "seven"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms").join(name).with_extension("urdf");
        let arm = Arm::read(&path, "tip").expect("a valid arm");
        let configuration = JointVector::from_fn(|joint, _| 0.3 + 0.2 * joint as f64);
        let velocity = JointVector::from_fn(|joint, _| 0.5 - 0.1 * joint as f64);
        criterion.bench_function(&format!("mass matrix, bias and Jacobian of {name} joints"), |bencher| {
            bencher.iter(|| {
                let configured = arm.at(black_box(&configuration));
                (configured.mass_matrix(), configured.bias(black_box(&velocity)), configured.jacobian())
            });
        });
        criterion.bench_function(&format!("apparent inertia of {name} joints"), |bencher| {
            bencher.iter(|| arm.at(black_box(&configuration)).apparent_inertia());
        });
    }
}

criterion_group!(benches, dynamics);
criterion_main!(benches);

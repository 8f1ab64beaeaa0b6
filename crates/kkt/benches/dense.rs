//! One dense symmetric indefinite matrix: this crate's front, in every instruction set, and faer's Bunch-Kaufman.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::lblt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::{Mat, Par, Spec};
use kkt::{Class, Label, Owner, StageSolver};
use pulp::Arch;
use workers::Workers;

/// Symmetric, with eigenvalues of both signs.
fn entry(row: usize, column: usize) -> f64 {
    let noise = ((row.max(column) * 31 + row.min(column) * 17) as f64 * 12.9898).sin();
    if row == column { 4.0 * noise } else { noise }
}

fn ours(criterion: &mut Criterion, order: usize) {
    let label = |index| Label { stage: 1, owner: Owner::Reference, class: Class::OtherVariable, index };
    let labels: Vec<Label> = (0..order).map(label).collect();
    let (rows, columns): (Vec<usize>, Vec<usize>) =
        (0..order).flat_map(|row| (0..=row).map(move |column| (row, column))).unzip();
    let values: Vec<f64> = rows.iter().zip(&columns).map(|(&row, &column)| entry(row, column)).collect();
    let mut arches = vec![("ours, scalar", Arch::Scalar)];
    #[cfg(target_arch = "x86_64")]
    {
        arches.extend(pulp::x86::V3::try_new().map(|simd| ("ours, AVX2", Arch::V3(simd))));
        arches.extend(pulp::x86::V4::try_new().map(|simd| ("ours, AVX-512", Arch::V4(simd))));
    }
    #[cfg(target_arch = "aarch64")]
    arches.extend(pulp::aarch64::Neon::try_new().map(|simd| ("ours, NEON", Arch::Neon(simd))));
    for (name, arch) in arches {
        let mut solver = StageSolver::with_arch(&labels, &rows, &columns, arch, Workers::default()).unwrap();
        criterion.bench_function(&format!("{name}/{order}"), |bencher| {
            bencher.iter(|| solver.factorise(black_box(&values)));
        });
    }
}

fn faers(criterion: &mut Criterion, order: usize) {
    let matrix = Mat::from_fn(order, order, entry);
    let mut factors = matrix.clone();
    let mut subdiagonal = Diag::<f64>::zeros(order);
    let (mut forward, mut backward) = (vec![0usize; order], vec![0usize; order]);
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<usize, f64>(order, Par::Seq, Spec::default()));
    criterion.bench_function(&format!("faer/{order}"), |bencher| {
        bencher.iter(|| {
            factors.copy_from(black_box(&matrix));
            let stack = MemStack::new(&mut memory);
            let (subdiagonal, default) = (subdiagonal.as_mut(), Spec::default());
            cholesky_in_place(factors.as_mut(), subdiagonal, &mut forward, &mut backward, Par::Seq, stack, default);
        });
    });
}

fn dense(criterion: &mut Criterion) {
    for order in [42, 68, 98, 150] {
        ours(criterion, order);
        faers(criterion, order);
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30);
    targets = dense
}
criterion_main!(benches);

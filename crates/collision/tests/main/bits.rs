//! The same bits on every processor, not only with every instruction set of one.

use collision::{Instructions, Pair, Polytope, Request, Solutions};

/// Numbers between -1 and 1 that need nothing but integers and one multiplication, which are exact everywhere.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * 2f64.powi(-52) - 1.0
    }

    fn part(&mut self) -> Polytope {
        let corners: Vec<[f64; 3]> = (0..12).map(|_| [(); 3].map(|()| 0.05 * self.next())).collect();
        Polytope::from_vertices(&corners).unwrap()
    }
}

/// Hash of all bits (FNV-1a).
fn hash(values: &[f64]) -> u64 {
    let bytes = values.iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Whoever changes the order of operations in the kernel writes the new hash here, after both `cargo test` and
/// `scripts/test-aarch64` have shown it.
#[test]
fn distances_and_derivatives_have_the_same_bits_on_every_processor() {
    let mut numbers = Numbers(1);
    let pair = Pair::new(numbers.part(), numbers.part());
    let poses: Vec<[f64; 7]> = (0..37)
        .map(|_| std::array::from_fn(|index| if index < 3 { 0.1 * numbers.next() } else { numbers.next() }))
        .collect();
    let seeds: Vec<[f64; 7]> = poses.iter().map(|_| [(); 7].map(|()| numbers.next())).collect();
    for instructions in Instructions::available() {
        let zeros = vec![[[0.0; 7]; 7]; poses.len()];
        let (mut values, mut jacobians, mut hessians) = (vec![[0.0; 7]; poses.len()], zeros.clone(), zeros);
        let mut all: Vec<f64> = Vec::new();
        for tau in [2.5e-3, 1e-5, 1e-7] {
            for request in [Request::Jacobians(&mut values, &mut jacobians), Request::Hessians(&seeds, &mut hessians)] {
                pair.evaluate(instructions, &poses, tau, &mut Solutions::default(), request).unwrap();
            }
            all.extend(values.iter().flatten());
            all.extend([&jacobians, &hessians].into_iter().flatten().flatten().flatten());
        }
        assert_eq!(hash(&all), 0xde08_a518_4a34_c3d3, "{instructions:?}");
    }
}

//! Solves many poses of hard families with several smoothings, and counts failures and iterations.
//!
//! `cargo run --release -p collision --example robustness [poses per family]` (default 1 000 000)

use std::f64::consts::TAU;

use collision::{Instructions, Pair, Polytope, Request, Solutions};

const SMOOTHINGS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
/// Poses per call.
const BATCH: usize = 1000;

/// SplitMix64: reproducible random values without a dependency.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Uniform in `low..high`.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * self.between(f64::MIN_POSITIVE, 1.0).ln()).sqrt();
        radius * self.between(0.0, TAU).cos()
    }

    fn vector(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.between(-size, size))
    }

    fn direction(&mut self) -> [f64; 3] {
        let vector: [f64; 3] = std::array::from_fn(|_| self.normal());
        let length = vector.iter().map(|component| component * component).sum::<f64>().sqrt();
        vector.map(|component| component / length)
    }

    fn quaternion(&mut self) -> [f64; 4] {
        std::array::from_fn(|_| self.normal())
    }

    fn index(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    fn choose<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.index(choices.len())]
    }
}

fn pose([x, y, z]: [f64; 3], [w, i, j, k]: [f64; 4]) -> [f64; 7] {
    [x, y, z, w, i, j, k]
}

/// A family of problems: random pairs and poses.
struct Family {
    name: &'static str,
    pair: fn(&mut Random) -> Pair,
    pose: fn(&mut Random) -> [f64; 7],
}

fn cuboid(edges: [f64; 3]) -> Polytope {
    Polytope::from_box(edges).expect("positive edge lengths")
}

fn cubes(_: &mut Random) -> Pair {
    Pair::new(cuboid([0.1; 3]), cuboid([0.1; 3]))
}

fn boxes(random: &mut Random) -> Pair {
    let mut part = || cuboid(std::array::from_fn(|_| random.between(0.02, 0.2)));
    Pair::new(part(), part())
}

/// The same irregular part twice.
fn twins(random: &mut Random) -> Pair {
    loop {
        let points: Vec<[f64; 3]> = (0..8).map(|_| random.vector(0.05)).collect();
        if let Ok(part) = Polytope::from_vertices(&points) {
            return Pair::new(part.clone(), part);
        }
    }
}

fn plates(_: &mut Random) -> Pair {
    Pair::new(cuboid([0.2, 0.2, 0.002]), cuboid([0.2, 0.2, 0.002]))
}

fn small_cubes(_: &mut Random) -> Pair {
    Pair::new(cuboid([0.001; 3]), cuboid([0.001; 3]))
}

fn many_facets(random: &mut Random) -> Pair {
    let mut part = || {
        loop {
            let count = 30 + random.index(71);
            let normals: Vec<[f64; 3]> = (0..count).map(|_| random.direction()).collect();
            let offsets = vec![0.05; count];
            if let Ok(part) = Polytope::from_halfspaces(&normals, &offsets) {
                return part;
            }
        }
    };
    Pair::new(part(), part())
}

fn random_pose(random: &mut Random) -> [f64; 7] {
    pose(random.vector(0.2), random.quaternion())
}

fn far_pose(random: &mut Random) -> [f64; 7] {
    pose(random.direction().map(|component| 10.0 * component), random.quaternion())
}

fn deep_pose(random: &mut Random) -> [f64; 7] {
    pose(random.vector(0.01), random.quaternion())
}

fn tiny_pose(random: &mut Random) -> [f64; 7] {
    pose(random.vector(0.002), random.quaternion())
}

/// Aligned axes and the same centre, or centres that differ a little along one axis.
fn coincident_pose(random: &mut Random) -> [f64; 7] {
    let mut position = [0.0; 3];
    position[random.index(3)] = random.choose(&[0.0, 0.0, 1e-12, 1e-6]);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    pose(position, random.choose(&[[1.0, 0.0, 0.0, 0.0], [half, half, 0.0, 0.0], [half, 0.0, 0.0, -half]]))
}

fn face_to_face_pose(random: &mut Random) -> [f64; 7] {
    let side = random.choose(&[-0.1, 0.1]);
    let axis = random.index(3);
    let shifts = [0.0, 0.02, -0.05, 0.1];
    let mut position = std::array::from_fn(|_| random.choose(&shifts));
    position[axis] = side + random.choose(&[0.0, 0.0, 1e-3, -1e-3, 1e-9]);
    pose(position, [1.0, 0.0, 0.0, 0.0])
}

fn edge_to_edge_pose(random: &mut Random) -> [f64; 7] {
    // Turned by 45 degrees about an axis: parallel or crossed edges that touch exactly.
    let (cosine, sine) = (TAU / 16.0).sin_cos();
    let quaternion = random.choose(&[[sine, cosine, 0.0, 0.0], [sine, 0.0, cosine, 0.0], [sine, 0.0, 0.0, cosine]]);
    let reach = 0.05 + 0.05 * std::f64::consts::SQRT_2;
    let mut position = [0.0; 3];
    position[random.index(3)] = random.choose(&[-reach, reach]);
    position[random.index(3)] += random.choose(&[0.0, 0.01, 1e-9]);
    pose(position, quaternion)
}

fn plate_pose(random: &mut Random) -> [f64; 7] {
    let position = [random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.choose(&[0.0, 0.002, 0.001, 0.05])];
    let quaternion = if random.index(2) == 0 { [1.0, 0.0, 0.0, 0.0] } else { random.quaternion() };
    pose(position, quaternion)
}

const FAMILIES: [Family; 9] = [
    Family { name: "random", pair: boxes, pose: random_pose },
    Family { name: "10 m apart", pair: cubes, pose: far_pose },
    Family { name: "deep", pair: boxes, pose: deep_pose },
    Family { name: "coincident", pair: twins, pose: coincident_pose },
    Family { name: "face to face", pair: cubes, pose: face_to_face_pose },
    Family { name: "edge to edge", pair: cubes, pose: edge_to_edge_pose },
    Family { name: "1:100 plates", pair: plates, pose: plate_pose },
    Family { name: "1 mm cubes", pair: small_cubes, pose: tiny_pose },
    Family { name: "30-100 facets", pair: many_facets, pose: random_pose },
];

fn main() {
    let count = std::env::args().nth(1).map_or(1_000_000, |text| text.parse().expect("a number of poses"));
    println!("{:<14} {:>8} {:>9} {:>9} {:>15}", "family", "tau", "solves", "failures", "max iterations");
    for family in &FAMILIES {
        let mut random = Random(7);
        let batches = usize::div_ceil(count, BATCH);
        let mut totals = [(0, 0, 0); SMOOTHINGS.len()];
        for _ in 0..batches {
            let pair = (family.pair)(&mut random);
            let poses: Vec<[f64; 7]> = (0..BATCH).map(|_| (family.pose)(&mut random)).collect();
            let mut values = [[0.0; 7]; BATCH];
            for (tau, (solves, failures, iterations)) in SMOOTHINGS.iter().zip(&mut totals) {
                *solves += BATCH;
                let mut start = 0;
                // A batch ends at its first failure.
                while start < BATCH {
                    let request = Request::Values(&mut values[start..]);
                    let solutions = &mut Solutions::default();
                    match pair.evaluate(Instructions::best(), &poses[start..], *tau, solutions, request) {
                        Ok(needed) => {
                            *iterations = needed.max(*iterations);
                            break;
                        }
                        Err(error) => {
                            *failures += 1;
                            eprintln!("{}: {error}", family.name);
                            start += error.index + 1;
                        }
                    }
                }
            }
        }
        for (tau, (solves, failures, iterations)) in SMOOTHINGS.iter().zip(totals) {
            println!("{:<14} {tau:>8.0e} {solves:>9} {failures:>9} {iterations:>15}", family.name);
        }
    }
}

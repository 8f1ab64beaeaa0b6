//! Mean time per pose for values, and for Jacobians and Hessians by themselves where the solutions are kept, with few and
//! many facets and all instruction sets.
//!
//! `cargo bench -p collision`. Times are processor times where the system reports them (Linux), else wall times. On a
//! busy machine, wall times include waits for the scheduler.

use std::time::Instant;

use collision::{Instructions, Pair, Polytope, Request, Solutions};

const POSES: usize = 1000;
const SMOOTHINGS: [f64; 3] = [2.5e-3, 1e-4, 1e-6];
/// Duration of a measurement (s).
const DURATION: f64 = 0.1;

/// Reproducible random values in -1..1 (xorshift64*).
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A cube, or a polytope of random planes that touch a sphere.
fn part(facets: usize, random: &mut Random) -> Polytope {
    if facets == 6 {
        return Polytope::from_box([0.1; 3]).expect("a cube");
    }
    loop {
        let normals: Vec<[f64; 3]> = (0..facets).map(|_| std::array::from_fn(|_| random.number())).collect();
        let length = |normal: &[f64; 3]| normal.iter().map(|component| component * component).sum::<f64>().sqrt();
        let offsets: Vec<f64> = normals.iter().map(|normal| 0.05 * length(normal)).collect();
        match Polytope::from_halfspaces(&normals, &offsets) {
            Ok(part) if part.normals().len() == facets => return part,
            _ => {}
        }
    }
}

/// Processor time since the program began (s), or wall time where the system does not report it.
fn seconds(begin: Instant) -> f64 {
    let statistics = std::fs::read_to_string("/proc/self/schedstat").ok();
    let running = statistics.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    running.map_or_else(|| begin.elapsed().as_secs_f64(), |nanoseconds| 1e-9 * nanoseconds)
}

/// Mean microseconds per pose, over a duration much longer than the resolution of the system's clock.
fn mean(mut evaluate: impl FnMut()) -> f64 {
    let begin = Instant::now();
    evaluate();
    let first = seconds(begin);
    let mut count = 0;
    while count < 5 || seconds(begin) - first < DURATION {
        evaluate();
        count += 1;
    }
    (seconds(begin) - first) * 1e6 / (count * POSES) as f64
}

fn main() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut record = |size: f64| -> [f64; 7] {
        std::array::from_fn(|index| if index < 3 { size * random.number() } else { random.number() })
    };
    let poses: Vec<[f64; 7]> = (0..POSES).map(|_| record(0.15)).collect();
    let seeds: Vec<[f64; 7]> = (0..POSES).map(|_| record(1.0)).collect();
    let (mut values, mut jacobians) = (vec![[0.0; 7]; POSES], vec![[[0.0; 7]; 7]; POSES]);
    let mut hessians = jacobians.clone();
    println!("microseconds per pose");
    println!("{:>4} {:<7} {:>7} {:>8} {:>10} {:>10}", "rows", "with", "tau", "values", "Jacobian", "Hessian");
    for rows in [12, 24, 60, 120] {
        let pair = Pair::new(part(rows / 2, &mut random), part(rows / 2, &mut random));
        for instructions in Instructions::available() {
            let name = format!("{instructions:?}");
            for tau in SMOOTHINGS {
                let run = |solutions: &mut Solutions, request: Request| {
                    pair.evaluate(instructions, &poses, tau, solutions, request).expect("converges");
                };
                let plain = mean(|| run(&mut Solutions::default(), Request::Values(&mut values)));
                let mut kept = Solutions::default();
                let first = mean(|| run(&mut kept, Request::Jacobians(&mut values, &mut jacobians)));
                let second = mean(|| run(&mut kept, Request::Hessians(&seeds, &mut hessians)));
                println!("{rows:>4} {name:<7} {tau:>7.0e} {plain:>8.3} {first:>10.3} {second:>10.3}");
            }
        }
    }
}

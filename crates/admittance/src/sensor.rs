//! The force-torque sensor in discrete time.

use nalgebra::Vector3;

use crate::robot::Sensor;

/// Filtered wrench, and the noise of samples.
#[derive(Debug, Clone)]
pub struct Measurement {
    sensor: Sensor,
    bias: [Vector3<f64>; 2],
    deadband: [f64; 2],
    filtered: [Vector3<f64>; 2],
    noise: Noise,
}

impl Measurement {
    /// At rest and unloaded, with a bias of force (N) and torque (Nm). Noise is the same in every rollout.
    pub fn new(sensor: Sensor, bias: [Vector3<f64>; 2], deadband: [f64; 2]) -> Self {
        Self { sensor, bias, deadband, filtered: [Vector3::zeros(); 2], noise: Noise(SEED) }
    }

    /// Filters a force (N) and a torque (Nm) that act for some time (s).
    pub fn filter(&mut self, wrench: [Vector3<f64>; 2], time: f64) {
        let share = -(-std::f64::consts::TAU * self.sensor.cutoff * time).exp_m1();
        for (filtered, value) in self.filtered.iter_mut().zip(wrench) {
            *filtered += (value - *filtered) * share;
        }
    }

    /// A sample: force (N) and torque (Nm), with bias, noise, resolution and deadband.
    pub fn sample(&mut self) -> [Vector3<f64>; 2] {
        [0, 1].map(|part| {
            let (noise, resolution, deadband) =
                (self.sensor.noise[part], self.sensor.resolution[part], self.deadband[part]);
            (self.filtered[part] + self.bias[part]).map(|value| {
                let noisy = if noise > 0.0 { value + noise * self.noise.next() } else { value };
                let given = if resolution > 0.0 { (noisy / resolution).round() * resolution } else { noisy };
                given - given.clamp(-deadband, deadband)
            })
        })
    }
}

const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// Pseudorandom numbers with mean 0 and standard deviation 1: sums of twelve uniform ones, by the generator of splitmix64.
#[derive(Debug, Clone)]
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }

    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(SEED);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SENSOR: Sensor = Sensor { cutoff: 10.0, noise: [0.0; 2], resolution: [0.0; 2] };

    fn force(x: f64) -> [Vector3<f64>; 2] {
        [Vector3::new(x, 0.0, 0.0), Vector3::zeros()]
    }

    #[test]
    fn a_step_passes_the_filter_by_its_time_constant() {
        let mut measurement = Measurement::new(SENSOR, force(0.5), [0.0; 2]);
        let time_constant = 1.0 / (std::f64::consts::TAU * 10.0);
        for _ in 0..100 {
            measurement.filter(force(8.0), time_constant / 100.0);
        }
        let [sample, _] = measurement.sample();
        assert!((sample.x - 0.5 - 8.0 * (1.0 - (-1.0_f64).exp())).abs() < 1e-12);
    }

    #[test]
    fn samples_are_rounded_and_small_ones_are_ignored() {
        let sensor = Sensor { resolution: [0.4, 0.4], cutoff: 1e9, ..SENSOR };
        let mut measurement = Measurement::new(sensor, force(0.0), [1.0, 0.0]);
        for (applied, seen) in [(0.9, 0.0), (2.1, 1.0), (-2.1, -1.0)] {
            measurement.filter(force(applied), 1.0);
            assert!((measurement.sample()[0].x - seen).abs() < 1e-12, "{applied}");
        }
    }

    #[test]
    fn noise_has_its_standard_deviation() {
        let sensor = Sensor { noise: [0.2, 0.0], ..SENSOR };
        let mut measurement = Measurement::new(sensor, force(0.0), [0.0; 2]);
        let samples: Vec<f64> = (0..20_000).flat_map(|_| Vec::from(measurement.sample()[0].as_slice())).collect();
        let mean = samples.iter().sum::<f64>() / samples.len() as f64;
        let variance = samples.iter().map(|sample| (sample - mean).powi(2)).sum::<f64>() / samples.len() as f64;
        assert!(mean.abs() < 0.005 && (variance.sqrt() - 0.2).abs() < 0.005, "{mean} {variance}");
    }
}

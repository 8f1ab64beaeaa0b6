//! Forces of a motion on parts and controller.

use std::collections::VecDeque;

use task::{FORCE_WINDOW, Limits, Wrench};

/// A window that lacks less than this part of itself is full: steps do not add up exactly.
const ROUNDING: f64 = 1e-6;

/// Largest loads of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Loads {
    /// Normal force of a pair (N), the mean over 10 ms.
    pub contact_force: f64,
    /// Component of the controller's force after any step (N, world frame).
    pub force: f64,
    /// Component of the controller's torque after any step (Nm, body frame).
    pub torque: f64,
}

impl Loads {
    /// Those of a rollout of which nothing is known: beyond any limit.
    pub const UNBOUNDED: Self = Self { contact_force: f64::INFINITY, force: f64::INFINITY, torque: f64::INFINITY };

    /// Excess over the limits: the sum of the three excesses, each as a fraction of its limit.
    pub fn excess(&self, limits: &Limits) -> f64 {
        let Self { contact_force, force, torque } = self;
        let pairs = [(contact_force, limits.contact_force), (force, limits.force), (torque, limits.torque)];
        // Comparisons are false for what is no number.
        let excess = |load: f64, limit: f64| if load <= limit { 0.0 } else { larger(load / limit - 1.0, 0.0) };
        pairs.iter().map(|(load, limit)| excess(**load, *limit)).sum()
    }
}

/// The larger one of two numbers; infinite if one is no number.
pub fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::INFINITY } else { one.max(other) }
}

/// Records the loads of a motion.
#[derive(Debug, Clone)]
pub struct LoadMeter {
    largest: Loads,
    /// The steps of the last 10 ms: duration (s), and normal impulse (Ns) of every pair that pushes. The first may have
    /// begun earlier.
    steps: VecDeque<(f64, Vec<(usize, f64)>)>,
    /// Sum of their durations (s).
    elapsed: f64,
    /// Sum of their impulses (Ns), for every pair.
    impulses: Vec<f64>,
    /// Lists of dropped steps, to be reused.
    spare: Vec<Vec<(usize, f64)>>,
}

impl LoadMeter {
    /// For a number of pairs.
    pub fn new(pairs: usize) -> Self {
        let largest = Loads { contact_force: 0.0, force: 0.0, torque: 0.0 };
        Self { largest, steps: VecDeque::new(), elapsed: 0.0, impulses: vec![0.0; pairs], spare: Vec::new() }
    }

    /// Adds a step: its duration (s), the normal impulse (Ns) of every pair, whose force is constant within the step,
    /// and the controller's wrench after it. Returns whether the contact force is larger than ever before.
    pub fn add(&mut self, duration: f64, impulses: &[f64], wrench: &Wrench) -> bool {
        let mut pushing = self.spare.pop().unwrap_or_default();
        pushing.extend(impulses.iter().copied().enumerate().filter(|(_, impulse)| *impulse != 0.0));
        for (pair, impulse) in &pushing {
            self.impulses[*pair] += impulse;
        }
        self.elapsed += duration;
        self.steps.push_back((duration, pushing));
        while let Some((first, _)) = self.steps.front()
            && self.elapsed - first >= FORCE_WINDOW * (1.0 - ROUNDING)
        {
            self.forget_first();
        }
        let mean = self.mean();
        let is_largest = mean > self.largest.contact_force;
        self.largest.contact_force = larger(self.largest.contact_force, mean);
        let largest =
            |part: &[f64], before: f64| part.iter().fold(before, |most, component| larger(most, component.abs()));
        self.largest.force = largest(&wrench[..3], self.largest.force);
        self.largest.torque = largest(&wrench[3..], self.largest.torque);
        is_largest
    }

    fn forget_first(&mut self) {
        let Some((duration, mut pushing)) = self.steps.pop_front() else { return };
        self.elapsed -= duration;
        for (pair, impulse) in pushing.drain(..) {
            self.impulses[pair] -= impulse;
        }
        self.spare.push(pushing);
    }

    /// Largest mean force (N) over the last 10 ms of the pairs that push now: that of other pairs was larger before.
    /// Before the motion there were no forces.
    fn mean(&self) -> f64 {
        let (Some((duration, first)), Some((_, last))) = (self.steps.front(), self.steps.back()) else { return 0.0 };
        let before = (self.elapsed - FORCE_WINDOW).max(0.0) / duration;
        let mean = |pair: usize| {
            let earlier: f64 = first.iter().filter(|(of, _)| *of == pair).map(|(_, impulse)| before * impulse).sum();
            (self.impulses[pair] - earlier) / FORCE_WINDOW
        };
        last.iter().map(|(pair, _)| mean(*pair)).fold(0.0, larger)
    }

    /// The largest loads of all steps.
    pub fn largest(&self) -> Loads {
        self.largest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STILL: Wrench = Wrench::ZERO;

    #[test]
    fn a_constant_force_is_its_own_mean_for_any_steps() {
        for durations in [vec![0.001; 40], vec![0.003; 14], vec![0.064], vec![0.004, 0.016, 0.05]] {
            let mut meter = LoadMeter::new(2);
            for duration in durations {
                meter.add(duration, &[0.0, 7.0 * duration], &STILL);
            }
            assert!((meter.largest().contact_force - 7.0).abs() < 1e-9);
        }
    }

    #[test]
    fn an_impact_counts_by_its_impulse() {
        let mut meter = LoadMeter::new(1);
        for step in 0..20 {
            let is_largest = meter.add(0.001, &[if step == 13 { 0.6 } else { 0.0 }], &STILL);
            assert_eq!(is_largest, step == 13);
        }
        assert!((meter.largest().contact_force - 60.0).abs() < 1e-9);
    }

    #[test]
    fn every_excess_counts() {
        let mut meter = LoadMeter::new(0);
        meter.add(0.001, &[], &Wrench([1.0, -30.0, 2.0, 0.1, 0.2, -0.3]));
        let loads = meter.largest();
        assert_eq!(loads, Loads { contact_force: 0.0, force: 30.0, torque: 0.3 });
        let limits = Limits { force: 20.0, torque: 0.2, ..Limits::NONE };
        assert!((loads.excess(&limits) - 1.0).abs() < 1e-12);
        assert_eq!(loads.excess(&Limits::NONE), 0.0);
    }
}

//! Torques that a controller commands at its samples, and that hold until the next ones come.

use std::collections::VecDeque;

use robot::JointVector;

/// Sample, delay and hold.
#[derive(Debug, Clone)]
pub struct SampledController {
    /// Time between samples (s).
    period: f64,
    /// From a sample to its torques (s).
    delay: f64,
    samples: usize,
    /// When torques come (s), and those that have not come yet.
    commands: VecDeque<(f64, JointVector)>,
    torque: JointVector,
}

/// Events that are this much (s) later than a time happen at it: rounding.
const ROUNDING: f64 = 1e-9;

impl SampledController {
    /// The first sample is at time zero; until its torques come, there are none.
    pub fn new(period: f64, delay: f64) -> Self {
        let waiting = (delay / period) as usize + 2;
        let commands = VecDeque::with_capacity(waiting);
        Self { period, delay, samples: 0, commands, torque: JointVector::zeros() }
    }

    /// Mean torques (Nm or N) over a step from a time (s) on, of a length (s); times do not decrease. Calls `command` if a
    /// sample is due.
    pub fn torque(&mut self, time: f64, length: f64, command: impl FnOnce() -> JointVector) -> JointVector {
        if self.samples as f64 * self.period <= time + ROUNDING {
            self.samples += 1;
            self.commands.push_back((time + self.delay, command()));
        }
        while self.commands.front().is_some_and(|(from, _)| *from <= time + ROUNDING) {
            self.next();
        }
        // Torques that come within the step act for the rest of it.
        let mut mean = self.torque;
        while let Some((from, torque)) = self.commands.front()
            && *from < time + length - ROUNDING
        {
            mean += (torque - self.torque) * ((time + length - from) / length);
            self.next();
        }
        mean
    }

    /// Goes on at a time (s) with torques (Nm or N) that have held for the delay.
    pub fn restart(&mut self, time: f64, torque: JointVector) {
        self.samples = (time / self.period - ROUNDING).ceil() as usize;
        self.commands.clear();
        self.torque = torque;
    }

    /// The oldest torques that wait become those that hold.
    fn next(&mut self) {
        self.torque = self.commands.pop_front().map_or(self.torque, |(_, torque)| torque);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The time (ms) of the sample that counts in each step of 1 ms, as a mean; -1000 before the first one has come.
    fn samples(period: f64, delay: f64) -> Vec<f64> {
        let mut controller = SampledController::new(period, delay);
        let time = |step: usize| 1e-3 * step as f64;
        let torque = |step| controller.torque(time(step), 1e-3, || JointVector::repeat(1.0 + time(step)))[0];
        (0..8).map(torque).map(|torque| ((torque - 1.0) * 1e4).round() / 10.0).collect()
    }

    #[test]
    fn torques_hold_for_a_period_and_come_late() {
        assert_eq!(samples(2e-3, 0.0), [0.0, 0.0, 2.0, 2.0, 4.0, 4.0, 6.0, 6.0]);
        assert_eq!(samples(2e-3, 3e-3), [-1000.0, -1000.0, -1000.0, 0.0, 0.0, 2.0, 2.0, 4.0]);
        assert_eq!(samples(1e-3, 2.5e-3), [-1000.0, -1000.0, -500.0, 0.5, 1.5, 2.5, 3.5, 4.5]);
    }
}

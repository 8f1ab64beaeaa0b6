//! Torques that a controller commands at its samples, each held until the next arrive.

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
    /// Times (s) at which torques take effect, and those that are still delayed.
    commands: VecDeque<(f64, JointVector)>,
    torque: JointVector,
}

/// Events that are this much (s) later than a time happen at it: rounding.
const ROUNDING: f64 = 1e-9;

impl SampledController {
    /// The first sample is at time zero; there are no torques before its own take effect.
    pub fn new(period: f64, delay: f64) -> Self {
        let waiting = (delay / period) as usize + 2;
        let commands = VecDeque::with_capacity(waiting);
        Self { period, delay, samples: 0, commands, torque: JointVector::zeros() }
    }

    /// Mean torques (Nm or N) over a step that begins at a time (s) and has a length (s); times do not decrease. Calls
    /// `command` if a sample is due.
    pub fn torque(&mut self, time: f64, length: f64, command: impl FnOnce() -> JointVector) -> JointVector {
        if self.samples as f64 * self.period <= time + ROUNDING {
            self.samples += 1;
            self.commands.push_back((time + self.delay, command()));
        }
        while self.commands.front().is_some_and(|(from, _)| *from <= time + ROUNDING) {
            self.next();
        }
        // Torques that arrive within the step act for the rest of it.
        let mut mean = self.torque;
        while let Some((from, torque)) = self.commands.front()
            && *from < time + length - ROUNDING
        {
            mean += (torque - self.torque) * ((time + length - from) / length);
            self.next();
        }
        mean
    }

    /// Continues at a time (s) with torques (Nm or N) that have held for the delay.
    pub fn restart(&mut self, time: f64, torque: JointVector) {
        self.samples = (time / self.period - ROUNDING).ceil() as usize;
        self.commands.clear();
        self.torque = torque;
    }

    /// The oldest delayed torques take effect.
    fn next(&mut self) {
        self.torque = self.commands.pop_front().map_or(self.torque, |(_, torque)| torque);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean sample time (ms) of the torques in each step of 1 ms; -1000 before the first ones.
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

//! How the robot follows commanded poses.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use nalgebra::{Isometry3, Vector3};
use task::pose::moved;

use crate::contact_loop::CRITICAL_BANDWIDTH;
use crate::motion::Motion;

/// Commands that arrive this much (s) later than a time arrive at it: rounding.
const ROUNDING: f64 = 1e-9;

/// A delay, and a critically damped lag of the second order.
#[derive(Debug, Clone)]
pub struct Servo {
    /// Natural frequency (rad/s).
    rate: f64,
    delay: f64,
    motion: Motion,
    command: Isometry3<f64>,
    /// Times (s) at which commands arrive, and those that have not.
    commands: VecDeque<(f64, Isometry3<f64>)>,
}

impl Servo {
    /// At rest at a pose, with a bandwidth (Hz, 3 dB) and a delay (s).
    pub fn new(bandwidth: f64, delay: f64, start: Isometry3<f64>) -> Self {
        let rate = TAU * bandwidth / CRITICAL_BANDWIDTH;
        Self { rate, delay, motion: Motion::at_rest(start), command: start, commands: VecDeque::new() }
    }

    /// The flange, in the frame that the commands have.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Sends a command at a time (s).
    pub fn send(&mut self, time: f64, command: Isometry3<f64>) {
        self.commands.push_back((time + self.delay, command));
    }

    /// Moves from a time on for a step (s), always towards the last command that has arrived.
    pub fn advance(&mut self, time: f64, step: f64) {
        let (mut now, end) = (time, time + step);
        while let Some(&(arrival, command)) = self.commands.front()
            && arrival < end - ROUNDING
        {
            if arrival > now + ROUNDING {
                self.follow(arrival - now);
                now = arrival;
            }
            self.command = command;
            self.commands.pop_front();
        }
        // The whole step where nothing has arrived in it, without rounding.
        self.follow(if now == time { step } else { end - now });
    }

    /// Moves for a time (s) towards the command.
    fn follow(&mut self, step: f64) {
        let Self { rate, motion, command, .. } = self;
        let shift = command.translation.vector - motion.pose.translation.vector;
        let rotation = (motion.pose.rotation.inverse() * command.rotation).scaled_axis();
        let (shift, velocity) = approach(*rate, step, shift, motion.velocity);
        let (rotation, angular_velocity) = approach(*rate, step, rotation, motion.angular_velocity);
        *motion = Motion { pose: moved(&motion.pose, &shift, &rotation), velocity, angular_velocity };
    }
}

/// Motion in a step (s) towards a command that is `ahead`, exact for one axis, and the velocity after it.
fn approach(rate: f64, step: f64, ahead: Vector3<f64>, velocity: Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let drift = velocity - ahead * rate;
    let decay = (-rate * step).exp();
    let left = (drift * step - ahead) * decay;
    (ahead + left, (drift * (1.0 - rate * step) + ahead * rate) * decay)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_at_the_bandwidth_is_smaller_by_3_db() {
        let (bandwidth, step) = (10.0, 1e-4);
        let mut servo = Servo::new(bandwidth, 0.0, Isometry3::identity());
        let mut largest: f64 = 0.0;
        for index in 0..20_000 {
            let time = f64::from(index) * step;
            servo.send(time, Isometry3::translation((TAU * bandwidth * time).sin(), 0.0, 0.0));
            servo.advance(time, step);
            if time > 1.0 {
                largest = largest.max(servo.motion().pose.translation.x);
            }
        }
        assert!((largest - 0.5_f64.sqrt()).abs() < 1e-3, "{largest}");
    }

    #[test]
    fn commands_that_arrive_within_a_step_act_from_then_on() {
        let end = |step: f64| {
            let mut servo = Servo::new(5.0, 0.0137, Isometry3::identity());
            let count = (0.06 / step).round() as i32;
            for index in 0..count {
                let time = f64::from(index) * step;
                if index == 0 {
                    servo.send(time, Isometry3::translation(0.01, 0.0, 0.0));
                    servo.send(time + 0.0041, Isometry3::translation(0.02, 0.0, 0.0));
                }
                servo.advance(time, step);
            }
            servo.motion().pose.translation.x
        };
        assert!((end(0.01) - end(0.0001)).abs() < 1e-12, "{} {}", end(0.01), end(0.0001));
    }

    #[test]
    fn steps_add_up_and_commands_arrive_late() {
        let goal = Isometry3::new(Vector3::new(0.01, 0.0, 0.0), Vector3::new(0.0, 0.3, 0.0));
        let end = |step: f64| {
            let mut servo = Servo::new(5.0, 0.02, Isometry3::identity());
            servo.send(0.0, goal);
            let count = (0.06 / step).round() as i32;
            for index in 0..count {
                servo.advance(f64::from(index) * step, step);
                let time = f64::from(index + 1) * step;
                assert_eq!(servo.motion().velocity.x > 0.0, time > 0.02 + ROUNDING, "{time}");
            }
            *servo.motion()
        };
        let (coarse, fine) = (end(0.01), end(0.001));
        assert!((coarse.pose.translation.x - fine.pose.translation.x).abs() < 1e-12);
        assert!((coarse.velocity - fine.velocity).norm() < 1e-12);
        assert!(coarse.pose.rotation.angle_to(&fine.pose.rotation) < 1e-9);
    }
}

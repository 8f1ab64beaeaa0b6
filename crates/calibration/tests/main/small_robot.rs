//! A robot that is commanded by position or force in free air, axis by axis and in small steps: written after the manuals of the
//! laws, without the crate `admittance`.

use std::f64::consts::TAU;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use simulation::Reference;

/// A critically damped servo is 3 dB down at this frequency, in its natural frequency: the root of `sqrt(2) - 1`.
pub const CRITICAL: f64 = 0.643_594_252_9;
/// Steps of the servo in a period.
const STEPS: usize = 200;

/// How the law is computed.
#[derive(Clone, Copy)]
pub enum Law {
    /// By the player of corrections, around its own commands.
    Correction,
    /// By `admittance_controller` of ros2_controllers.
    Controller,
    /// By a force mode with these gains (m/s per N, rad/s per Nm), which gets a spring and what moves it with the reference.
    ForceMode([f64; 2]),
}

/// The robot and its law; pairs are for translations and rotations.
#[derive(Clone, Copy)]
pub struct SmallRobot {
    pub law: Law,
    /// Time between two samples (s).
    pub period: f64,
    pub mass: [f64; 2],
    pub damping: [f64; 2],
    pub stiffness: [f64; 2],
    /// Of the servo (Hz), and delay of its commands (s).
    pub bandwidth: f64,
    pub delay: f64,
    /// Error of the measured force (N) and torque (Nm).
    pub bias: [f64; 6],
}

impl SmallRobot {
    /// Time (s) by which it follows slow motions.
    pub fn lag(&self) -> f64 {
        self.delay + 2.0 * CRITICAL / (TAU * self.bandwidth)
    }

    /// Where it is at each knot of a reference, one for each period, that turns about one axis at a time.
    pub fn play(&self, reference: &Reference) -> Vec<Isometry3<f64>> {
        let home = reference.start().isometry();
        let states = reference.states();
        let of_axis = |axis: usize| -> Vec<f64> {
            let way = |knot: usize| {
                let pose = home.inverse() * states[knot].pose().isometry();
                if axis < 3 { pose.translation.vector[axis] } else { pose.rotation.scaled_axis()[axis - 3] }
            };
            // The velocity of a knot leads to it.
            let speed = |knot: usize| states.get(knot + 1).map_or(0.0, |next| next.twist()[axis]);
            let followed: Vec<(f64, f64)> = (0..states.len()).map(|knot| (way(knot), speed(knot))).collect();
            self.play_axis(axis, &followed)
        };
        let axes: Vec<Vec<f64>> = (0..6).map(of_axis).collect();
        let pose = |knot: usize| {
            let [shift, turn] = [0, 3].map(|first| Vector3::from_fn(|row, _| axes[first + row][knot]));
            home * Isometry3::from_parts(Translation3::from(shift), UnitQuaternion::from_scaled_axis(turn))
        };
        (0..states.len()).map(pose).collect()
    }

    /// One axis: the position at each knot of a reference (position, velocity).
    fn play_axis(&self, axis: usize, reference: &[(f64, f64)]) -> Vec<f64> {
        let (part, period, load) = (axis / 3, self.period, self.bias[axis]);
        let (mass, damping, stiffness) = (self.mass[part], self.damping[part], self.stiffness[part]);
        let (rate, step) = (TAU * self.bandwidth / CRITICAL, period / STEPS as f64);
        let (mut position, mut velocity) = (0.0, 0.0);
        // The law's own position or deviation, and its rate.
        let (mut own, mut speed, mut before) = (0.0, 0.0, reference[0].0);
        let mut commands: Vec<(f64, f64)> = Vec::new();
        let mut positions = Vec::new();
        for (knot, &(wanted, wanted_speed)) in reference.iter().enumerate() {
            positions.push(position);
            let command = match self.law {
                Law::Correction => {
                    let slope = (wanted - before) / period;
                    let force = damping * slope + stiffness * (before - own + period * slope) + load;
                    speed = (mass * speed + period * force) / (mass + period * damping + period * period * stiffness);
                    own += period * speed;
                    own
                }
                Law::Controller => {
                    speed += period * (load - damping * speed - stiffness * (position - wanted)) / mass;
                    own += period * speed;
                    wanted + own
                }
                Law::ForceMode(gain) => {
                    let wrench = stiffness * (wanted - position) + damping * wanted_speed;
                    let (damping, mass) = (1.0 / gain[part], period / gain[part]);
                    speed = (mass * speed + period * (wrench + load)) / (mass + period * damping);
                    own += period * speed;
                    own
                }
            };
            before = wanted;
            let now = knot as f64 * period;
            commands.push((now + self.delay, command));
            for index in 0..STEPS {
                let time = now + index as f64 * step;
                let arrived = commands.iter().rev().take(50).find(|(arrival, _)| *arrival <= time + 1e-9);
                let ahead = arrived.map_or(0.0, |(_, command)| *command) - position;
                velocity += step * (rate * rate * ahead - 2.0 * rate * velocity);
                position += step * velocity;
            }
        }
        positions
    }
}

//! The loop that closes where the part touches: the robot moves, the contact pushes back, the law moves the robot.

use std::f64::consts::{PI, TAU};

use crate::gains::Gains;

/// Largest sensitivity `max |1 / (1 + L)|` of a loop `L` that counts as stable with a margin: a gain margin of 2 and a phase
/// margin of 29 degrees, as usual in control.
pub const LARGEST_SENSITIVITY: f64 = 2.0;
/// Times of the law's period in which its mass follows a force: explicit integration of the law, as in controllers of others,
/// is stable from half of a period on.
const PERIODS_OF_MASS: f64 = 2.0;
/// A critically damped lag of the natural frequency 1 is 3 dB down at this frequency.
pub(crate) const CRITICAL_BANDWIDTH: f64 = 0.643_594_252_905_583;
/// Frequencies at which a loop is checked, spread evenly by their logarithm down from the Nyquist frequency.
const FREQUENCIES: usize = 400;
const DECADES: f64 = 5.0;
/// Contacts that are softer than the stiffest by these factors are checked too.
const SOFTER: [f64; 4] = [1.0, 0.3, 0.1, 0.01];
/// Dampings (Ns/m) that are tried.
const DAMPINGS: [f64; 2] = [1e-2, 1e7];
const BISECTIONS: usize = 60;

/// Lags, delays and stiffness of the loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLoop {
    /// Time between two samples (s).
    pub period: f64,
    /// From a sample to the first motion that it causes (s).
    pub delay: f64,
    /// Bandwidth of the servo (Hz), a critically damped lag of the second order.
    pub bandwidth: f64,
    /// Cutoff frequency of the sensor (Hz), a lag of the first order.
    pub cutoff: f64,
    /// Stiffness of the contact (N/m).
    pub contact_stiffness: f64,
    /// Distance of the contact from the centre of rotations (m).
    pub lever: f64,
}

impl ContactLoop {
    /// Time (s) by which the motion follows the wrench at low frequencies: half a period of sampling and half of holding, delay,
    /// servo and filter.
    pub fn lag(&self) -> f64 {
        self.dead_time() + 2.0 / self.servo_rate() + 1.0 / self.filter_rate()
    }

    /// Damping and mass that are stable with the required margin beside these stiffnesses (N/m, Nm/rad), with the least damping.
    /// Rotations get the damping and the mass of translations at the lever, so that each yields half of the motion of a contact
    /// there. `None` where no damping suffices.
    pub fn gains(&self, stiffness: [f64; 2]) -> Option<Gains> {
        let rotations = self.lever * self.lever;
        let with = |damping: f64| {
            let mass = damping * PERIODS_OF_MASS * self.period;
            Gains { mass: [mass, mass * rotations], damping: [damping, damping * rotations], stiffness }
        };
        let is_stable = |damping: f64| self.sensitivity(&with(damping)) <= LARGEST_SENSITIVITY;
        let [mut low, mut high] = DAMPINGS;
        if !is_stable(high) {
            return None;
        }
        for _ in 0..BISECTIONS {
            let middle = (low * high).sqrt();
            if is_stable(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(with(high))
    }

    /// The largest sensitivity of the loop at any frequency and any contact up to the stiffest; infinite if a loop is unstable.
    pub fn sensitivity(&self, gains: &Gains) -> f64 {
        self.in_contact(gains, false)
    }

    /// The same for a law whose spring acts on the measured pose, not on the commanded one: it closes loops through the servo,
    /// of translations and of rotations, also where nothing touches.
    pub fn sensitivity_with_measured_spring(&self, gains: &Gains) -> f64 {
        let free = [0, 1].map(|part| worst(self.period, |frequency| self.spring_response(gains, part, frequency)));
        largest([largest(free), self.in_contact(gains, true)])
    }

    fn in_contact(&self, gains: &Gains, is_measured: bool) -> f64 {
        largest(SOFTER.map(|share| {
            let stiffness = share * self.contact_stiffness;
            worst(self.period, |frequency| self.response(gains, stiffness, is_measured, frequency))
        }))
    }

    /// Gain and phase (rad, continuous from low frequencies on) of the loop of a contact at a frequency (rad/s). Springs that act
    /// on the measured pose are as late as that.
    fn response(&self, gains: &Gains, stiffness: f64, is_measured: bool, frequency: f64) -> (f64, f64) {
        let (servo, filter) = (frequency / self.servo_rate(), frequency / self.filter_rate());
        let late = if is_measured { frequency * self.dead_time() + 2.0 * servo.atan() } else { 0.0 };
        let passed = if is_measured { 1.0 / (1.0 + servo * servo) } else { 1.0 };
        // Motion of the contact point under a force there, as real and imaginary part: translation and rotation add up.
        let [translation, rotation] = [0, 1].map(|part| {
            let spring = gains.stiffness[part] * passed;
            let real = spring * late.cos() - gains.mass[part] * frequency * frequency;
            let imaginary = gains.damping[part] * frequency - spring * late.sin();
            let squared = real * real + imaginary * imaginary;
            (real / squared, -imaginary / squared)
        });
        let lever = self.lever * self.lever;
        let (real, imaginary) = (translation.0 + lever * rotation.0, translation.1 + lever * rotation.1);
        let gain = stiffness * real.hypot(imaginary) / (1.0 + servo * servo) / filter.hypot(1.0);
        // A compliance answers with a phase of 0 to -180 degrees, with late springs of somewhat less.
        let answer = imaginary.atan2(real);
        let answer = if answer > 0.5 * PI { answer - TAU } else { answer };
        let phase = answer - frequency * self.dead_time() - 2.0 * servo.atan() - filter.atan();
        (gain, phase)
    }

    /// Gain and phase of the loop that a spring closes which acts on the measured pose.
    fn spring_response(&self, gains: &Gains, part: usize, frequency: f64) -> (f64, f64) {
        let (mass, damping) = (gains.mass[part] * frequency, gains.damping[part]);
        let servo = frequency / self.servo_rate();
        let gain = gains.stiffness[part] / (frequency * damping.hypot(mass)) / (1.0 + servo * servo);
        (gain, -0.5 * PI - mass.atan2(damping) - frequency * self.dead_time() - 2.0 * servo.atan())
    }

    fn dead_time(&self) -> f64 {
        self.delay + self.period
    }

    /// Natural frequency of the servo (rad/s).
    fn servo_rate(&self) -> f64 {
        TAU * self.bandwidth / CRITICAL_BANDWIDTH
    }

    fn filter_rate(&self) -> f64 {
        TAU * self.cutoff
    }
}

/// The largest sensitivity of a loop that is sampled with a period (s), given its gain and phase (rad, continuous) at a frequency
/// (rad/s); infinite if it is unstable. A loop whose gain is below 1 wherever its phase is beyond -180 degrees does not encircle
/// the critical point.
fn worst(period: f64, response: impl Fn(f64) -> (f64, f64)) -> f64 {
    let highest = PI / period;
    let mut worst: f64 = 0.0;
    for index in 0..FREQUENCIES {
        let (gain, phase) = response(highest * 10f64.powf(-DECADES * index as f64 / FREQUENCIES as f64));
        let distance = (1.0 + 2.0 * gain * phase.cos() + gain * gain).sqrt();
        let is_stable = phase > -PI || gain < 1.0;
        if !is_stable || !(distance > 0.0) {
            return f64::INFINITY;
        }
        worst = worst.max(1.0 / distance);
    }
    worst
}

/// The largest of some sensitivities; one that is no number is the largest.
fn largest<const N: usize>(sensitivities: [f64; N]) -> f64 {
    sensitivities.into_iter().fold(0.0, |worst, next| if next <= worst { worst } else { next })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOOP: ContactLoop =
        ContactLoop { period: 0.002, delay: 0.004, bandwidth: 20.0, cutoff: 50.0, contact_stiffness: 1e5, lever: 0.05 };

    /// Simulates the loop of one axis with gains in discrete time, after a blow; the ratio of late to early peaks of the force.
    fn decay(of: &ContactLoop, gains: &Gains) -> f64 {
        let step = 1e-5;
        let rate = of.servo_rate();
        let (every, late) = ((of.period / step).round() as usize, (of.delay / step).round() as usize);
        let (mut law, mut speed, mut commands) = (1e-3, 0.0, std::collections::VecDeque::from(vec![1e-3; late]));
        let (mut position, mut velocity, mut held, mut filtered) = (1e-3, 0.0, 1e-3, 0.0);
        let (mut early, mut last): (f64, f64) = (0.0, 0.0);
        let steps = (100.0 * of.lag() / step) as usize;
        for index in 0..steps {
            filtered += step * of.filter_rate() * (-of.contact_stiffness * position - filtered);
            if index % every == 0 {
                // Rotations yield as much as translations.
                let (mass, damping) = (0.5 * gains.mass[0], 0.5 * gains.damping[0]);
                speed = (mass * speed + of.period * (filtered - 0.5 * gains.stiffness[0] * law))
                    / (mass + of.period * damping);
                law += of.period * speed;
                held = law;
            }
            commands.push_back(held);
            let command = commands.pop_front().unwrap_or(held);
            velocity += step * (rate * rate * (command - position) - 2.0 * rate * velocity);
            position += step * velocity;
            let part = if index < steps / 4 { &mut early } else { &mut last };
            if index < steps / 4 || index > 3 * steps / 4 {
                *part = part.max(filtered.abs());
            }
        }
        last / early
    }

    #[test]
    fn chosen_gains_decay_and_a_fraction_of_their_damping_does_not() {
        for (period, delay) in [(0.002, 0.004), (0.008, 0.02), (0.004, 0.03)] {
            for contact_stiffness in [1e4, 1e5, 1e6] {
                let of = ContactLoop { period, delay, contact_stiffness, ..LOOP };
                let stiffness = [1000.0, 1000.0 * of.lever * of.lever];
                let gains = of.gains(stiffness).unwrap();
                assert!(of.sensitivity(&gains) <= LARGEST_SENSITIVITY);
                assert!(decay(&of, &gains) < 0.2, "{of:?} {gains:?} {}", decay(&of, &gains));
                let weak = Gains { damping: gains.damping.map(|damping| 0.3 * damping), ..gains };
                assert_eq!(of.sensitivity(&weak), f64::INFINITY);
                assert!(!(decay(&of, &weak) < 1.0), "{of:?}");
            }
        }
    }

    #[test]
    fn damping_grows_with_stiffness_and_lag() {
        let damping = |of: ContactLoop| of.gains([1000.0, 2.5]).unwrap().damping[0];
        let usual = damping(LOOP);
        let stiffer = damping(ContactLoop { contact_stiffness: 1e6, ..LOOP });
        assert!((stiffer / usual - 10.0).abs() < 0.2, "{}", stiffer / usual);
        let later = ContactLoop { delay: 0.02, ..LOOP };
        assert!(damping(later) / usual > 0.8 * later.lag() / LOOP.lag());
    }

    /// The ratio of late to early deviations of one axis whose spring acts on the measured pose, in free air, in discrete time.
    fn decay_of_spring(of: &ContactLoop, mass: f64, damping: f64, stiffness: f64) -> f64 {
        let step = 1e-5;
        let rate = of.servo_rate();
        let (every, late) = ((of.period / step).round() as usize, (of.delay / step).round() as usize);
        let (mut law, mut speed, mut commands) = (1e-3, 0.0, std::collections::VecDeque::from(vec![1e-3; late]));
        let (mut position, mut velocity) = (1e-3, 0.0);
        let (mut early, mut last): (f64, f64) = (0.0, 0.0);
        let steps = (100.0 * of.lag() / step) as usize;
        for index in 0..steps {
            if index % every == 0 {
                speed += of.period * (-stiffness * position - damping * speed) / mass;
                law += of.period * speed;
            }
            commands.push_back(law);
            let command = commands.pop_front().unwrap_or(law);
            velocity += step * (rate * rate * (command - position) - 2.0 * rate * velocity);
            position += step * velocity;
            if index < steps / 4 {
                early = early.max(position.abs());
            } else if index > 3 * steps / 4 {
                last = last.max(position.abs());
            }
        }
        last / early
    }

    #[test]
    fn a_spring_on_the_measured_pose_needs_damping_for_its_lag() {
        let gains = LOOP.gains([1000.0, 2.5]).unwrap();
        // A soft spring makes nearly no difference.
        assert!(LOOP.sensitivity_with_measured_spring(&gains) < 1.1 * LOOP.sensitivity(&gains));
        // Of rotations with 0.25 of their damping over the lag, and with four times it.
        let lag = LOOP.dead_time() + 2.0 / LOOP.servo_rate();
        for (share, is_stable) in [(0.25, true), (4.0, false)] {
            let stiffness = share * gains.damping[1] / lag;
            let with = Gains { stiffness: [1000.0, stiffness], ..gains };
            assert_eq!(LOOP.sensitivity_with_measured_spring(&with) < 3.0, is_stable, "{share}");
            let decay = decay_of_spring(&LOOP, gains.mass[1], gains.damping[1], stiffness);
            assert_eq!(decay < 0.5, is_stable, "{share} {decay}");
        }
    }

    #[test]
    fn what_is_no_number_is_not_stable() {
        let gains = LOOP.gains([1000.0, 2.5]).unwrap();
        for of in [ContactLoop { delay: f64::NAN, ..LOOP }, ContactLoop { contact_stiffness: f64::NAN, ..LOOP }] {
            assert!(!(of.sensitivity(&gains) <= LARGEST_SENSITIVITY));
            assert!(!(of.sensitivity_with_measured_spring(&gains) <= LARGEST_SENSITIVITY));
            assert_eq!(of.gains([1000.0, 2.5]), None);
        }
    }
}

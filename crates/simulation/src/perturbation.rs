//! Smooth random perturbations of a reference motion.

use fastrand::Rng;
use nalgebra::Vector3;

use crate::overshoot::Overshoot;
use crate::success::Success;

/// Shifts and rotates a reference around one time, or from one time on. The start of the reference does not change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Perturbation {
    /// Time of the perturbation, as a fraction of the duration.
    center: f64,
    /// Width in time, as a fraction of the duration.
    width: f64,
    /// Whether the perturbation lasts until the end.
    lasting: bool,
    /// Largest shift (m, world frame).
    pub shift: Vector3<f64>,
    /// Largest rotation vector (rad, body frame).
    pub rotation: Vector3<f64>,
}

/// Smallest and largest width, as fractions of the duration.
const WIDTHS: [f64; 2] = [0.04, 0.34];
/// Last part of the duration, in which late perturbations lie.
const LATE: f64 = 0.25;
/// Fraction of perturbations that last.
const LASTING: f64 = 0.2;
/// Standard deviation of the logarithm of the size.
const SPREAD: f64 = 0.8;
/// Typical rotation as a multiple of the orientation tolerance. It is small because rotations act through levers.
const ROTATION: f64 = 0.3;
/// Longest time by which a relief precedes the largest force, as a fraction of the duration.
const EARLIER: f64 = 0.05;
/// Width of the interval of time, as a fraction of the duration, in which varied perturbations lie.
const LATER: f64 = 0.1;
/// Fraction of another perturbation that is added to a varied one.
const MIXED: f64 = 0.3;
/// Sideways error of aimed perturbations, as a multiple of the distance ahead: up to 30 degrees.
const ASTRAY: f64 = 0.5;
/// Multiples of the width before and after the center at which a passing perturbation begins and ends, and at which a
/// lasting one begins and is complete.
const PASSING_ENDS: f64 = 2.5;
const LASTING_ENDS: f64 = 1.0;
/// Fraction of the duration over which a perturbation fades in, so that the start does not change.
const FADE: f64 = 0.05;

impl Perturbation {
    /// A random shift, rotation or both, of about the size of the tolerances of success.
    pub fn random(random: &mut Rng, success: &Success) -> Self {
        let [least, most] = WIDTHS;
        let (center, width) = (1.1 * random.f64(), least + (most - least) * random.f64() * random.f64());
        let lasting = random.f64() < LASTING;
        let kind = random.usize(..3);
        let mut vector = |typical: f64, wanted: bool| {
            let size = typical * (SPREAD * normal(random)).exp();
            let direction = Vector3::from_fn(|_, _| normal(random));
            if wanted { direction * size } else { Vector3::zeros() }
        };
        let shift = vector(success.position, kind != 1);
        let rotation = vector(ROTATION * success.orientation, kind != 0);
        Self { center, width, lasting, shift, rotation }
    }

    /// A random shift or rotation that comes and goes shortly before the end.
    pub fn late(random: &mut Rng, success: &Success) -> Self {
        let [least, _] = WIDTHS;
        let (center, width) = (1.0 - LATE * random.f64(), least * (1.0 + random.f64()));
        Self { center, width, lasting: false, ..Self::random(random, success) }
    }

    /// A perturbation at about the same time and in about the same direction, of another size, plus a part of `other`.
    pub fn varied(&self, other: &Self, random: &mut Rng) -> Self {
        let size = (SPREAD * normal(random)).exp();
        Self {
            center: self.center + LATER * (random.f64() - 0.5),
            shift: self.shift * size + other.shift * MIXED,
            rotation: self.rotation * size + other.rotation * MIXED,
            ..*self
        }
    }

    /// A perturbation with the same course in time, towards a shift (m, world frame) and a rotation (rad, body frame)
    /// that a body lacks. Its size is between its own and twice the lack.
    pub fn aimed(&self, shift: &Vector3<f64>, rotation: &Vector3<f64>, random: &mut Rng) -> Self {
        let exponent = random.f64();
        let aim = |change: &Vector3<f64>, lacked: &Vector3<f64>| {
            let (size, most) = (change.norm(), 2.0 * lacked.norm());
            if size == 0.0 || most == 0.0 {
                return *change;
            }
            let direction = (lacked.normalize() + change * (ASTRAY / size)).normalize();
            direction * size * (most / size).max(1.0).powf(exponent)
        };
        Self { shift: aim(&self.shift, shift), rotation: aim(&self.rotation, rotation), ..*self }
    }

    /// A perturbation that takes back about the overshoot, at its time or a little earlier.
    pub fn relief(random: &mut Rng, overshoot: &Overshoot) -> Self {
        let [least, most] = WIDTHS;
        let center = overshoot.fraction.min(1.0) - EARLIER * random.f64();
        let width = least + (most - least) * random.f64() * random.f64();
        let size = (SPREAD * normal(random)).exp();
        let kind = random.usize(..3);
        let part = |vector: Vector3<f64>, wanted: bool| if wanted { vector * size } else { Vector3::zeros() };
        let (shift, rotation) = (part(overshoot.shift, kind != 1), part(overshoot.rotation, kind != 0));
        Self { center, width, lasting: false, shift, rotation }
    }

    /// The same perturbation times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        Self { shift: self.shift * factor, rotation: self.rotation * factor, ..*self }
    }

    /// Fraction of the perturbation that applies at a fraction of the duration.
    pub fn weight(&self, fraction: f64) -> f64 {
        let distance = (fraction - self.center) / self.width;
        let shape = if self.lasting {
            let part = (0.5 + 0.5 * distance / LASTING_ENDS).clamp(0.0, 1.0);
            part * part * (3.0 - 2.0 * part)
        } else {
            // Nearly a normal distribution, but of bounded support: what was before need not be simulated again.
            (1.0 - (distance / PASSING_ENDS).powi(2)).max(0.0).powi(3)
        };
        (fraction / FADE).min(1.0) * shape
    }
}

/// Standard normal value (Box and Muller).
fn normal(random: &mut Rng) -> f64 {
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (std::f64::consts::TAU * random.f64()).cos()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reliefs_lead_back_from_where_the_force_is_largest() {
        let mut random = Rng::with_seed(1);
        let overshoot =
            Overshoot { fraction: 0.6, shift: Vector3::new(0.0, 0.0, 0.004), rotation: Vector3::new(0.03, 0.0, 0.0) };
        for _ in 0..100 {
            let relief = Perturbation::relief(&mut random, &overshoot);
            let parts =
                [relief.shift.norm() / overshoot.shift.norm(), relief.rotation.norm() / overshoot.rotation.norm()];
            assert!(parts.iter().any(|part| *part > 0.05) && parts.iter().all(|part| *part < 20.0), "{parts:?}");
            for (change, wanted) in [(relief.shift, overshoot.shift), (relief.rotation, overshoot.rotation)] {
                assert!((change.dot(&wanted) - change.norm() * wanted.norm()).abs() < 1e-12, "the same direction");
            }
            assert!(relief.weight(0.575) > 0.7 && relief.weight(1.7) < 0.1, "around that time, and only for a while");
        }
    }

    #[test]
    fn aimed_changes_lead_where_a_body_lacks_something() {
        let mut random = Rng::with_seed(1);
        let (shift, rotation) = (Vector3::new(0.0, 0.0, -0.03), Vector3::new(0.2, 0.0, 0.0));
        let mut is_larger = 0;
        for _ in 0..100 {
            let any = Perturbation::random(&mut random, &Success::default());
            let aimed = any.aimed(&shift, &rotation, &mut random);
            assert_eq!(aimed.weight(0.7), any.weight(0.7));
            for (any, aimed, lacked) in [(any.shift, aimed.shift, shift), (any.rotation, aimed.rotation, rotation)] {
                if any.norm() == 0.0 {
                    assert_eq!(aimed, any, "a perturbation without shift or rotation remains one");
                    continue;
                }
                assert!(aimed.angle(&lacked) < 0.53, "30 degrees at most");
                let (least, most) = (any.norm(), any.norm().max(2.0 * lacked.norm()));
                assert!((0.999 * least..=1.001 * most).contains(&aimed.norm()), "{any} {aimed}");
                is_larger += usize::from(aimed.norm() > 1.5 * any.norm());
            }
        }
        assert!(is_larger > 30, "{is_larger}");
        let any = Perturbation::random(&mut random, &Success::default());
        assert_eq!(any.aimed(&Vector3::zeros(), &Vector3::zeros(), &mut random), any, "nothing is lacking");
    }
}
